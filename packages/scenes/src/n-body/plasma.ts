// A ball of electrons and ions in a magnetic field, neutral as a whole, whose electrons start to one side: it rings.
//
// Units: the ball's radius is 1 m, the charge of all electrons -1 C, their mass 1 kg and Coulomb's constant 1. In space
// (law 1/r²) and in the plane, where charges are lines and pull as 1/r, Gauss's law gives
//   ω_p² = 4π k n q²/m = 3 /s²        ω_p² = 2π k n q²/m = 2 /s²
// and the field of two balls that hardly miss each other is uniform where they overlap, so that the electrons swing at
//   ω_M² = ω_p²/3 = ω_p²/2 = 1 /s²    against ions that stand still (Mie 1908), (1 + m/M) times that against ions of mass M
// A field B along z turns what swings across it, as the Earth turns Foucault's pendulum: with ω_c = q B/m two circles, of
//   ω± = √(ω_M² + ω_c²/4) ± ω_c/2
// (Dubin & O'Neil, Rev. Mod. Phys. 71, 87, 1999). Softening as wide as the charges are apart leaves the collective field,
// but for the surface: it takes 3ε/2 of ω_M² in space, ε in the plane. A quiet start, places as even as can be, keeps the
// noise of chance from drowning the ringing (Birdsall & Langdon, Plasma Physics via Computer Simulation, ch. 16).
import {
  boris,
  cos,
  createPhysicsWorld,
  createRandom,
  type Integrator,
  type MutualForce,
  magneticField,
  mutualCoulomb,
  type PhysicsWorld,
  type Progress,
  pow,
  type Random,
  rgba,
  sin,
  spawnMany,
  type Vector,
} from '@principia/physics';
import { countOf, defineScene, type SceneRun } from '../scene.ts';
import { relativeErrorParameter } from './cluster.ts';
import { centreStars, emptyStars, inDimensions, type Stars, setStar } from './stars.ts';

/** A plasma; the ids of electrons and of ions are consecutive. */
export interface PlasmaRun extends SceneRun {
  readonly coulomb: MutualForce;
  readonly electrons: Uint32Array;
  readonly ions: Uint32Array;
  readonly forceError: (world: PhysicsWorld) => number;
}

/** Electrons and ions in a magnetic field that ring at their plasma frequency. */
export const plasma = defineScene({
  name: 'plasma',
  description: 'electrons and ions in a magnetic field that ring at their plasma frequency',
  precision: 'f32',
  parameters: {
    count: countOf('charges, half of them electrons', 20_000, 2_000_000, 2),
    relativeError: relativeErrorParameter,
    field: {
      about: 'angular frequency of gyration over that of the ringing',
      unit: '',
      initial: 0.5,
      min: 0,
      max: 100,
    },
    shift: { about: 'how far the electrons start to one side', unit: 'm', initial: 0.1, min: 0, max: 1 },
    thermal: { about: 'thermal speed of an electron along an axis', unit: 'm/s', initial: 0.1, min: 0, max: 10 },
    massRatio: { about: 'mass of an ion over that of an electron', unit: '', initial: 100, min: 1, max: 1e6 },
    softening: { about: 'softening over the distance of neighbours', unit: '', initial: 1, min: 0.1, max: 10 },
  },
  build({ dimensions, precision, seed, integrator, progress, parameters }): PlasmaRun {
    const { count, relativeError, field, shift, thermal, massRatio, softening } = parameters;
    const electrons = Math.floor(count / 2);
    const coulomb = mutualCoulomb({
      k: 1,
      relativeError,
      law: dimensions === 3 ? 'inverse-square' : 'inverse-distance',
      softening: softening * pow(electrons, -1 / dimensions),
    });
    const magnetic = magneticSetup(field, integrator);
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      integrator: magnetic.integrator,
      forces: [coulomb, ...magnetic.forces],
    });
    const random = createRandom(seed, 4);
    const shared = { world, dimensions, random };
    const minus = spawnSpecies({ ...shared, count: electrons, charge: -1, mass: 1, thermal, shift }, progress);
    const plus = spawnSpecies(
      { ...shared, count: count - electrons, charge: 1, mass: massRatio, thermal: thermal / Math.sqrt(massRatio) },
      progress,
    );
    const forceError = (of: PhysicsWorld) => coulomb.rmsError(of, 1000);
    return { world, dt: 1 / 64, coulomb, electrons: minus, ions: plus, forceError };
  },
});

/** Uses the integrator that includes the magnetic field, or a force with any other. The electrons' q/m is -1 C/kg. */
function magneticSetup(field: number, integrator: Integrator | undefined) {
  const own = boris({ field: { z: field } });
  if (integrator === undefined || integrator.name === own.name) return { integrator: own, forces: [] };
  return { integrator, forces: [magneticField({ z: field })] };
}

interface Species {
  readonly world: PhysicsWorld;
  readonly dimensions: 2 | 3;
  readonly random: Random;
  readonly count: number;
  /** Total charge and mass of the species, C and kg. */
  readonly charge: number;
  readonly mass: number;
  /** Standard deviation of each component of the velocity, m/s. */
  readonly thermal: number;
  /** Displacement of the ball along +x, m. */
  readonly shift?: number;
}

function spawnSpecies(species: Species, progress?: Progress): Uint32Array {
  const { world, dimensions, random, count, charge, mass, thermal, shift = 0 } = species;
  const bodies: Stars = emptyStars(count);
  const start = { turn: random.uniform(), height: random.uniform() };
  for (let i = 0; i < count; i++) {
    const speed = () => thermal * random.gaussian();
    setStar(bodies, i, placeInBall(i, count, start, dimensions), {
      x: speed(),
      y: speed(),
      z: dimensions === 3 ? speed() : 0,
    });
  }
  centreStars(bodies);
  for (let i = 0; i < count; i++) bodies.position.x[i] += shift;
  const looks = { color: charge < 0 ? rgba(0.45, 0.75, 1, 0.8) : rgba(1, 0.55, 0.35, 0.8), size: 0.008 };
  const columns = { ...inDimensions(bodies, dimensions), mass: mass / count, charge: charge / count };
  return spawnMany(world, count, { ...columns, appearance: looks }, progress);
}

/**
 * 1/p and 1/p² of the plastic number p, p³ = p + 1, and in 2D 1/φ of the golden ratio: their multiples are evenly
 * distributed.
 */
const QUASI_RANDOM = {
  2: { turn: 0.6180339887498949, height: 0 },
  3: { turn: 0.7548776662466927, height: 0.5698402909980532 },
};

/**
 * Point i of `count` that fill the unit ball or disc evenly: equal volumes in radius, a Kronecker sequence in angle.
 */
function placeInBall(i: number, count: number, start: { turn: number; height: number }, dimensions: 2 | 3): Vector {
  const { turn, height } = QUASI_RANDOM[dimensions];
  const radius = pow((i + 0.5) / count, 1 / dimensions);
  const angle = 2 * Math.PI * fraction(start.turn + i * turn);
  const up = dimensions === 3 ? 2 * fraction(start.height + i * height) - 1 : 0;
  const across = radius * Math.sqrt(1 - up * up);
  return { x: across * cos(angle), y: across * sin(angle), z: radius * up };
}

/** The fractional part. */
function fraction(value: number): number {
  return value - Math.floor(value);
}
