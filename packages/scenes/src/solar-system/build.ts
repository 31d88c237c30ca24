// The solar system from JPL's states: Sun, planets, Moon and Pluto as mutually attracting points, with the first
// post-Newtonian term of the Sun. Lengths are in km, times in s, and a mass is its GM in km³/s², so that G = 1. Axes
// are those of the ecliptic of J2000; in 2D all positions are projected onto it.
import {
  createPhysicsWorld,
  gaussRadau,
  type Integrator,
  mutualGravity,
  PhysicsError,
  type PhysicsWorld,
  type Precision,
  postNewtonian,
  spawn,
  wisdomHolman,
} from '@principia/physics';
import { BODY_NAMES, type BodyName, type EpochState, OBLIQUITY, SPEED_OF_LIGHT, STATES } from './states.ts';
import { STATES_2012 } from './states-2012.ts';

/** Options of `buildSolarSystem`. */
export interface SolarSystemOptions {
  /** Default 3. */
  readonly dimensions?: 2 | 3;
  /** Default f64. */
  readonly precision?: Precision;
  /** Seed of the world; default 1. */
  readonly seed?: number;
  /** Default Gauss-Radau 15. Wisdom-Holman gets the gravitational constant of this world, G = 1. */
  readonly integrator?: Integrator;
  /** Default true; false replaces Earth and Moon by one body at their centre of mass. */
  readonly moon?: boolean;
  /** The post-Newtonian term of the Sun; default true. */
  readonly relativity?: boolean;
  /** Spare capacity for other bodies; default 0. */
  readonly others?: number;
  /** Which of JPL's states to start from: noon of 1 January 2000, the default, or midnight of 1 January 2012. */
  readonly epoch?: SolarEpoch;
}

/** Noon of 1 January 2000, or midnight of 1 January 2012. */
export type SolarEpoch = 2000 | 2012;

/** The world and the ids of its bodies. */
export interface SolarSystem {
  readonly world: PhysicsWorld;
  readonly ids: Readonly<Partial<Record<BodyName, number>>>;
}

/**
 * Sun, planets, Moon and Pluto as points that attract each other, from JPL's states. Lengths are in km, times in s, and a mass is its
 * GM in km³/s², so that G = 1; axes are those of the ecliptic of J2000, onto which positions are projected in 2D.
 * @throws PhysicsError E_RANGE if there is no such epoch, and what `createPhysicsWorld` throws
 */
export function buildSolarSystem(options: SolarSystemOptions = {}): SolarSystem {
  const { dimensions = 3, precision = 'f64', seed = 1, moon = true, relativity = true, others = 0 } = options;
  const epoch = options.epoch ?? 2000;
  if (epoch !== 2000 && epoch !== 2012)
    throw new PhysicsError('E_RANGE', `epoch must be 2000 or 2012, got ${epoch}.`, { field: 'epoch', value: epoch });
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
    const state = solarState(name, epoch, moon);
    const { position, velocity } = state;
    ids[name] = spawn(world, {
      position: dimensions === 2 ? { x: position.x, y: position.y } : position,
      velocity: dimensions === 2 ? { x: velocity.x, y: velocity.y } : velocity,
      mass: state.gm,
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

/** Position, km, and velocity, km/s, in ecliptic axes, and GM, km³/s². */
export interface SolarState {
  readonly gm: number;
  readonly position: Point3;
  readonly velocity: Point3;
}

type Point3 = { readonly x: number; readonly y: number; readonly z: number };

/** JPL's state of a body at an epoch. @param moon false: the state of the Earth is that of Earth and Moon as one body */
export function solarState(name: BodyName, epoch: SolarEpoch, moon = true): SolarState {
  const { gm, position, velocity } = name === 'earth' && !moon ? earthAndMoon(epoch) : stateAt(name, epoch);
  return { gm, position: ecliptic(position), velocity: ecliptic(velocity) };
}

function stateAt(name: BodyName, epoch: SolarEpoch): EpochState {
  return epoch === 2012 ? { ...STATES[name], ...STATES_2012[name] } : STATES[name];
}

/** Transforms from equatorial to ecliptic axes. */
function ecliptic([x, y, z]: readonly [number, number, number]): Point3 {
  const { cos, sin } = OBLIQUITY;
  return { x, y: cos * y + sin * z, z: cos * z - sin * y };
}

/** Earth and Moon as one body at their centre of mass. */
function earthAndMoon(epoch: SolarEpoch): EpochState {
  const [earth, moon] = [stateAt('earth', epoch), stateAt('moon', epoch)];
  const gm = earth.gm + moon.gm;
  const mean = (a: readonly [number, number, number], b: readonly [number, number, number]) =>
    a.map((value, axis) => (earth.gm * value + moon.gm * b[axis]) / gm) as [number, number, number];
  return { ...earth, gm, position: mean(earth.position, moon.position), velocity: mean(earth.velocity, moon.velocity) };
}
