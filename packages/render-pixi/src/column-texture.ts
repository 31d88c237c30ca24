import { TEXTURE_WIDTH, textureRows } from '@principia/render-core';
import { BufferImageSource } from 'pixi.js';

type ColumnData = Float32Array | Uint32Array;

/**
 * A column of numbers as a data texture `TEXTURE_WIDTH` texels wide. It uses the column's memory without a copy. Its
 * height fits the rows in use, which limits the size of uploads.
 */
export class ColumnTexture {
  /** The source that a shader binds. */
  readonly source: BufferImageSource;
  readonly #channels: 1 | 4;
  #rows = 1;
  /**
   * Views of the used part of this array and of the previous one: where two arrays alternate, no new view is allocated.
   */
  #view: ColumnData;
  #otherView: ColumnData;

  /**
   * @param kind `real` for 32-bit floats, `whole` for unsigned 32-bit integers
   * @param channels numbers per texel
   */
  constructor(kind: 'real' | 'whole', channels: 1 | 4 = 1) {
    const length = TEXTURE_WIDTH * channels;
    this.#channels = channels;
    const zeros = kind === 'real' ? new Float32Array(length) : new Uint32Array(length);
    this.#view = this.#otherView = zeros;
    const real = channels === 1 ? 'r32float' : 'rgba32float';
    const whole = channels === 1 ? 'r32uint' : 'rgba32uint';
    this.source = new BufferImageSource({
      resource: zeros,
      width: TEXTURE_WIDTH,
      height: 1,
      format: kind === 'real' ? real : whole,
      alphaMode: 'no-premultiply-alpha',
      scaleMode: 'nearest',
      autoGarbageCollect: false,
    });
  }

  /**
   * Uploads the first `used` texels of `data` to every renderer that already uses this texture; other renderers upload
   * the whole array on first use.
   *
   * @param data the column; its length is a multiple of the texture's width
   */
  upload(data: ColumnData, used: number): void {
    const rows = textureRows(used, this.#rows, data.length / this.#channels);
    const fits = Math.min(rows, data.length / this.#channels / TEXTURE_WIDTH);
    this.#show(data, fits);
    if (fits !== this.#rows) {
      this.#rows = fits;
      if (this.source.resize(TEXTURE_WIDTH, fits)) return;
    }
    this.source.update();
  }

  /**
   * Replaces the array by another one with the values of the last `upload`, for renderers that use the texture later.
   */
  replaceColumn(data: ColumnData): void {
    this.#show(data, this.#rows);
  }

  #show(data: ColumnData, rows: number): void {
    const length = rows * TEXTURE_WIDTH * this.#channels;
    if (isView(this.#view, data, length)) return;
    const last = this.#view;
    this.#view = isView(this.#otherView, data, length) ? this.#otherView : data.subarray(0, length);
    this.#otherView = last;
    this.source.resource = this.#view;
  }

  destroy(): void {
    this.source.destroy();
  }
}

function isView(view: ColumnData, data: ColumnData, length: number): boolean {
  return view.buffer === data.buffer && view.byteOffset === data.byteOffset && view.length === length;
}
