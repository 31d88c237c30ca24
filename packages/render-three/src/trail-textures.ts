import { type BodySource, PosePair, TEXTURE_WIDTH, type TrailHistory } from '@principia/render-core';
import {
  type ColorRepresentation,
  DataArrayTexture,
  FloatType,
  type IUniform,
  RedFormat,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { colorBytes } from './body-color.ts';
import { CentreTextures } from './centre-textures.ts';
import { ColumnTexture } from './column-texture.ts';

/** Colours of trails. */
export interface TrailColors {
  /** One colour for all trails; if omitted, each has the colour of its body. */
  color?: ColorRepresentation;
  /** Colour of trails whose body has no colour; default a light blue, 0x8fb8ff, as for bodies. */
  defaultColor?: ColorRepresentation;
}

/** The data of the trail shader. */
export class TrailTextures {
  readonly uniforms: Record<string, IUniform>;
  readonly #source: BodySource;
  readonly #history: TrailHistory;
  readonly #slices: DataArrayTexture[];
  readonly #birth = new ColumnTexture('uint');
  readonly #slots = new ColumnTexture('uint');
  readonly #colors = new ColumnTexture('uint');
  readonly #slotList: Uint32Array;
  /** Present positions of the bodies; needed only where the newest recording may be several steps old. */
  readonly #centres: CentreTextures | undefined;
  readonly #poses = new PosePair();
  readonly #centreOffset = new Vector3();
  #recordings = 0;
  /** Whether all slices must be uploaded, not just the latest. */
  #sendsAll = true;
  #birthVersion = Number.NaN;
  #resetVersion = 0;
  #styleVersion = Number.NaN;
  #membershipVersion = Number.NaN;

  constructor(history: TrailHistory, colors: TrailColors) {
    this.#history = history;
    this.#source = history.source;
    const axes = this.#source.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const);
    this.#slices = axes.map((axis) => sliceTexture(history[axis], history));
    this.#slotList = new Uint32Array(history.rowsPerSlice * TEXTURE_WIDTH);
    this.#centres = history.interval > 1 ? new CentreTextures(this.#source, this.#poses) : undefined;
    this.uniforms = {
      birth: { value: this.#birth },
      slots: { value: this.#slots },
      bodyColors: { value: this.#colors },
      onlyColor: { value: colors.color === undefined ? 0 : colorBytes(colors.color) },
      defaultColor: { value: colorBytes(colors.defaultColor ?? 0x8fb8ff) },
      points: { value: history.length },
      recordings: { value: 0 },
      newestIsCurrent: { value: 0 },
      poseAlpha: { value: 1 },
      slotIsId: { value: history.bodies === undefined },
      centreOffset: { value: this.#centreOffset },
      ...this.#centres?.uniforms,
    };
    axes.forEach((axis, i) => {
      this.uniforms[`trail${axis.toUpperCase()}`] = { value: this.#slices[i] };
    });
  }

  refresh(alpha: number): void {
    const history = this.#history;
    this.uniforms.poseAlpha.value = alpha;
    this.uniforms.recordings.value = history.recordings;
    this.uniforms.newestIsCurrent.value = history.newestIsCurrent ? 1 : 0;
    this.#refreshSlices();
    if (history.birthVersion !== this.#birthVersion) {
      this.#birthVersion = history.birthVersion;
      this.#birth.upload(history.birth, history.bodies?.length ?? this.#source.lastId + 1);
    }
    this.#refreshSlots();
    const { versions, color, lastId } = this.#source;
    if (versions.style !== this.#styleVersion || lastId + 1 > this.#colors.used) {
      this.#styleVersion = versions.style;
      this.#colors.upload(color, lastId + 1);
    }
    if (this.#centres === undefined) return;
    this.#poses.refresh(this.#source);
    this.uniforms.poseAlpha.value = this.#poses.alphaOf(alpha);
    const { x, y, z } = history.origin;
    this.#centres.setOrigin(x, y, z);
    this.#centres.refresh();
    const { origin } = this.#centres;
    this.#centreOffset.set(origin.x - x, origin.y - y, origin.z - z);
  }

  /** New storage (initially, or after a lost context) needs every slice. The upload follows. */
  beforeDrawing(renderer: WebGLRenderer): void {
    for (let i = 0; i < this.#slices.length; i++) {
      const known = renderer.properties.get(this.#slices[i]) as { __webglTexture?: WebGLTexture };
      if (this.#sendsAll || known.__webglTexture === undefined) this.#slices[i].clearLayerUpdates();
    }
    this.#sendsAll = false;
    this.#birth.send(renderer);
    this.#slots.send(renderer);
    this.#colors.send(renderer);
    this.#centres?.send(renderer);
  }

  dispose(): void {
    for (const slices of this.#slices) slices.dispose();
    for (const column of [this.#birth, this.#slots, this.#colors]) column.dispose();
    this.#centres?.dispose();
  }

  #refreshSlices(): void {
    const { recordings, resetVersion, length } = this.#history;
    const isReset = resetVersion !== this.#resetVersion;
    if (!isReset && recordings === this.#recordings) return;
    if (isReset) this.#sendsAll = true;
    const oldest = Math.max(this.#recordings, recordings - length);
    for (let i = 0; i < this.#slices.length; i++) {
      for (let n = oldest; n < recordings; n++) this.#slices[i].addLayerUpdate(n % length);
      this.#slices[i].needsUpdate = true;
    }
    this.#resetVersion = resetVersion;
    this.#recordings = recordings;
  }

  #refreshSlots(): void {
    const { bodies, count } = this.#history;
    const { versions, ids } = this.#source;
    const version = bodies === undefined ? versions.membership : 0;
    if (version === this.#membershipVersion) return;
    this.#membershipVersion = version;
    // Maps slot `i` to its id: the id itself, or the index in the fixed list with the id beside it.
    const list = this.#slotList;
    const shown = bodies ?? ids;
    for (let i = 0; i < count; i++) list[i] = shown[i];
    this.#slots.upload(list, count);
  }
}

/** The slices of one axis as layers of an array texture over the array of the history. */
function sliceTexture(points: Float32Array, history: TrailHistory): DataArrayTexture {
  const texture = new DataArrayTexture(points, TEXTURE_WIDTH, history.rowsPerSlice, history.length);
  texture.format = RedFormat;
  texture.type = FloatType;
  texture.needsUpdate = true;
  return texture;
}
