// Joints without springs, motors and limits add no energy, however bodies hang together.
import {
  box,
  createJoint,
  createRandom,
  distance,
  energy,
  type JointInput,
  type PhysicsWorld,
  prismatic,
  type Random,
  revolute,
  spawn,
  step,
  weld,
  wheel,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const pointNear = (random: Random, x: number, y: number, reach: number) => ({
  x: x + random.uniform(-reach, reach),
  y: y + random.uniform(-reach, reach),
});

/** A joint of any kind from a body, or from the world, to another one. */
function anyJoint(random: Random, world: PhysicsWorld, a: number, b: number): JointInput {
  const { x, y } = world.components.Position;
  const ends = a === 0 ? { b } : { a, b };
  const anchor = pointNear(random, x[b], y[b], 0.3);
  const axis = pointNear(random, 0, 0, 1);
  const anchorA = a === 0 ? pointNear(random, 0, 0, 3) : { x: x[a] + 0.1, y: y[a] };
  const kinds = [
    () => revolute({ ...ends, anchor }),
    () => distance({ ...ends, anchorA, anchorB: anchor }),
    () => weld({ ...ends, anchor }),
    () => prismatic({ ...ends, anchor, axis }),
    () => wheel({ ...ends, anchor, axis, spring: { hertz: 0 } }),
  ];
  return kinds[Math.floor(random.uniform(0, kinds.length))]();
}

/** Up to six boxes, of which each hangs on one before it, or on the world, sometimes on two. */
function mobile(random: Random, precision: 'f32' | 'f64'): PhysicsWorld {
  const world = rigidWorld({ precision });
  const ids: number[] = [0];
  const count = 1 + Math.floor(random.uniform(0, 6));
  for (let i = 0; i < count; i++) {
    const shape = box(10 ** random.uniform(-1, 0), 10 ** random.uniform(-1, 0));
    const collider = { shape, density: 10 ** random.uniform(-1, 1), mask: 0 };
    const position = pointNear(random, 0, 0, 2);
    const b = spawn(world, { position, rotation: random.uniform(-3, 3), collider });
    const joints = random.uniform(0, 1) < 0.2 ? 2 : 1;
    for (let k = 0; k < joints; k++) {
      createJoint(world, anyJoint(random, world, ids[Math.floor(random.uniform(0, ids.length))], b));
    }
    ids.push(b);
  }
  return world;
}

it.each(['f32', 'f64'] as const)('of a hundred random mobiles none gains energy, in %s', (precision) => {
  for (let seed = 1; seed <= 100; seed++) {
    const world = mobile(createRandom(seed), precision);
    const { Mass } = world.components;
    const weight = G * Array.from({ length: world.lastId }, (_, i) => Mass.value[i + 1]).reduce((a, b) => a + b);
    const start = energy(world).total;
    let kinetic = 0;
    let gain = 0;
    for (let i = 0; i < 180; i++) {
      step(world, DT);
      const now = energy(world);
      kinetic = Math.max(kinetic, now.kinetic);
      gain = Math.max(gain, now.total - start);
    }
    // First order: a sub-step of 4 ms errs by 2 % of a swing of a fifth of a second.
    expect(gain / weight, `seed ${seed}`).toBeLessThan(0.1 + (0.03 * kinetic) / weight);
  }
});
