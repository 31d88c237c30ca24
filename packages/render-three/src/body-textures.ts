import { type BodySource, PosePair } from '@principia/render-core';
import type { IUniform, WebGLRenderer } from 'three';
import { BodyStyle } from './body-style.ts';
import { CentreTextures } from './centre-textures.ts';
import { ColumnTexture } from './column-texture.ts';
import type { PoseColumns } from './pose-columns.ts';
import { createTurnTextures } from './turn-textures.ts';

/**
 * The columns of a source as textures, kept as fresh as the source's version counters ask for: nothing is sent
 * to the GPU in a frame without a step.
 */
export class BodyTextures {
  readonly uniforms: Record<string, IUniform>;
  readonly style: BodyStyle;
  readonly centres: CentreTextures;
  /** The ids to draw: `ids[0 … count)`, an array of the source's `rows` that is never replaced. */
  readonly ids: Uint32Array;
  readonly #source: BodySource;
  readonly #poses = new PosePair();
  readonly #turns: PoseColumns;
  /** Uploads rotations even if every body is a ball, for a custom geometry. */
  readonly #alwaysTurns: boolean;
  readonly #idTexture = new ColumnTexture('uint');
  readonly #styleTexture = new ColumnTexture('uint4');
  readonly #outlineTexture = new ColumnTexture('real');
  #styleVersion = Number.NaN;
  #membershipVersion = Number.NaN;
  #outlineVersion = 0;

  constructor(source: BodySource, defaultColor: number, alwaysTurns: boolean) {
    this.#source = source;
    this.#alwaysTurns = alwaysTurns;
    this.style = new BodyStyle(source.rows, defaultColor);
    this.ids = new Uint32Array(source.rows);
    this.centres = new CentreTextures(source, this.#poses);
    this.#turns = createTurnTextures(source, this.#poses);
    this.uniforms = {
      poseAlpha: { value: 1 },
      bodyIds: { value: this.#idTexture },
      bodyStyle: { value: this.#styleTexture },
      bodyOutlines: { value: this.#outlineTexture },
      ...this.centres.uniforms,
      ...this.#turns.uniforms,
    };
  }

  /** Incremented with every change of `ids`. */
  get membershipVersion(): number {
    return this.#membershipVersion;
  }

  /**
   * Marks for upload what the source says has changed. Call once a frame, before drawing.
   *
   * @param alpha where between the previous poses, 0, and the present ones, 1, to draw
   */
  refresh(alpha: number): void {
    const { versions, lastId } = this.#source;
    const used = lastId + 1;
    if (versions.membership !== this.#membershipVersion) this.#refreshIds(versions.membership);
    if (versions.style !== this.#styleVersion || used > this.#styleTexture.used) {
      this.#styleVersion = versions.style;
      this.style.pack(this.#source, used);
      this.#styleTexture.upload(this.style.data, used);
    }
    this.#refreshOutlines();
    this.#poses.refresh(this.#source);
    this.uniforms.poseAlpha.value = this.#poses.alphaOf(alpha);
    this.centres.refresh();
    // The rotation of balls is invisible, so most particle worlds never upload it.
    if (this.#alwaysTurns || this.style.hasTurning) this.#turns.refresh();
  }

  /** Uploads the marked columns. Call before each drawing, of shadows too. */
  send(renderer: WebGLRenderer): void {
    this.#idTexture.send(renderer);
    this.#styleTexture.send(renderer);
    this.#outlineTexture.send(renderer);
    this.centres.send(renderer);
    this.#turns.send(renderer);
  }

  dispose(): void {
    this.centres.dispose();
    this.#turns.dispose();
    this.#idTexture.dispose();
    this.#styleTexture.dispose();
    this.#outlineTexture.dispose();
  }

  #refreshOutlines(): void {
    const { outlines } = this.#source;
    if (outlines === undefined || outlines.version === this.#outlineVersion) return;
    this.#outlineVersion = outlines.version;
    this.#outlineTexture.upload(outlines.texels, outlines.used);
  }

  #refreshIds(version: number): void {
    const { ids, count } = this.#source;
    for (let slot = 0; slot < count; slot++) this.ids[slot] = ids[slot];
    this.#idTexture.upload(this.ids, count);
    this.#membershipVersion = version;
  }
}
