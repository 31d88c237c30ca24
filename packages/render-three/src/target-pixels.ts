import { Vector2, type WebGLRenderer } from 'three';

/** What the shaders must know of the target they draw to: its height and whether its edges are multisampled. */
export class TargetPixels {
  /** Width and height, device pixels. Large until the first frame, so that nothing is taken for tiny. */
  readonly size = { value: new Vector2(1e9, 1e9) };
  readonly height = { value: 1e9 };
  /** 1 or 0. */
  readonly multisampled = { value: 0 };
  #renderer: WebGLRenderer | undefined;
  #canvasIsMultisampled = false;

  /** Reads the renderer's present target. Makes no garbage once a renderer is known. */
  read(renderer: WebGLRenderer): void {
    if (renderer !== this.#renderer) {
      this.#renderer = renderer;
      this.#canvasIsMultisampled = renderer.getContext().getContextAttributes()?.antialias === true;
    }
    const target = renderer.getRenderTarget();
    if (target === null) renderer.getDrawingBufferSize(this.size.value);
    else this.size.value.set(target.width, target.height);
    this.height.value = this.size.value.y;
    const smooth = target === null ? this.#canvasIsMultisampled : target.samples > 1;
    this.multisampled.value = smooth ? 1 : 0;
  }
}
