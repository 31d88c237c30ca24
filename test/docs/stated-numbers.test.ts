/** Numbers that pages state of what an engine does, and not of what physics says: they hold as long as the engine stays so. */
import {
  box,
  createPhysicsWorld,
  rigidBodies,
  type SoftStepOptions,
  softStep,
  spawn,
  springs,
  step,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { expect, test } from 'vitest';

/** Height to which a disc rises from the floor, m. */
function rise(height: number, restitution: number, radius: number, restitutionThreshold: number): number {
  const integrator = softStep({ restitutionThreshold });
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity({ y: -9.81 })], integrator });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(4, 1) } });
  const ball = spawn(world, { position: { y: height + radius }, collider: { radius, density: 100, restitution } });
  const { Position, Velocity } = world.components;
  let top = 0;
  for (let i = 0, hasHit = false; i < 120; i++) {
    step(world, 1 / 60);
    hasHit ||= Velocity.y[ball] > 0;
    if (hasHit) top = Math.max(top, Position.y[ball] - radius);
  }
  return top;
}

test('docs/rigid-bodies.md: what bounces rises to e² of its height within 0.4 % from 5 m, within 4 % from half a metre', () => {
  for (let i = 0; i < 10; i++) {
    const stretch = 1 + i / 50;
    expect(Math.abs(rise(5 * stretch, 0.5, 0.5, 1) / (1.25 * stretch) - 1)).toBeLessThan(4e-3);
    expect(Math.abs(rise(0.5 * stretch, 0.5, 0.5, 1) / (0.125 * stretch) - 1)).toBeLessThan(0.04);
  }
});

test('docs/rigid-bodies.md: a ball of 1 cm that falls from 4 cm with e = 0.7 stays down, or rises to 19 mm', () => {
  expect(rise(0.04, 0.7, 0.005, 1)).toBeLessThan(1e-4);
  expect(rise(0.04, 0.7, 0.005, 0.1)).toBeGreaterThan(0.0185);
  expect(rise(0.04, 0.7, 0.005, 0.1)).toBeLessThan(0.0197);
});

/** How far the lowest of a column of equal discs overlaps the next one at rest, m. */
function overlapOfColumn(count: number, dt: number, options: SoftStepOptions): number {
  const radius = 0.05;
  const forces = [uniformGravity({ y: -9.81 })];
  const world = createPhysicsWorld({ preset: rigidBodies, precision: 'f64', forces, integrator: softStep(options) });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(4, 1) } });
  for (const side of [-1, 1]) spawn(world, { position: { x: 0.56 * side, y: 5 }, collider: { shape: box(1, 12) } });
  const discs = Array.from({ length: count }, (_, i) =>
    spawn(world, { position: { y: (2 * i + 1) * radius }, collider: { radius, density: 1000 } }),
  );
  for (let i = 0; i < 4 / dt; i++) step(world, dt);
  const { x, y } = world.components.Position;
  return 2 * radius - Math.hypot(x[discs[1]] - x[discs[0]], y[discs[1]] - y[discs[0]]);
}

test.each([
  [1 / 60, {}],
  [1 / 60, { substeps: 16 }],
  [1 / 240, {}],
  [1 / 60, { substeps: 16, contactHertz: 120 }],
  [1 / 240, { contactHertz: 120 }],
] as const)(
  'docs/rigid-bodies.md: n discs press one into another by 2 n g/ω², in steps of %d s with %o',
  (dt, options) => {
    const { contactHertz = 30 } = options as SoftStepOptions;
    const expected = (2 * 20 * 9.81) / (2 * Math.PI * contactHertz) ** 2;
    // The lowest of 21 carries 20.
    expect(Math.abs(overlapOfColumn(21, dt, options) / expected - 1)).toBeLessThan(0.05);
  },
);

/** How much slower, as a factor, three bodies turn after ten seconds that began at 3 rad/s. */
function slowing(places: readonly (readonly [x: number, y: number])[], pairs: readonly (readonly [number, number])[]) {
  const world = createPhysicsWorld({ forces: [springs()], integrator: xpbd({ substeps: 4 }) });
  const velocityOf = ([x, y]: readonly [number, number]) => ({ x: -3 * y, y: 3 * x });
  const bodies = places.map((at) =>
    spawn(world, { position: { x: at[0], y: at[1] }, velocity: velocityOf(at), mass: 1 }),
  );
  for (const [a, b] of pairs) {
    const length = Math.hypot(places[a][0] - places[b][0], places[a][1] - places[b][1]);
    spawn(world, { spring: { a: bodies[a], b: bodies[b], stiffness: Number.POSITIVE_INFINITY, length } });
  }
  for (let i = 0; i < 600; i++) step(world, 1 / 60);
  const { Position, Velocity } = world.components;
  const sum = (part: (id: number) => number) => bodies.reduce((total, id) => total + part(id), 0);
  const momentum = sum((id) => Position.x[id] * Velocity.y[id] - Position.y[id] * Velocity.x[id]);
  return (3 * sum((id) => Position.x[id] ** 2 + Position.y[id] ** 2)) / momentum;
}

test('docs/soft-bodies.md: a ring that turns freely under xpbd is slowed down by √(1 + 2 ω² h t), a line is not', () => {
  const ring = [0, 1, 2].map((i) => [Math.cos((2 * Math.PI * i) / 3), Math.sin((2 * Math.PI * i) / 3)] as const);
  const exact = Math.sqrt(1 + (2 * 9 * 10) / 240);
  expect(
    Math.abs(
      slowing(ring, [
        [0, 1],
        [1, 2],
        [2, 0],
      ]) /
        exact -
        1,
    ),
  ).toBeLessThan(1e-2);
  expect(
    slowing(
      [
        [-1, 0],
        [0, 0],
        [1, 0],
      ],
      [
        [0, 1],
        [1, 2],
      ],
    ),
  ).toBeCloseTo(1, 9);
});
