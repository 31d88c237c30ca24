import { TEXTURE_WIDTH, textureRows } from '@principia/render-core';
import {
  DataTexture,
  FloatType,
  type PixelFormat,
  RedFormat,
  RedIntegerFormat,
  RGBAIntegerFormat,
  type TextureDataType,
  UnsignedIntType,
} from 'three';

/** What a texel of a column texture holds. */
export type TexelKind = 'real' | 'uint' | 'uint4';

/** Stands in until the first upload; a fetch outside a texture gives zero. */
const nothing = { real: new Float32Array(TEXTURE_WIDTH), uint: new Uint32Array(4 * TEXTURE_WIDTH) };

const formats: Record<TexelKind, { format: PixelFormat; type: TextureDataType; lanes: number }> = {
  real: { format: RedFormat, type: FloatType, lanes: 1 },
  uint: { format: RedIntegerFormat, type: UnsignedIntType, lanes: 1 },
  uint4: { format: RGBAIntegerFormat, type: UnsignedIntType, lanes: 4 },
};

/**
 * A data texture over an array that somebody else writes: nothing is copied on the CPU, and an upload sends only the
 * rows in use. Its height follows the use with some slack, because three's own partial texture updates take one GL
 * call per 1024 values.
 */
export class ColumnTexture {
  readonly texture: DataTexture;
  readonly #lanes: number;
  #used = 0;

  constructor(kind: TexelKind) {
    const { format, type, lanes } = formats[kind];
    this.#lanes = lanes;
    this.texture = new DataTexture(kind === 'real' ? nothing.real : nothing.uint, TEXTURE_WIDTH, 1, format, type);
    this.texture.needsUpdate = true;
  }

  /** Number of leading texels the GPU is up to date with after the next frame. */
  get used(): number {
    return this.#used;
  }

  /**
   * Sends the array to the GPU with the next frame.
   *
   * @param data one or four values a texel, a whole number of rows
   * @param used number of leading texels that matter
   * @throws Error when `data` is not a whole number of rows
   */
  upload(data: Float32Array | Uint32Array, used: number): void {
    const { image } = this.texture;
    const rows = textureRows(used, image.height, data.length / this.#lanes);
    if (rows !== image.height) {
      // The GPU's storage cannot change its size: let go of it, the next frame makes a new one.
      this.texture.dispose();
      image.height = rows;
    }
    image.data = data;
    this.#used = used;
    this.texture.needsUpdate = true;
  }

  /** Frees the GPU's copy. */
  dispose(): void {
    this.texture.dispose();
  }
}
