import type { BodySource, PosePair } from '@principia/render-core';
import type { IUniform, WebGLRenderer } from 'three';
import { PoseColumns } from './pose-columns.ts';
import { centreUniforms } from './shaders/body-pull.ts';

/** A point in metres. */
export interface Point3 {
  x: number;
  y: number;
  z: number;
}

/** Present and previous positions as textures; uploaded once per step. */
export class CentreTextures {
  readonly uniforms: Record<string, IUniform>;
  readonly #columns: PoseColumns;
  readonly #origin: Point3 = { x: 0, y: 0, z: 0 };
  readonly #origins = [0, 0, 0];

  constructor(source: BodySource, pair: PosePair) {
    const [{ x, y, z }, before] = [source.position, source.previousPosition];
    const names = centreUniforms[source.dimensions];
    this.#columns =
      source.dimensions === 2
        ? new PoseColumns(source, pair, [x, y], [before.x, before.y], names)
        : new PoseColumns(source, pair, [x, y, z], [before.x, before.y, before.z], names);
    this.uniforms = this.#columns.uniforms;
  }

  /** Origin of the uploaded positions, metres. */
  get origin(): Readonly<Point3> {
    return this.#origin;
  }

  /** Sets the origin relative to which f64 positions are rounded to f32; f32 positions have no extra digits. */
  setOrigin(x: number, y: number, z: number): void {
    const origin = this.#origin;
    if (!this.#columns.isPrecise) return;
    if (x === origin.x && y === origin.y && z === origin.z) return;
    origin.x = this.#origins[0] = x;
    origin.y = this.#origins[1] = y;
    origin.z = this.#origins[2] = z;
    this.#columns.forget();
  }

  /** Marks the positions for upload if the source has stepped since the pair was refreshed. */
  refresh(): void {
    this.#columns.refresh(this.#origins);
  }

  /** Call before each drawing. */
  send(renderer: WebGLRenderer): void {
    this.#columns.send(renderer);
  }

  dispose(): void {
    this.#columns.dispose();
  }
}
