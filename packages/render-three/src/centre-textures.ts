import { type BodySource, ColumnUpload, type RealColumn } from '@principia/render-core';
import type { IUniform } from 'three';
import { ColumnTexture } from './column-texture.ts';
import { centreUniforms } from './shaders/body-pull.ts';

/** A point in metres. */
export interface Point3 {
  x: number;
  y: number;
  z: number;
}

interface CentreColumn {
  readonly axis: 'x' | 'y' | 'z';
  readonly column: RealColumn;
  readonly upload: ColumnUpload;
  readonly texture: ColumnTexture;
}

/** Where the bodies are and were a step ago, as textures; sent to the GPU once a step. */
export class CentreTextures {
  readonly uniforms: Record<string, IUniform> = {};
  readonly #source: BodySource;
  readonly #columns: CentreColumn[];
  readonly #origin: Point3 = { x: 0, y: 0, z: 0 };
  #version = Number.NaN;

  constructor(source: BodySource) {
    this.#source = source;
    const axes = source.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const);
    this.#columns = [source.position, source.previousPosition].flatMap((p) =>
      axes.map((axis) => ({
        axis,
        column: checkedColumn(source, p[axis]),
        upload: new ColumnUpload(),
        texture: new ColumnTexture('real'),
      })),
    );
    this.#columns.forEach(({ texture }, i) => {
      this.uniforms[centreUniforms[source.dimensions][i]] = { value: texture.texture };
    });
  }

  /** Point the sent positions are relative to, metres. */
  get origin(): Readonly<Point3> {
    return this.#origin;
  }

  /** Has f64 positions rounded to f32 relative to another point, metres; f32 ones have lost their digits already. */
  setOrigin(x: number, y: number, z: number): void {
    const origin = this.#origin;
    if (this.#columns[0].column instanceof Float32Array) return;
    if (x === origin.x && y === origin.y && z === origin.z) return;
    origin.x = x;
    origin.y = y;
    origin.z = z;
    this.#version = Number.NaN;
  }

  /** Marks the positions for upload if the source has stepped. */
  refresh(): void {
    const { versions, lastId } = this.#source;
    const used = lastId + 1;
    if (versions.pose === this.#version && used <= this.#columns[0].texture.used) return;
    this.#version = versions.pose;
    for (let i = 0; i < this.#columns.length; i++) {
      const { axis, column, upload, texture } = this.#columns[i];
      texture.upload(upload.refresh(column, used, this.#origin[axis]), used);
    }
  }

  dispose(): void {
    for (const { texture } of this.#columns) texture.dispose();
  }
}

/** @throws Error when the column has not as many rows as the source says */
export function checkedColumn(source: BodySource, column: RealColumn): RealColumn {
  if (column.length === source.rows) return column;
  throw new Error(`every column of a body source must have its ${source.rows} rows, got one of ${column.length}`);
}
