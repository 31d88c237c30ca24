import {
  type BodySource,
  ColumnUpload,
  OUTLINE_TEXELS,
  PosePair,
  type RealColumn,
  SHAPES,
  TEXTURE_WIDTH,
  UploadedPoses,
} from '@principia/render-core';
import { ColumnTexture } from './column-texture.ts';

/** A real column and its way to the GPU, through an f32 shadow where the column is f64. */
class RealTexture {
  readonly texture = new ColumnTexture('real');
  readonly #upload = new ColumnUpload();

  /** What must be added to the uploaded values to get the column's. */
  get origin(): number {
    return this.#upload.origin;
  }

  upload(column: RealColumn, used: number, origin = 0): void {
    this.texture.upload(this.#upload.refresh(column, used, origin), used);
  }

  /** Says that another column has the values of the last `upload`. */
  rename(column: RealColumn): void {
    this.texture.replaceColumn(this.#upload.replaceColumn(column));
  }
}

/** Which styles are on the GPU already. */
interface Uploaded {
  version: number;
  membership: number;
}

/**
 * The columns of one `BodySource` as textures, shared by all layers that draw it, so that each column is uploaded once
 * however many layers there are. Every `sync…` uploads only when the source's version counters moved. Where steps follow
 * each other, the textures of present poses and those of previous ones change roles, see `PosePair`: draw with `alphaOf`.
 */
export class SourceTextures {
  readonly ids = new ColumnTexture('whole');
  readonly x = new RealTexture();
  readonly y = new RealTexture();
  readonly previousX = new RealTexture();
  readonly previousY = new RealTexture();
  readonly angle = new RealTexture();
  readonly previousAngle = new RealTexture();
  readonly radius = new RealTexture();
  readonly size = new RealTexture();
  readonly color = new ColumnTexture('whole');
  readonly shape = new ColumnTexture('whole');
  readonly outline = new ColumnTexture('whole');
  readonly outlines = new ColumnTexture('real');
  readonly #source: BodySource;
  readonly #poses = new PosePair();
  readonly #positionSent = new UploadedPoses();
  readonly #angleSent = new UploadedPoses();
  readonly #style: Uploaded = { version: Number.NaN, membership: Number.NaN };
  #membership = Number.NaN;
  #outlinesVersion = 0;
  #hasTurning = false;
  #idList: Uint32Array | undefined;
  #originX = 0;
  #originY = 0;
  #users = 0;

  private constructor(source: BodySource) {
    this.#source = source;
  }

  static readonly #shared = new WeakMap<BodySource, SourceTextures>();

  /** The textures of `source`; hand them back with `release`. */
  static acquire(source: BodySource): SourceTextures {
    let textures = SourceTextures.#shared.get(source);
    if (textures === undefined) {
      textures = new SourceTextures(source);
      SourceTextures.#shared.set(source, textures);
    }
    textures.#users++;
    return textures;
  }

  /** Gives the textures back; the last user's release destroys them. */
  release(): void {
    if (--this.#users > 0) return;
    SourceTextures.#shared.delete(this.#source);
    for (const { texture } of this.#reals()) texture.destroy();
    for (const texture of [this.ids, this.color, this.shape, this.outline, this.outlines]) texture.destroy();
  }

  /** Where zero of the uploaded positions lies in the world, metres; (0, 0) for an f32 source. */
  get originX(): number {
    return this.#originOf(this.x, this.previousX);
  }

  get originY(): number {
    return this.#originOf(this.y, this.previousY);
  }

  #originOf(one: RealTexture, other: RealTexture): number {
    return (this.#poses.isSwapped ? other : one).origin;
  }

  /** Takes f64 positions relative to (x, y) metres from the next upload on. */
  setOrigin(x: number, y: number): void {
    if (x === this.#originX && y === this.#originY) return;
    this.#originX = x;
    this.#originY = y;
    this.#positionSent.invalidate();
  }

  syncIds(): void {
    const { ids, count, versions } = this.#source;
    if (versions.membership === this.#membership) return;
    this.#membership = versions.membership;
    this.ids.upload(this.#wholeRows(ids, count), count);
  }

  syncPosition(): void {
    const { position, previousPosition } = this.#source;
    this.#poses.refresh(this.#source);
    const what = this.#positionSent.take(this.#poses);
    if (what === 0) return;
    this.#send(what, this.x, this.previousX, position.x, previousPosition.x, this.#originX);
    this.#send(what, this.y, this.previousY, position.y, previousPosition.y, this.#originY);
  }

  /** After `syncStyle`: discs, rings and glows look the same however they are turned, and need no angles. */
  syncAngle(): void {
    if (!this.#hasTurning) return;
    const { angle, previousAngle } = this.#source;
    this.#poses.refresh(this.#source);
    const what = this.#angleSent.take(this.#poses);
    if (what !== 0) this.#send(what, this.angle, this.previousAngle, angle, previousAngle, 0);
  }

  /** What shaders take for `alpha`. */
  alphaOf(alpha: number): number {
    return this.#poses.alphaOf(alpha);
  }

  /** Sends a column to the texture that is the present one now; the other is sent as well, or has it already. */
  #send(what: 1 | 2, one: RealTexture, other: RealTexture, now: RealColumn, before: RealColumn, origin: number): void {
    const used = this.#source.lastId + 1;
    const { isSwapped } = this.#poses;
    (isSwapped ? other : one).upload(now, used, origin);
    const previous = isSwapped ? one : other;
    if (what === 1) previous.rename(before);
    else previous.upload(before, used, origin);
  }

  syncStyle(): void {
    const { radius, size, color, shape, versions } = this.#source;
    if (!this.#moved(this.#style, versions.style)) return;
    const used = this.#source.lastId + 1;
    this.radius.upload(radius, used);
    this.size.upload(size, used);
    this.color.upload(color, used);
    this.shape.upload(shape, used);
    const hasOutlines = this.#syncOutlines(used);
    this.#hasTurning = hasOutlines || anyTurns(shape, used);
  }

  /** Returns whether any collider has a shape other than a disc. A world without such shapes uploads nothing here. */
  #syncOutlines(used: number): boolean {
    const { outline, outlines } = this.#source;
    if (outline === undefined || outlines === undefined || outlines.used <= OUTLINE_TEXELS) return false;
    this.outline.upload(outline, used);
    if (outlines.version !== this.#outlinesVersion) {
      this.#outlinesVersion = outlines.version;
      this.outlines.upload(outlines.texels, outlines.used);
    }
    return true;
  }

  /** Membership counts too, because rows above the former last id were never uploaded. */
  #moved(uploaded: Uploaded, version: number): boolean {
    const { membership } = this.#source.versions;
    if (uploaded.version === version && uploaded.membership === membership) return false;
    uploaded.version = version;
    uploaded.membership = membership;
    return true;
  }

  /** The id list itself where it fills whole texture rows, else a copy that does. */
  #wholeRows(ids: Uint32Array, count: number): Uint32Array {
    if (ids.length > 0 && ids.length % TEXTURE_WIDTH === 0) return ids;
    const length = Math.max(1, Math.ceil(ids.length / TEXTURE_WIDTH)) * TEXTURE_WIDTH;
    if (this.#idList?.length !== length) this.#idList = new Uint32Array(length);
    for (let i = 0; i < count; i++) this.#idList[i] = ids[i];
    return this.#idList;
  }

  #reals(): RealTexture[] {
    return [this.x, this.y, this.previousX, this.previousY, this.angle, this.previousAngle, this.radius, this.size];
  }
}

/** Whether a row has a shape whose rotation can be seen. A function of its own, which compilers get to know. */
function anyTurns(shape: Uint32Array, used: number): boolean {
  for (let id = 0; id < used; id++) {
    if (shape[id] === SHAPES.box || shape[id] === SHAPES.markedDisc) return true;
  }
  return false;
}
