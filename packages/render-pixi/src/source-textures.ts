import { type BodySource, ColumnUpload, type RealColumn, TEXTURE_WIDTH } from '@principia/render-core';
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
}

/** Which poses, styles and id lists are on the GPU already. */
interface Uploaded {
  version: number;
  membership: number;
}

/**
 * The columns of one `BodySource` as textures, shared by all layers that draw it, so that each column is uploaded once
 * however many layers there are. Every `sync…` uploads only when the source's version counters moved.
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
  readonly #source: BodySource;
  readonly #position: Uploaded = { version: Number.NaN, membership: Number.NaN };
  readonly #angle: Uploaded = { version: Number.NaN, membership: Number.NaN };
  readonly #style: Uploaded = { version: Number.NaN, membership: Number.NaN };
  #membership = Number.NaN;
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
    for (const texture of [this.ids, this.color, this.shape]) texture.destroy();
  }

  /** Where zero of the uploaded positions lies in the world, metres; (0, 0) for an f32 source. */
  get originX(): number {
    return this.x.origin;
  }

  get originY(): number {
    return this.y.origin;
  }

  /** Takes f64 positions relative to (x, y) metres from the next upload on. */
  setOrigin(x: number, y: number): void {
    if (x === this.#originX && y === this.#originY) return;
    this.#originX = x;
    this.#originY = y;
    this.#position.version = Number.NaN;
  }

  syncIds(): void {
    const { ids, count, versions } = this.#source;
    if (versions.membership === this.#membership) return;
    this.#membership = versions.membership;
    this.ids.upload(this.#wholeRows(ids, count), count);
  }

  syncPosition(): void {
    const { position, previousPosition, versions } = this.#source;
    if (!this.#moved(this.#position, versions.pose)) return;
    const used = this.#source.lastId + 1;
    this.x.upload(position.x, used, this.#originX);
    this.y.upload(position.y, used, this.#originY);
    this.previousX.upload(previousPosition.x, used, this.#originX);
    this.previousY.upload(previousPosition.y, used, this.#originY);
  }

  syncAngle(): void {
    const { angle, previousAngle, versions } = this.#source;
    if (!this.#moved(this.#angle, versions.pose)) return;
    const used = this.#source.lastId + 1;
    this.angle.upload(angle, used);
    this.previousAngle.upload(previousAngle, used);
  }

  syncStyle(): void {
    const { radius, size, color, shape, versions } = this.#source;
    if (!this.#moved(this.#style, versions.style)) return;
    const used = this.#source.lastId + 1;
    this.radius.upload(radius, used);
    this.size.upload(size, used);
    this.color.upload(color, used);
    this.shape.upload(shape, used);
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
    return [
      ...[this.x, this.y, this.previousX, this.previousY],
      ...[this.angle, this.previousAngle, this.radius, this.size],
    ];
  }
}
