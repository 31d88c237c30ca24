// A disc galaxy: a rotating disc of stars with a spherical bulge in the field of a fixed halo. G = 1, the stars' mass
// is 1, the disc's scale length 1 m.
// |
// All three belong to the same family (Plummer 1911; Kuzmin 1956; Toomre 1963): in the plane each attracts a star at
// radius R with G M R/(R² + a²)^(3/2), so the angular velocity Ω and the epicyclic frequency κ are closed forms:
// | Ω² = Σ G M (R² + a²)^(-3/2) κ² = 4 Ω² - 3 R² Σ G M (R² + a²)^(-5/2)
// The disc's stars rotate with Ω, reduced by asymmetric drift, and have the radial dispersion σ = Q 3.36 G Σ/κ (Toomre,
// ApJ 139, 1217, 1964): slightly above Q = 1 a disc does not fragment and forms spiral arms.
import {
  attractors,
  createPhysicsWorld,
  createRandom,
  mutualGravity,
  type Random,
  rgba,
  spawn,
  spawnMany,
  velocityVerlet,
} from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { type ClusterRun, relativeErrorParameter } from './cluster.ts';
import { centreStars, emptyStars, inDimensions, kuzminRadius, plummerRadius, type Stars, setStar } from './stars.ts';

interface Mass {
  readonly mass: number;
  readonly scale: number;
}

interface Model {
  readonly disc: Mass;
  readonly bulge: Mass;
  readonly halo: Mass;
  readonly toomre: number;
  readonly dimensions: 2 | 3;
}

/** Fraction of the disc's mass within eight scale lengths, where its stars end. */
const DISC_SHARE = 0.876;
/** Standard deviation of the disc's height, in scale lengths. */
const HEIGHT = 0.05;

/** A disc of stars with a bulge that winds up spiral arms. */
export const galaxy = defineScene({
  name: 'galaxy',
  description: 'a disc of stars with a bulge that winds up spiral arms',
  precision: 'f32',
  parameters: {
    count: countOf('stars', 60_000, 2_000_000),
    relativeError: relativeErrorParameter,
    bulge: { about: 'share of the stars that are in the bulge', unit: '', initial: 0.2, min: 0, max: 1 },
    halo: { about: 'mass of the halo over that of the stars', unit: '', initial: 1.5, min: 0, max: 20 },
    toomre: { about: "Toomre's Q: below 1 the disc falls into clumps", unit: '', initial: 1.1, min: 0, max: 5 },
    softening: { about: 'softening length of a star', unit: 'm', initial: 0.05, min: 0.001, max: 1 },
  },
  build({ dimensions, precision, seed, progress, parameters }): ClusterRun {
    const { count, relativeError, bulge, halo, toomre, softening } = parameters;
    const gravity = mutualGravity({ G: 1, softening, relativeError });
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count + 1,
      integrator: velocityVerlet,
      forces: [gravity, attractors()],
    });
    const model = {
      disc: { mass: 1 - bulge, scale: 1 },
      bulge: { mass: bulge, scale: 0.25 },
      halo: { mass: halo, scale: 3 },
      toomre,
      dimensions,
    };
    const inBulge = Math.floor(bulge * count);
    const stars = starsOf(model, count, inBulge, createRandom(seed, 3));
    if (halo > 0) spawn(world, { position: {}, attractor: { mu: halo, softening: model.halo.scale } });
    const color = Uint32Array.from({ length: count }, (_, i) =>
      i < inBulge ? rgba(1, 0.82, 0.58, 0.8) : rgba(0.65, 0.78, 1, 0.7),
    );
    const looks = { color, size: 0.012 };
    spawnMany(world, count, { ...inDimensions(stars, dimensions), mass: 1 / count, appearance: looks }, progress);
    return { world, dt: 1 / 64, gravity, law: 'inverse-square', forceError: (of) => gravity.rmsError(of, 1000) };
  },
});

function starsOf(model: Model, count: number, inBulge: number, random: Random): Stars {
  const stars = emptyStars(count);
  for (let i = 0; i < inBulge; i++) putBulgeStar(stars, i, model, random, (i + random.uniform()) / inBulge);
  for (let i = inBulge; i < count; i++) {
    putDiscStar(stars, i, model, random, (i - inBulge + random.uniform()) / (count - inBulge));
  }
  centreStars(stars);
  return stars;
}

function frequenciesAt({ disc, bulge, halo }: Model, square: number): { omega2: number; kappa2: number } {
  let omega2 = 0;
  let fall = 0;
  for (const { mass, scale } of [disc, bulge, halo]) {
    const u = square + scale * scale;
    const pull = mass / (u * Math.sqrt(u));
    omega2 += pull;
    fall += pull / u;
  }
  return { omega2, kappa2: 4 * omega2 - 3 * square * fall };
}

function putDiscStar(stars: Stars, i: number, model: Model, random: Random, inside: number): void {
  const { disc, toomre } = model;
  const radius = disc.scale * kuzminRadius(DISC_SHARE * inside);
  const square = radius * radius;
  const { omega2, kappa2 } = frequenciesAt(model, square);
  const u = square + disc.scale * disc.scale;
  const surface = (disc.scale * disc.mass) / (2 * Math.PI * u * Math.sqrt(u));
  const radial = Math.min((toomre * 3.36 * surface) / Math.sqrt(kappa2), 0.5 * radius * Math.sqrt(omega2));
  const along = radial * Math.sqrt(kappa2 / (4 * omega2));
  const mean = Math.sqrt(Math.max(square * omega2 - radial * radial, 0));
  const p = random.onCircle();
  const outward = radial * random.gaussian();
  const onward = mean + along * random.gaussian();
  const vertical = Math.sqrt(Math.PI * surface * HEIGHT);
  const position = { x: radius * p.x, y: radius * p.y, z: HEIGHT * random.gaussian() };
  const velocity = {
    x: outward * p.x - onward * p.y,
    y: outward * p.y + onward * p.x,
    z: vertical * random.gaussian(),
  };
  setStar(stars, i, position, velocity);
}

/** Isotropic dispersion that supports the bulge in the total field: σ² = Ω² r²/2 in 2D, about a third in 3D. */
function putBulgeStar(stars: Stars, i: number, model: Model, random: Random, inside: number): void {
  const { bulge, dimensions } = model;
  const flat = dimensions === 2;
  const share = flat ? 0.95 * inside : 0.98 * inside + 1e-9;
  const radius = bulge.scale * (flat ? kuzminRadius(share) : plummerRadius(share));
  const { omega2 } = frequenciesAt(model, radius * radius);
  // The dispersion of a Plummer sphere, G M/(6 √(r² + a²)), scaled to the total field.
  const u = radius * radius + bulge.scale * bulge.scale;
  const sigma = Math.sqrt((omega2 * u) / (flat ? 4 : 6));
  const velocity = { x: sigma * random.gaussian(), y: sigma * random.gaussian(), z: sigma * random.gaussian() };
  setStar(stars, i, flat ? random.onCircle(radius) : random.onSphere(radius), velocity);
}
