import { type BodySource, ColumnUpload, type RealColumn } from '@principia/render-core';
import type { IUniform } from 'three';
import { BodyStyle } from './body-style.ts';
import { ColumnTexture } from './column-texture.ts';
import { poseUniforms } from './shaders/body-pull.ts';

/** One pose column on its way to the GPU. */
interface PoseColumn {
  readonly column: RealColumn;
  readonly texture: ColumnTexture;
  readonly upload: ColumnUpload;
  /** Axis of the origin it is relative to; undefined for angles and quaternions. */
  readonly axis: 'x' | 'y' | 'z' | undefined;
}

/** A point in metres. */
export interface Point3 {
  x: number;
  y: number;
  z: number;
}

/**
 * The columns of a source as textures, kept as fresh as the source's version counters ask for: nothing is sent
 * to the GPU in a frame without a step.
 */
export class BodyTextures {
  readonly uniforms: Record<string, IUniform> = { poseAlpha: { value: 1 } };
  readonly style: BodyStyle;
  /** Point that f64 positions are sent relative to, metres; see `setOrigin`. Stays zero for f32 columns. */
  readonly origin: Point3 = { x: 0, y: 0, z: 0 };
  readonly #source: BodySource;
  readonly #centres: PoseColumn[];
  readonly #turns: PoseColumn[];
  /** Send rotations even where every body is a ball, as for a custom geometry. */
  readonly #alwaysTurns: boolean;
  readonly #ids = new ColumnTexture('uint');
  readonly #style = new ColumnTexture('uint4');
  #idList: Uint32Array;
  #centreVersion = Number.NaN;
  #turnVersion = Number.NaN;
  #styleVersion = Number.NaN;
  #membershipVersion = Number.NaN;

  constructor(source: BodySource, defaultColor: number, alwaysTurns: boolean) {
    this.#source = source;
    this.#alwaysTurns = alwaysTurns;
    this.style = new BodyStyle(source.rows, defaultColor);
    this.#idList = new Uint32Array(source.rows);
    this.#centres = centreColumns(source);
    this.#turns = turnColumns(source);
    [...this.#centres, ...this.#turns].forEach(({ texture }, i) => {
      this.uniforms[poseUniforms[source.dimensions][i]] = { value: texture.texture };
    });
    this.uniforms['bodyIds'] = { value: this.#ids.texture };
    this.uniforms['bodyStyle'] = { value: this.#style.texture };
  }

  /** The ids to draw, in an array of the source's `rows` that is never replaced; valid after `refresh`. */
  get ids(): Uint32Array {
    return this.#idList;
  }

  /** Moves with every change of `ids`. */
  get membershipVersion(): number {
    return this.#membershipVersion;
  }

  /** Has f64 positions rounded to f32 relative to another point, metres; sends them again with the next refresh. */
  setOrigin(x: number, y: number, z: number): void {
    if (this.#source.position.x instanceof Float32Array) return; // their digits are gone already
    this.origin.x = x;
    this.origin.y = y;
    this.origin.z = z;
    this.#centreVersion = Number.NaN;
  }

  /** Marks for upload what the source says has changed. Call once a frame, before drawing. */
  refresh(): void {
    const { versions, lastId } = this.#source;
    const used = lastId + 1;
    if (versions.membership !== this.#membershipVersion) this.#refreshIds(versions.membership);
    if (versions.style !== this.#styleVersion || used > this.#style.used) {
      this.#styleVersion = versions.style;
      this.style.pack(this.#source, used);
      this.#style.upload(this.style.data, used);
    }
    if (versions.pose !== this.#centreVersion || used > this.#centres[0].texture.used) {
      this.#centreVersion = versions.pose;
      this.#send(this.#centres, used);
    }
    // Balls look the same however they are turned: most particle worlds never send a rotation.
    if (!this.#alwaysTurns && !this.style.hasTurning) return;
    if (versions.pose !== this.#turnVersion || used > this.#turns[0].texture.used) {
      this.#turnVersion = versions.pose;
      this.#send(this.#turns, used);
    }
  }

  dispose(): void {
    for (const { texture } of this.#centres) texture.dispose();
    for (const { texture } of this.#turns) texture.dispose();
    this.#ids.dispose();
    this.#style.dispose();
  }

  #send(columns: readonly PoseColumn[], used: number): void {
    for (let i = 0; i < columns.length; i++) {
      const { column, texture, upload, axis } = columns[i];
      texture.upload(upload.refresh(column, used, axis === undefined ? 0 : this.origin[axis]), used);
    }
  }

  #refreshIds(version: number): void {
    const { ids, count } = this.#source;
    const list = this.#idList;
    for (let slot = 0; slot < count; slot++) list[slot] = ids[slot];
    this.#ids.upload(list, count);
    this.#membershipVersion = version;
  }
}

function poseColumn(source: BodySource, column: RealColumn, axis?: 'x' | 'y' | 'z'): PoseColumn {
  if (column.length !== source.rows) {
    throw new Error(`every column of a body source must have its ${source.rows} rows, got one of ${column.length}`);
  }
  return { column, axis, texture: new ColumnTexture('real'), upload: new ColumnUpload() };
}

/** The positions in the order of `poseUniforms`. */
function centreColumns(source: BodySource): PoseColumn[] {
  const axes = source.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const);
  return [source.position, source.previousPosition].flatMap((p) =>
    axes.map((axis) => poseColumn(source, p[axis], axis)),
  );
}

/** The rotations in the order of `poseUniforms`. */
function turnColumns(source: BodySource): PoseColumn[] {
  const { angle, previousAngle, orientation, previousOrientation } = source;
  const columns =
    source.dimensions === 2
      ? [angle, previousAngle]
      : [orientation, previousOrientation].flatMap((q) => [q.x, q.y, q.z, q.w]);
  return columns.map((column) => poseColumn(source, column));
}
