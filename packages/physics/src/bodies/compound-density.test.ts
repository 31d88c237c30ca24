// Compound bodies that lose parts: what is left has its own mass and goes on as it moved.
import {
  box,
  createJoint,
  despawn,
  gear,
  type PhysicsWorld,
  partsOf,
  prismatic,
  revolute,
  setCompoundDensity,
  setShape,
  spawn,
  spawnCompound,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

/** The blocks of an L of 1 m squares. */
const L = [
  { x: 0, y: 0 },
  { x: 1, y: 0 },
  { x: 2, y: 0 },
  { x: 2, y: 1 },
];

const DENSITY = 100;

const blocks = (places: readonly { x: number; y: number }[]) =>
  places.map((place) => ({ ...place, shape: box(1, 1), density: DENSITY, friction: 0.6 }));

/** Position and velocity of the centre of a part, from the motion of its body. */
function motionOf({ components }: PhysicsWorld, body: number, part: number) {
  const { Position, Velocity, AngularVelocity, Rotation, Attachment } = components;
  const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
  const dx = c * Attachment.x[part] - s * Attachment.y[part];
  const dy = s * Attachment.x[part] + c * Attachment.y[part];
  const w = AngularVelocity.z[body];
  return {
    x: Position.x[body] + dx,
    y: Position.y[body] + dy,
    vx: Velocity.x[body] - w * dy,
    vy: Velocity.y[body] + w * dx,
  };
}

describe.each(['f32', 'f64'] as const)('a cut compound in %s', (precision) => {
  // Coordinates are about 10 m, and each number is the sum of a few products.
  const tolerance = 64 * (precision === 'f32' ? 2 ** -24 : 2 ** -53) * 10;

  test('has mass, centre and inertia of the parts left, where they were, with their momentum', () => {
    const world = rigidWorld({ precision, forces: [] });
    const { Mass, Inertia, Position, Velocity, AngularVelocity } = world.components;
    const motion = { velocity: { x: 3, y: -1 }, angularVelocity: 2, rotation: 0.7 };
    const { body, parts } = spawnCompound(world, { position: { x: 4, y: 5 }, ...motion, parts: blocks(L) });
    const left = [parts[1], parts[2], parts[3]];
    despawn(world, parts[0]);
    const before = left.map((part) => motionOf(world, body, part));
    setCompoundDensity(world, body, DENSITY);
    left.forEach((part, i) => {
      const now = motionOf(world, body, part);
      for (const key of ['x', 'y', 'vx', 'vy'] as const)
        expect(Math.abs(now[key] - before[i][key])).toBeLessThan(tolerance);
    });
    // Three squares of 1 m²: the centroid is that of their centres, and each is (2/3, 1/3) or so away.
    const mean = (of: (each: (typeof before)[number]) => number) => before.reduce((sum, each) => sum + of(each) / 3, 0);
    expect(Mass.value[body]).toBeCloseTo(3 * DENSITY, 10);
    expect(Math.abs(Position.x[body] - mean(({ x }) => x))).toBeLessThan(tolerance);
    expect(Math.abs(Position.y[body] - mean(({ y }) => y))).toBeLessThan(tolerance);
    // Σ m (1/6 + r²) with r² = 5/9, 2/9 and 5/9: the corner of the L is nearest to the centroid.
    expect(Math.abs(Inertia.value[body] / (DENSITY * (3 / 6 + 12 / 9)) - 1)).toBeLessThan(tolerance);
    expect(Math.abs(Velocity.x[body] - mean(({ vx }) => vx))).toBeLessThan(tolerance);
    expect(Math.abs(Velocity.y[body] - mean(({ vy }) => vy))).toBeLessThan(tolerance);
    expect(AngularVelocity.z[body]).toBe(2);
  });

  test('lies on when it is one block of four', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
    const row = [0, 1, 2, 3].map((x) => ({ x, y: 0 }));
    const { body, parts } = spawnCompound(world, { position: { y: 0.5 }, parts: blocks(row) });
    run(world, 1);
    for (const part of parts.slice(1)) despawn(world, part);
    setCompoundDensity(world, body, DENSITY);
    run(world, 3);
    const { Mass, Inertia, Position, Rotation } = world.components;
    expect([Mass.value[body], partsOf(world, body).length]).toEqual([DENSITY, 1]);
    expect(Inertia.value[body] / (DENSITY / 6)).toBeCloseTo(1, 5);
    expect(Math.abs(Position.y[body] - 0.5)).toBeLessThan(2 * SLOP);
    // The weight of what went off rests on it for a sub-step: it rocks by no more than contacts overlap.
    expect(Math.abs(Position.x[body])).toBeLessThan(SLOP);
    expect(Math.abs(Rotation.angle[body])).toBeLessThan(1e-3);
  });
});

test('the joints of a cut compound stay where they are', () => {
  const world = rigidWorld({ forces: [] });
  const { body, parts } = spawnCompound(world, { rotation: 1, parts: blocks(L) });
  const { Position, Joint, Rotation } = world.components;
  const anchor = { x: Position.x[parts[3]], y: Position.y[parts[3]] };
  const joint = createJoint(world, revolute({ b: body, anchor }));
  despawn(world, parts[0]);
  setCompoundDensity(world, body, DENSITY);
  const [c, s] = [Math.cos(Rotation.angle[body]), Math.sin(Rotation.angle[body])];
  expect(Position.x[body] + c * Joint.bx[joint] - s * Joint.by[joint]).toBeCloseTo(anchor.x, 12);
  expect(Position.y[body] + s * Joint.bx[joint] + c * Joint.by[joint]).toBeCloseTo(anchor.y, 12);
  step(world, DT);
  expect(Math.abs(Position.x[parts[3]] - anchor.x)).toBeLessThan(1e-9);
});

test.each(['f32', 'f64'] as const)('the pinion of a rack that is cut does not turn, in %s', (precision) => {
  const world = rigidWorld({ forces: [], precision });
  const pinion = spawn(world, { position: { y: 5 }, collider: { radius: 1, density: 1 } });
  createJoint(world, revolute({ b: pinion, anchor: { y: 5 } }));
  const { body, parts } = spawnCompound(world, { position: { x: 3 }, rotation: 1, parts: blocks(L) });
  createJoint(world, prismatic({ b: body, anchor: { x: 3 }, axis: { x: 0.6, y: 0.8 } }));
  createJoint(world, gear({ a: pinion, b: body, ratio: 1, axis: { x: 0.6, y: 0.8 } }));
  step(world, DT);
  despawn(world, parts[0]);
  setCompoundDensity(world, body, DENSITY);
  const { Position, Rotation } = world.components;
  const { x } = motionOf(world, body, parts[3]);
  run(world, 1);
  // Rounding of coordinates of some metres.
  const tolerance = precision === 'f32' ? 1e-5 : 1e-12;
  expect(Math.abs(Rotation.angle[pinion])).toBeLessThan(tolerance);
  expect(Math.abs(Position.x[parts[3]] - x)).toBeLessThan(tolerance);
});

test('densities may differ, shapes may have changed, and a body that does not turn stays so', () => {
  const world = rigidWorld({ forces: [] });
  const { Mass, Inertia, Position } = world.components;
  const two = blocks(L.slice(0, 2));
  const { body, parts } = spawnCompound(world, { parts: two, inertia: Number.POSITIVE_INFINITY });
  setShape(world, parts[1], box(2, 1));
  setCompoundDensity(world, body, (part) => (part === parts[1] ? 1 : 4));
  // 4 kg at 0 and 2 kg at 1 m.
  expect([Mass.value[body], Inertia.value[body]]).toEqual([6, 0]);
  expect(Position.x[body]).toBeCloseTo(1 / 3, 12);
});

test('what cannot be weighed is refused, and nothing is changed', () => {
  const world = rigidWorld();
  const { body, parts } = spawnCompound(world, { parts: blocks(L) });
  const still = spawnCompound(world, { parts: [{ shape: box(1, 1) }] }).body;
  const codeOf = (act: () => void) => {
    try {
      act();
    } catch (error) {
      return (error as { code: string }).code;
    }
    return 'no error';
  };
  const { Mass } = world.components;
  expect(codeOf(() => setCompoundDensity(world, body, (part) => (part === parts[3] ? -1 : 1)))).toBe('E_RANGE');
  expect(codeOf(() => setCompoundDensity(world, body, Number.NaN))).toBe('E_NONFINITE');
  expect(codeOf(() => setCompoundDensity(world, still, 1))).toBe('E_RANGE');
  expect(codeOf(() => setCompoundDensity(world, 99, 1))).toBe('E_STALE');
  world.phases.input.push(() => expect(codeOf(() => setCompoundDensity(world, body, 1))).toBe('E_REENTRANT'));
  step(world, DT);
  expect(Mass.value[body]).toBe(4 * DENSITY);
  for (const part of parts) despawn(world, part);
  expect(codeOf(() => setCompoundDensity(world, body, 1))).toBe('E_RANGE');
});
