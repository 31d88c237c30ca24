/**
 * One record of every law of the package, by the function that makes it, and a world in which each of them acts.
 * test/docs/forces.test.ts fails when a law is missing here: whatever goes over this list covers all laws.
 */
import type { Force, PhysicsWorld, PhysicsWorldOptions } from '@principia/physics';
import * as physics from '@principia/physics';
import { bodies, createPhysicsWorld, spawn } from '@principia/physics';

/** A law and its arguments; `make(...args)` with other arguments makes a variant. */
export interface LawRecord {
  /** The name of the exported function, with the variant if any. */
  readonly title: string;
  readonly maker: string;
  readonly args: readonly unknown[];
  /** Dimensions, if it works in 2D or 3D only. */
  readonly dimensions?: 2 | 3;
  /** Setup of a world before the law acts. */
  readonly arrange?: (force: Force, world: PhysicsWorld, subject: number) => void;
}

const pool = { density: 1000, gravity: { y: -10 }, level: 0.1 };
const triangle = [
  { x: -1, y: -1 },
  { x: 1, y: -1 },
  { x: 0, y: 1 },
];
/** Ids of `lawWorld`, whose bodies are created in this order. */
const [SOURCE, SUBJECT, SECOND, THIRD, FOURTH] = [1, 2, 3, 4, 5];
const TETRAHEDRON = [SUBJECT, SECOND, FOURTH, SUBJECT, THIRD, SECOND, SUBJECT, FOURTH, THIRD, SECOND, THIRD, FOURTH];

/** U = x² y + y² + z² per kilogram, and minus its gradient. */
function saddle(x: number, y: number, z: number, _time: number, out: { x: number; y: number; z: number }): void {
  out.x = -2 * x * y;
  out.y = -(x * x + 2 * y);
  out.z = -2 * z;
}
const potential = (x: number, y: number, z: number) => x * x * y + y * y + z * z;

function law(maker: string, ...args: unknown[]): LawRecord {
  return { title: maker, maker, args };
}

/** Every law with arguments for which it acts on the subject of `lawWorld`. */
export const LAW_RECORDS: readonly LawRecord[] = [
  law('uniformGravity', { x: 1, y: -10, z: 2 }),
  law('mutualGravity', { G: 1, softening: 0.1, law: 'inverse-square', relativeError: 0.005, method: 'auto' }),
  { ...law('mutualGravity', { G: 1, law: 'inverse-distance' }), title: 'mutualGravity, 1/r', dimensions: 2 },
  { ...law('mutualGravity', { G: 1, method: 'tree', relativeError: 0 }), title: 'mutualGravity, tree' },
  law('attractors', {}),
  { ...law('attractors', { lightSpeed: 10 }), title: 'attractors, relativistic' },
  law('uniformSphereGravity', { mu: 1, radius: 1 }),
  law('enclosedMassGravity', { radii: [0.5, 1, 3], masses: [0.5, 1, 2], gravitationalConstant: 1 }),
  law('paczynskiWiita', { mu: 1, horizon: 0.1 }),
  law('postNewtonian', { central: SOURCE, G: 1, speedOfLight: 10 }),
  ...[-7, -2, -1, 0, 1, 3].map((exponent) => ({
    ...law('powerLaw', { strength: 1, exponent }),
    title: `powerLaw of ${exponent}`,
  })),
  law('vortex', { strength: 1, radius: 1 }),
  law('lennardJones', { depth: 1, diameter: 1 }),
  law('yukawa', { strength: 1, range: 1, couplesTo: 'Charge' }),
  law('fixedCharges', 1),
  law('mutualCoulomb', { k: 1, softening: 0.1, method: 'direct' }),
  { ...law('mutualCoulomb', { k: 1, method: 'tree', relativeError: 0 }), title: 'mutualCoulomb, tree' },
  law('electricField', { x: 1, y: 2, z: 3 }),
  law('magneticField', { x: 1, y: 2, z: 3 }),
  law('accelerationField', saddle, { potential }),
  law('forceField', saddle, { potential }),
  law('springs'),
  law('linearDrag', { x: 1 }),
  law('quadraticDrag', { x: 1 }),
  law('sphereDrag', { density: 1, viscosity: 1, wind: { x: 1 } }),
  law('turbulentDrag', { mean: { x: 1 }, deviation: 1, largest: 1, smallest: 0.1, time: 1, modes: 8, seed: 1 }),
  law('lift', { span: { z: 1 }, frame: 'world', wind: { x: 1 } }),
  law('wing', {
    area: 2,
    lift: [
      [-0.3, -1.2],
      [0.3, 1.2],
      [0.6, 0.7],
    ],
    drag: [
      [-0.3, 0.1],
      [0, 0.02],
      [0.3, 0.1],
    ],
    position: { x: -1, y: 0.5 },
    incidence: 0.05,
    wind: { x: 1 },
  }),
  law('magnus', { density: 1, coefficient: 1, wind: { x: 1 } }),
  law('buoyancy', pool),
  { ...law('polygonBuoyancy', pool, { shape: 2, vertices: triangle }), dimensions: 2 },
  law('immersedDrag', { ...pool, flow: { x: 1 } }),
  law('addedMass', pool),
  law('thrust', { frame: 'world' }),
  { ...law('thrust', { frame: 'body', point: { x: 0, y: 1, z: 0.5 } }), title: 'thrust at a point' },
  law('motors', { heading: { x: 1 } }),
  law('rocketEngines', { frame: 'body' }),
  { ...law('rocketEngines', { frame: 'world' }), title: 'rocketEngines, in the axes of the world' },
  law('periodicDrive', { cosine: { x: 1 }, sine: { y: 1 }, angularFrequency: 1 }),
  law('randomDrive', { spectralDensity: 1, seed: 3 }),
  {
    ...law('pointerPull', { frequency: 0.3, dampingRatio: 1, maxForce: 1e3 }),
    arrange: (force, world, subject) => (force as physics.PointerPull).grab(world, subject, { x: 2, y: -1, z: 3 }),
  },
  {
    ...law('pointerPull', { frequency: 0.3, dampingRatio: 0, maxForce: 5 }),
    title: 'pointerPull at its greatest force',
    arrange: (force, world, subject) => (force as physics.PointerPull).grab(world, subject, { x: 2, y: -1, z: 3 }),
  },
  law('constantTorque', { x: 1, y: 2, z: 3 }),
  law('angularDrag'),
  law('stringTension', { pivot: { x: 0.1 }, length: 1 }),
  law('corneringGrip', { centre: { x: 0.1 }, friction: 1, gravity: 10 }),
  law('planeSupport', { point: {}, normal: { x: 1, y: 3 }, kineticFriction: 0.1, staticFriction: 0.2, gap: 100 }),
  {
    ...law('enclosedGas', {
      faces: [SUBJECT, SECOND, SECOND, THIRD, THIRD, SUBJECT],
      corners: 2,
      amount: 3,
      ambient: 0.5,
      reference: 1,
    }),
    title: 'enclosedGas in a ring',
    dimensions: 2,
  },
  {
    ...law('enclosedGas', { faces: TETRAHEDRON, corners: 3, amount: 3, ambient: 0.5, reference: 1 }),
    title: 'enclosedGas in a skin',
    dimensions: 3,
  },
  {
    ...law('clothWind', { triangles: TETRAHEDRON.slice(0, 3), velocity: { x: 1, z: 2 }, density: 1.2 }),
    dimensions: 3,
  },
];

type Maker = (...args: readonly unknown[]) => Force;

/** Returns the force of a record, or of other arguments. */
export function makeLaw({ maker, args }: LawRecord, other: readonly unknown[] = args): Force {
  return (physics as unknown as Record<string, Maker>)[maker](...other);
}

/** Returns the dimensions in which a law works. */
export function dimensionsOf({ dimensions }: LawRecord): readonly (2 | 3)[] {
  return dimensions === undefined ? [2, 3] : [dimensions];
}

/** Every law in each of its dimensions. */
export const LAW_CASES = LAW_RECORDS.flatMap((record) =>
  dimensionsOf(record).map((dimensions) => ({ name: `${record.title}, ${dimensions}D`, record, dimensions })),
);

/** All components that laws read, for a moving body. */
const BODY = {
  mass: 2,
  charge: 0.5,
  inertia: 0.3,
  collider: { radius: 0.5 },
  linearDrag: 0.2,
  quadraticDrag: 0.3,
  lift: 0.4,
  hull: { volume: 0.01, halfHeight: 0.5 },
  thrust: { x: 1, y: 2 },
  motor: 3,
  engine: { exhaustSpeed: 10, burnRate: 0.1, fuel: 1, y: 1 },
  angularDrag: 0.1,
};

/** Positions of the four moving bodies: outside of singularities, the subject half immersed. */
export const PLACES = [
  { x: 1.1, y: 0.3, z: 0.2 },
  { x: 2.3, y: 0.6, z: -0.4 },
  { x: 1.7, y: 1.9, z: 0.1 },
  { x: 1.6, y: 0.9, z: 1.8 },
] as const;

export interface LawWorld {
  readonly world: PhysicsWorld;
  readonly force: Force;
  /** The body under test. */
  readonly subject: number;
  /** All moving bodies. */
  readonly moving: readonly number[];
}

/**
 * A source of every field at the origin and four bodies with every component, the first tied to the second by a spring,
 * under one law.
 * @param before forces listed before the law
 */
export function lawWorld(
  record: LawRecord,
  dimensions: 2 | 3,
  options: PhysicsWorldOptions & { before?: readonly Force[]; wrap?: (force: Force) => Force; still?: boolean } = {},
): LawWorld {
  const { before = [], wrap = (force: Force) => force, still = false, ...rest } = options;
  const bare = makeLaw(record);
  const world = createPhysicsWorld({ capacity: 30, arenaBytes: 2 ** 20, dimensions, ...rest });
  const turns = dimensions === 2 ? { rotation: 0.2 } : { orientation: {} };
  spawn(world, { position: {}, attractor: 1, charge: 1, mass: 5 });
  const moving = PLACES.map(({ x, y, z }, i) =>
    spawn(world, {
      ...BODY,
      ...turns,
      hull: { ...BODY.hull, shape: record.maker === 'polygonBuoyancy' ? 2 : 0 },
      charge: 0.5 - i,
      position: { x, y, ...(dimensions === 3 ? { z } : {}) },
      velocity: still ? {} : { x: 0.3 * i - 0.7, y: 0.4 },
      angularVelocity: still ? {} : { z: 0.5 },
    }),
  );
  const [subject, second] = moving;
  spawn(world, { spring: { a: subject, b: second, stiffness: 7, damping: 0.1, length: 1 } });
  const force = wrap(bare);
  world.forces.push(...before, force);
  bodies(world);
  record.arrange?.(bare, world, subject);
  return { world, force, subject, moving };
}
