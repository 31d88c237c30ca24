/** Small worlds of all kinds, measured in any units. */
import {
  box,
  boxWalls,
  circle,
  createEmitter,
  createJoint,
  createPhysicsWorld,
  createRope,
  linearDrag,
  mutualGravity,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  quadraticDrag,
  revolute,
  rigidBodies,
  spawn,
  springs,
  uniformGravity,
  xpbd,
} from '@principia/physics';

/** Our units in those in which a world is made. */
export interface Units {
  readonly m: number;
  readonly kg: number;
  readonly s: number;
}

export type Make = (units: Units, options: PhysicsWorldOptions) => PhysicsWorld;

const gravityOf = ({ m, s }: Units) => uniformGravity({ y: (-10 * m) / (s * s) });

/** Balls of several sizes that fall on each other in a box, and turn or do not. */
export const heap =
  (turns: boolean): Make =>
  (units, options) => {
    const { m, kg, s } = units;
    const walls = [boxWalls({ min: { x: 0, y: 0 }, max: { x: 10 * m }, restitution: 0.5, friction: 0.3 })];
    const world = createPhysicsWorld({ ...options, preset: particleContacts, forces: [gravityOf(units)], walls });
    for (let i = 0; i < 80; i++) {
      spawn(world, {
        position: { x: (0.7 + 1.2 * (i % 8)) * m, y: (0.7 + 1.2 * Math.floor(i / 8)) * m },
        velocity: { x: (((i * 7) % 5) * m) / s },
        mass: (0.5 + ((i * 3) % 7) / 7) * kg,
        ...(turns ? { rotation: 0 } : {}),
        collider: { radius: (0.2 + ((i * 5) % 11) / 40) * m, restitution: 0.4, friction: 0.5 },
      });
    }
    return world;
  };

/** An elastic chain that hangs by its end in air, with the scheme of `options`. */
export const chain: Make = (units, options) => {
  const { m, kg, s } = units;
  const forces = [gravityOf(units), springs(), linearDrag(), quadraticDrag()];
  const world = createPhysicsWorld({ ...options, forces });
  const links = Array.from({ length: 12 }, (_, i) =>
    spawn(world, {
      position: { x: i * m },
      velocity: { y: (i * m) / s },
      linearDrag: (0.01 * kg) / s,
      quadraticDrag: (0.001 * kg) / m,
      ...(i === 0 ? {} : { mass: kg }),
    }),
  );
  const spring = { stiffness: (200 * kg) / (s * s), damping: kg / s, length: m };
  for (let i = 1; i < links.length; i++) spawn(world, { spring: { a: links[i - 1], b: links[i], ...spring } });
  return world;
};

/** A motor that lifts a chain out of a heap of boxes and balls, one of them heavy. */
export const machine: Make = (units, options) => {
  const { kg } = units;
  const world = createPhysicsWorld({ ...options, preset: rigidBodies, forces: [gravityOf(units)] });
  const post = spawn(world, { position: { y: -1 }, collider: { shape: box(80, 2), friction: 0.6 } });
  let last = post;
  for (let i = 0; i < 8; i++) {
    const b = spawn(world, {
      position: { x: i + 0.5, y: 6 },
      rotation: 0,
      collider: { shape: box(1, 0.2), density: kg },
    });
    const motor = { speed: 1, max: 300 * kg };
    const [first, others] = [{ motor }, { limits: { lower: -0.5, upper: 0.5 } }];
    createJoint(world, revolute({ a: last, b, anchor: { x: i, y: 6 }, ...(i === 0 ? first : others) }));
    last = b;
  }
  for (let i = 0; i < 24; i++) {
    const shape = i % 2 === 0 ? box(1, 0.7) : circle(0.4);
    const collider = { shape, density: (i === 9 ? 30 : 1) * kg, friction: 0.6, restitution: 0.3 };
    spawn(world, { position: { x: 4 + ((i * 5) % 7) / 2, y: 7 + 0.7 * i }, rotation: i, collider });
  }
  return world;
};

/** A rope between two pins, inextensible. */
export const rope: Make = (units, options) => {
  const { m, kg } = units;
  const forces = [gravityOf(units), springs()];
  const world = createPhysicsWorld({ ...options, forces, integrator: xpbd({ substeps: 4, iterations: 4 }) });
  createRope(world, { from: {}, to: { x: 10 * m }, nodes: 24, mass: kg, length: 12 * m, pins: 'both' });
  return world;
};

/** A cluster of stars, by the tree. */
export const stars: Make = ({ m, kg, s }, options) => {
  const G = (m * m * m) / (kg * s * s);
  const world = createPhysicsWorld({ ...options, forces: [mutualGravity({ G, softening: 0.05 * m, method: 'tree' })] });
  for (let i = 0; i < 200; i++) {
    const [x, y, z] = [7, 11, 13].map((prime) => ((i * prime) % 17) + i / 40 - 10);
    const position = world.dimensions === 2 ? { x: x * m, y: y * m } : { x: x * m, y: y * m, z: z * m };
    spawn(world, { position, velocity: {}, mass: 0.05 * kg });
  }
  return world;
};

/** Sparks of an emitter, in air. */
export const sparks: Make = (units, options) => {
  const { m, kg, s } = units;
  const world = createPhysicsWorld({ ...options, forces: [gravityOf(units), linearDrag()] });
  createEmitter(world, {
    capacity: 200,
    rate: 60 / s,
    lifetime: 2 * s,
    speed: (5 * m) / s,
    direction: { y: 1 },
    spread: 1,
    mass: kg,
    linearDrag: (0.2 * kg) / s,
  });
  return world;
};
