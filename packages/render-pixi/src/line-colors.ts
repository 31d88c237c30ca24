import { bufferLength } from './buffer-capacity.ts';
import { ColumnTexture } from './column-texture.ts';

/** One colour per line as a texture; zero selects the layer's colour. */
export class LineColors {
  readonly texture = new ColumnTexture('whole');
  #values = new Uint32Array(0);
  #plain = true;

  /** Sets the first `count` of `colors` (RGBA bytes in memory order); undefined selects the layer's colour. */
  set(count: number, colors: ArrayLike<number> | undefined): void {
    const length = bufferLength(count, this.#values.length, 1);
    // Zeros that are already on the GPU need no second upload.
    if (colors === undefined && this.#plain && length === this.#values.length) return;
    if (length !== this.#values.length) this.#values = new Uint32Array(length);
    if (colors === undefined) this.#values.fill(0);
    else for (let i = 0; i < count; i++) this.#values[i] = colors[i];
    this.#plain = colors === undefined;
    this.texture.upload(this.#values, this.#plain ? length : count);
  }
}
