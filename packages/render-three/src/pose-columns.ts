import { type BodySource, ColumnUpload, type PosePair, type RealColumn, UploadedPoses } from '@principia/render-core';
import type { IUniform, WebGLRenderer } from 'three';
import { ColumnTexture } from './column-texture.ts';
import type { Uniforms } from './material-patch.ts';

/** One of the two textures of a column. */
class Half {
  readonly texture = new ColumnTexture('real');
  readonly #upload = new ColumnUpload();

  send(column: RealColumn, used: number, origin: number): void {
    this.texture.upload(this.#upload.refresh(column, used, origin), used);
  }

  rename(column: RealColumn): void {
    this.texture.rename(this.#upload.replaceColumn(column));
  }
}

interface PoseColumn {
  readonly now: RealColumn;
  readonly previous: RealColumn;
  readonly halves: readonly [Half, Half];
}

/** Columns of poses now and a step ago, each a pair of textures. */
export class PoseColumns {
  readonly uniforms: Record<string, IUniform>;
  readonly #source: BodySource;
  readonly #pair: PosePair;
  readonly #columns: readonly PoseColumn[];
  readonly #sent = new UploadedPoses();

  /**
   * @param names of the uniforms: the halves that are present at first, then the others
   * @throws Error when a column has not as many rows as the source says
   */
  constructor(
    source: BodySource,
    pair: PosePair,
    now: readonly RealColumn[],
    previous: readonly RealColumn[],
    names: readonly string[],
  ) {
    this.#source = source;
    this.#pair = pair;
    this.#columns = now.map((column, i) => ({
      now: checkedColumn(source, column),
      previous: checkedColumn(source, previous[i]),
      halves: [new Half(), new Half()],
    }));
    const halves = [0, 1].flatMap((half) => this.#columns.map(({ halves }) => halves[half]));
    const uniforms: Uniforms = {};
    halves.forEach(({ texture }, i) => {
      uniforms[names[i]] = { value: texture };
    });
    this.uniforms = uniforms;
  }

  /** Whether the columns are f64; f32 columns have no digits that an origin could preserve. */
  get isPrecise(): boolean {
    return this.#columns[0].now instanceof Float64Array;
  }

  /** Forces an upload of all columns the next time. */
  forget(): void {
    this.#sent.invalidate();
  }

  /**
   * Marks for upload what has changed according to the pair.
   *
   * @param origin subtracted from the columns in their order, where they are f64
   */
  refresh(origin?: readonly number[]): void {
    const what = this.#sent.take(this.#pair);
    if (what === 0) return;
    const used = this.#source.lastId + 1;
    const present = this.#pair.isSwapped ? 1 : 0;
    for (let i = 0; i < this.#columns.length; i++) {
      const { now, previous, halves } = this.#columns[i];
      const zero = origin === undefined ? 0 : origin[i];
      halves[present].send(now, used, zero);
      if (what === 1) halves[1 - present].rename(previous);
      else halves[1 - present].send(previous, used, zero);
    }
  }

  /** Call before each drawing. */
  send(renderer: WebGLRenderer): void {
    for (let i = 0; i < this.#columns.length; i++) {
      const { halves } = this.#columns[i];
      halves[0].texture.send(renderer);
      halves[1].texture.send(renderer);
    }
  }

  dispose(): void {
    for (const { halves } of this.#columns) for (const { texture } of halves) texture.dispose();
  }
}

function checkedColumn(source: BodySource, column: RealColumn): RealColumn {
  if (column.length === source.rows) return column;
  throw new Error(`every column of a body source must have its ${source.rows} rows, got one of ${column.length}`);
}
