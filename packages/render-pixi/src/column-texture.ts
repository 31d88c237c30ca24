import { TEXTURE_WIDTH, textureRows } from '@principia/render-core';
import { BufferImageSource } from 'pixi.js';

type ColumnData = Float32Array | Uint32Array;

/**
 * A column of numbers as a data texture `TEXTURE_WIDTH` texels wide. Its memory is the column's own: nothing is copied
 * on the way to the graphics API. It is as high as the rows in use need, so an upload moves no more than that.
 */
export class ColumnTexture {
  /** What a shader binds. */
  readonly source: BufferImageSource;
  readonly #channels: 1 | 4;
  #data: ColumnData;
  #rows = 1;

  /**
   * @param kind `real` for 32-bit floats, `whole` for unsigned 32-bit integers
   * @param channels numbers per texel
   */
  constructor(kind: 'real' | 'whole', channels: 1 | 4 = 1) {
    const length = TEXTURE_WIDTH * channels;
    this.#channels = channels;
    this.#data = kind === 'real' ? new Float32Array(length) : new Uint32Array(length);
    const real = channels === 1 ? 'r32float' : 'rgba32float';
    const whole = channels === 1 ? 'r32uint' : 'rgba32uint';
    this.source = new BufferImageSource({
      resource: this.#data,
      width: TEXTURE_WIDTH,
      height: 1,
      format: kind === 'real' ? real : whole,
      alphaMode: 'no-premultiply-alpha',
      scaleMode: 'nearest',
      autoGarbageCollect: false,
    });
  }

  /**
   * Uploads the first `used` texels of `data`, to every renderer that already draws with this texture; others take the
   * whole array when they first do.
   *
   * @param data the column; its length is a multiple of the texture's width
   */
  upload(data: ColumnData, used: number): void {
    const rows = textureRows(used, data === this.#data ? this.#rows : 0, data.length / this.#channels);
    if (data === this.#data && rows === this.#rows) {
      this.source.update();
      return;
    }
    this.#data = data;
    this.#rows = rows;
    this.source.resource = data.subarray(0, rows * TEXTURE_WIDTH * this.#channels);
    if (!this.source.resize(TEXTURE_WIDTH, rows)) this.source.update();
  }

  destroy(): void {
    this.source.destroy();
  }
}
