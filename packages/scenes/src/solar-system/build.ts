// The solar system from JPL's states: Sun, planets, Moon and Pluto as mutually attracting points, with the first
// post-Newtonian term of the Sun. Lengths are in km, times in s, and a mass is its GM in km³/s², so that G = 1. Axes
// are those of the ecliptic of J2000; in 2D all positions are projected onto it.
import {
  createPhysicsWorld,
  gaussRadau,
  type Integrator,
  mutualGravity,
  type PhysicsWorld,
  type Precision,
  postNewtonian,
  spawn,
  wisdomHolman,
} from '@principia/physics';
import { BODY_NAMES, type BodyName, type EpochState, OBLIQUITY, SPEED_OF_LIGHT, STATES } from './states.ts';

export interface SolarSystemOptions {
  readonly dimensions?: 2 | 3;
  readonly precision?: Precision;
  readonly seed?: number;
  /** Default Gauss-Radau 15. Wisdom-Holman gets the gravitational constant of this world, G = 1. */
  readonly integrator?: Integrator;
  /** Default true; false replaces Earth and Moon by one body at their centre of mass. */
  readonly moon?: boolean;
  /** The post-Newtonian term of the Sun; default true. */
  readonly relativity?: boolean;
  /** Spare capacity for other bodies; default 0. */
  readonly others?: number;
}

/** The world and the ids of its bodies. */
export interface SolarSystem {
  readonly world: PhysicsWorld;
  readonly ids: Readonly<Partial<Record<BodyName, number>>>;
}

/** @throws PhysicsError E_CAPACITY */
export function buildSolarSystem(options: SolarSystemOptions = {}): SolarSystem {
  const { dimensions = 3, precision = 'f64', seed = 1, moon = true, relativity = true, others = 0 } = options;
  const world = createPhysicsWorld({
    dimensions,
    precision,
    seed,
    capacity: BODY_NAMES.length + others,
    integrator: inTheseUnits(options.integrator ?? gaussRadau()),
    forces: [mutualGravity({ G: 1 })],
  });
  const ids: Partial<Record<BodyName, number>> = {};
  for (const name of BODY_NAMES) {
    if (name === 'moon' && !moon) continue;
    const { gm, position, velocity } = name === 'earth' && !moon ? earthAndMoon() : STATES[name];
    ids[name] = spawn(world, {
      position: ecliptic(position, dimensions),
      velocity: ecliptic(velocity, dimensions),
      mass: gm,
    });
  }
  if (relativity) world.forces.push(postNewtonian({ central: ids.sun as number, G: 1, speedOfLight: SPEED_OF_LIGHT }));
  return { world, ids };
}

/** A default Wisdom-Holman would use G in SI units. */
function inTheseUnits(integrator: Integrator): Integrator {
  const map = wisdomHolman({ G: 1 });
  return integrator.name === map.name ? map : integrator;
}

/** Transforms from equatorial to ecliptic axes. */
function ecliptic(
  [x, y, z]: readonly [number, number, number],
  dimensions: 2 | 3,
): { x: number; y: number; z?: number } {
  const { cos, sin } = OBLIQUITY;
  const inPlane = { x, y: cos * y + sin * z };
  return dimensions === 2 ? inPlane : { ...inPlane, z: cos * z - sin * y };
}

/** Earth and Moon as one body at their centre of mass. */
function earthAndMoon(): EpochState {
  const { earth, moon } = STATES;
  const gm = earth.gm + moon.gm;
  const mean = (a: readonly [number, number, number], b: readonly [number, number, number]) =>
    a.map((value, axis) => (earth.gm * value + moon.gm * b[axis]) / gm) as [number, number, number];
  return { ...earth, gm, position: mean(earth.position, moon.position), velocity: mean(earth.velocity, moon.velocity) };
}
