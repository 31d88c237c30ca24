import { type BodySource, SHAPES } from '@principia/render-core';

/** 32-bit lanes per body in the packed style: radius, colour, shape, outline. */
const LANES = 4;

/** The bit of bodies whose collider has an outline, beside those of the shapes. */
const OUTLINED = 1 << 31;

/** Bits of the shapes without a surface. */
const FLATS = (1 << SHAPES.ring) | (1 << SHAPES.glow);

/**
 * Radius, colour, shape and outline of every body packed as four 32-bit lanes a body, so that a 3D world with rotation needs
 * sixteen textures in the vertex shader, which is all that WebGL 2 promises.
 */
export class BodyStyle {
  /** Drawn radius (metres, as float bits), RGBA bytes, shape kind, number of the outline; `LANES` values a body. */
  readonly data: Uint32Array;
  readonly #radius: Float32Array;
  readonly #defaultColor: number;
  #shapes = 0;

  /** @param defaultColor RGBA bytes in memory order for bodies whose colour is zero */
  constructor(rows: number, defaultColor: number) {
    this.data = new Uint32Array(rows * LANES);
    this.#radius = new Float32Array(this.data.buffer);
    this.#defaultColor = defaultColor;
  }

  /** Packs the rows of ids `0 … used - 1`. */
  pack(source: BodySource, used: number): void {
    this.#shapes = packLooks(this.data, this.#radius, source, this.#defaultColor, used);
  }

  /** Whether a row that was packed last time, with a radius, has this shape. */
  hasShape(kind: number): boolean {
    return (this.#shapes & (1 << kind)) !== 0;
  }

  /** Whether any row has a shape whose rotation is visible. */
  get hasTurning(): boolean {
    return this.hasShape(SHAPES.box) || this.hasShape(SHAPES.markedDisc) || (this.#shapes & OUTLINED) !== 0;
  }

  /** Whether any row has a shape with a round surface. */
  get hasBalls(): boolean {
    return (this.#shapes & ~(FLATS | OUTLINED | (1 << SHAPES.box))) !== 0;
  }

  /** Whether any row has a shape with a surface. */
  get hasSolids(): boolean {
    return (this.#shapes & ~(FLATS | OUTLINED)) !== 0;
  }

  /** Whether any row has a shape that is just an outline or a spot of light. */
  get hasFlats(): boolean {
    return (this.#shapes & FLATS) !== 0;
  }
}

/**
 * A function of its own, which compilers get to know by its arrays: a loop on fields stayed uncompiled. Of a body that is
 * not drawn only that is written: pools of particles are large, and few of them alight.
 *
 * @returns a bit for every shape of a body that is drawn
 */
function packLooks(
  out: Uint32Array,
  drawn: Float32Array,
  { size, radius, color, shape, outline }: BodySource,
  defaultColor: number,
  used: number,
): number {
  let shapes = 0;
  for (let id = 0, at = 0; id < used; id++, at += LANES) {
    const own = size[id];
    const extent = own === 0 ? radius[id] : own;
    drawn[at] = extent;
    if (!(extent > 0)) continue;
    const bytes = color[id];
    out[at + 1] = bytes;
    // Separate stores: V8 would allocate an object for a value of mixed type, for every body.
    if (bytes === 0) out[at + 1] = defaultColor;
    out[at + 2] = shape[id];
    shapes |= 1 << shape[id];
    if (outline === undefined) continue;
    out[at + 3] = outline[id];
    if (outline[id] !== 0) shapes |= OUTLINED;
  }
  return shapes;
}
