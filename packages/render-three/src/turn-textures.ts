import { type BodySource, ColumnUpload, type RealColumn } from '@principia/render-core';
import type { IUniform } from 'three';
import { checkedColumn } from './centre-textures.ts';
import { ColumnTexture } from './column-texture.ts';
import { turnUniforms } from './shaders/body-pull.ts';

interface TurnColumn {
  readonly column: RealColumn;
  readonly upload: ColumnUpload;
  readonly texture: ColumnTexture;
}

/** How the bodies are turned and were a step ago, as textures: angles in 2D, quaternions in 3D. */
export class TurnTextures {
  readonly uniforms: Record<string, IUniform> = {};
  readonly #source: BodySource;
  readonly #columns: TurnColumn[];
  #version = Number.NaN;

  constructor(source: BodySource) {
    this.#source = source;
    const { angle, previousAngle, orientation, previousOrientation } = source;
    const columns =
      source.dimensions === 2
        ? [angle, previousAngle]
        : [orientation, previousOrientation].flatMap((q) => [q.x, q.y, q.z, q.w]);
    this.#columns = columns.map((column) => ({
      column: checkedColumn(source, column),
      upload: new ColumnUpload(),
      texture: new ColumnTexture('real'),
    }));
    this.#columns.forEach(({ texture }, i) => {
      this.uniforms[turnUniforms[source.dimensions][i]] = { value: texture.texture };
    });
  }

  /** Marks the rotations for upload if the source has stepped. */
  refresh(): void {
    const { versions, lastId } = this.#source;
    const used = lastId + 1;
    if (versions.pose === this.#version && used <= this.#columns[0].texture.used) return;
    this.#version = versions.pose;
    for (let i = 0; i < this.#columns.length; i++) {
      const { column, upload, texture } = this.#columns[i];
      texture.upload(upload.refresh(column, used), used);
    }
  }

  dispose(): void {
    for (const { texture } of this.#columns) texture.dispose();
  }
}
