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
  #rows = 1;
  /** The used part of the array, and of the one before it: where two take turns, no view is made. */
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
   * Uploads the first `used` texels of `data`, to every renderer that already draws with this texture; others take the
   * whole array when they first do.
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

  /** Says that another array has the values of the last `upload`; it is what a renderer that comes anew is sent. */
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
