// Positions and velocities of stars, drawn from the models of the scenes.
import { createRandom, type DistanceLaw, pow, type Random, type Vector } from '@principia/physics';

/** Columns for `spawnMany`. */
export interface Stars {
  readonly position: { readonly x: Float64Array; readonly y: Float64Array; readonly z: Float64Array };
  readonly velocity: { readonly x: Float64Array; readonly y: Float64Array; readonly z: Float64Array };
}

export function emptyStars(count: number): Stars {
  const axes = () => ({ x: new Float64Array(count), y: new Float64Array(count), z: new Float64Array(count) });
  return { position: axes(), velocity: axes() };
}

export function setStar(stars: Stars, i: number, position: Vector, velocity: Vector): void {
  for (const axis of ['x', 'y', 'z'] as const) {
    stars.position[axis][i] = position[axis];
    stars.velocity[axis][i] = velocity[axis];
  }
}

/** Moves stars of equal mass so that their centre of mass is at rest at the origin. */
export function centreStars(stars: Stars): void {
  for (const columns of [stars.position, stars.velocity]) {
    for (const axis of ['x', 'y', 'z'] as const) {
      const column = columns[axis];
      const mean = column.reduce((sum, value) => sum + value, 0) / column.length;
      for (let i = 0; i < column.length; i++) column[i] -= mean;
    }
  }
}

/** The columns, without the z axis in 2D. */
export function inDimensions({ position, velocity }: Stars, dimensions: 2 | 3) {
  if (dimensions === 3) return { position, velocity };
  return { position: { x: position.x, y: position.y }, velocity: { x: velocity.x, y: velocity.y } };
}

/** Radius that contains the mass fraction `inside` of a Plummer sphere, in scale lengths (Plummer 1911). */
export function plummerRadius(inside: number): number {
  return 1 / Math.sqrt(pow(inside, -2 / 3) - 1);
}

/** Radius that contains the mass fraction `inside` of a Kuzmin disc, in scale lengths (Kuzmin 1956). */
export function kuzminRadius(inside: number): number {
  const root = 1 / (1 - inside);
  return Math.sqrt(root * root - 1);
}

/**
 * Speed over the escape speed in a Plummer sphere, drawn from q²(1 - q²)^(7/2) by rejection: Aarseth, Hénon & Wielen,
 * Astron. Astrophys. 37, 183 (1974).
 */
function plummerSpeed(random: Random): number {
  for (;;) {
    const q = random.uniform();
    const left = 1 - q * q;
    const density = q * q * left * left * left * Math.sqrt(left);
    // The density is below 0.0923.
    if (random.uniform(0, 0.1) < density) return q;
  }
}

/** A Plummer sphere of mass 1 and the given scale length in equilibrium, with G = 1. */
export function plummerSphere(count: number, scale: number, seed: number): Stars {
  const random = createRandom(seed, 2);
  const stars = emptyStars(count);
  for (let i = 0; i < count; i++) {
    // Mass fractions are drawn in equal strata; omitting the outermost thousandth keeps the virial ratio within 0.1 %.
    const radius = scale * plummerRadius((0.999 * (i + random.uniform())) / count + 1e-12);
    const leaving = Math.sqrt(2 / Math.sqrt(radius * radius + scale * scale));
    setStar(stars, i, random.onSphere(radius), random.onSphere(leaving * plummerSpeed(random)));
  }
  centreStars(stars);
  return stars;
}

/** Share of a disc's mass that it is made of: its rim would be far out, and thin. */
const DISC_SHARE = 0.97;

/** Fraction of the circular velocity that is rotation; the rest is random motion, which prevents fragmentation. */
const ROTATION = 0.8;

/**
 * A Kuzmin disc of mass 1 in virial equilibrium, with G = 1. For the law 1/r² its field in its plane is that of a
 * Plummer sphere; for 1/r the mass within R attracts as 1/R, by Gauss's law in 2D.
 */
export function kuzminDisc(law: DistanceLaw, count: number, scale: number, seed: number): Stars {
  const random = createRandom(seed, 2);
  const stars = emptyStars(count);
  const spread = Math.sqrt((1 - ROTATION * ROTATION) / 2);
  for (let i = 0; i < count; i++) {
    const radius = scale * kuzminRadius((DISC_SHARE * (i + random.uniform())) / count);
    const p = random.onCircle();
    const square = radius * radius + scale * scale;
    const circular =
      law === 'inverse-square'
        ? radius / Math.sqrt(square * Math.sqrt(square))
        : Math.sqrt(Math.max(0, 1 - scale / Math.sqrt(square)) / DISC_SHARE);
    const x = circular * (-ROTATION * p.y + spread * random.gaussian());
    const y = circular * (ROTATION * p.x + spread * random.gaussian());
    setStar(stars, i, { x: radius * p.x, y: radius * p.y, z: 0 }, { x, y, z: 0 });
  }
  centreStars(stars);
  return stars;
}
