import { type Bounds, type Geometry, Matrix, Mesh, Bounds as PixiBounds, type Shader } from 'pixi.js';

/** Extends a box, metres in the mesh's own coordinates. `pixel` is the size of a CSS pixel there. */
export type Measure = (box: Bounds, pixel: number) => void;

/**
 * A mesh whose box pixi cannot find, as its vertices are in textures. It is measured only where it is asked for, as filters,
 * `cacheAsTexture`, culling and `getBounds` do.
 */
export class MeasuredMesh extends Mesh<Geometry, Shader> {
  readonly #measure: Measure;
  readonly #box = new PixiBounds();
  readonly #transform = new Matrix();
  #isMeasured = false;

  constructor(geometry: Geometry, shader: Shader, measure: Measure) {
    super({ geometry, shader });
    this.#measure = measure;
  }

  override get bounds(): Bounds {
    const { a, b } = this.getGlobalTransform(this.#transform, false);
    const box = this.#box.clear();
    const scale = Math.hypot(a, b);
    this.#measure(box, scale > 0 ? 1 / scale : 0);
    if (!box.isValid) box.set(0, 0, 0, 0);
    this.#isMeasured = true;
    return box;
  }

  /** Says that the box may have changed. Costs nothing while nobody asks for it. */
  changed(): void {
    if (!this.#isMeasured) return;
    this.#isMeasured = false;
    this.onViewUpdate();
  }
}
