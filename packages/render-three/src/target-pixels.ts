import { Vector2, type WebGLRenderer } from 'three';

/** Properties of the render target for the shaders: its size and whether it is multisampled. */
export class TargetPixels {
  /** Width and height, device pixels. Large until the first frame, so that nothing counts as tiny. */
  readonly size = { value: new Vector2(1e9, 1e9) };
  readonly height = { value: 1e9 };
  /** 1 or 0. */
  readonly multisampled = { value: 0 };
  #renderer: WebGLRenderer | undefined;
  #canvasIsMultisampled = false;

  /** Reads the renderer's present target. It allocates nothing for a known renderer. */
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
