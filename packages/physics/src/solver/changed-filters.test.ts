// Layers, masks, groups and `collide` of joints that change while bodies touch or overlap.
import { box, createJoint, distance, isAsleep, type PhysicsWorld, sensorEvents, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

const unit = { shape: box(1, 1), density: 1 };

function worldWithCrate(precision: 'f32' | 'f64', seconds: number) {
  const world = rigidWorld({ precision });
  const ground = spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1) } });
  const crate = spawn(world, { position: { y: 0.5 }, collider: unit });
  run(world, seconds);
  return { world, ground, crate };
}

function lowest(world: PhysicsWorld, id: number, steps: number): number {
  let y = Number.POSITIVE_INFINITY;
  for (let i = 0; i < steps; i++) {
    step(world, DT);
    y = Math.min(y, world.components.Position.y[id]);
  }
  return y;
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['mask', 0, 1],
    ['layers', 2, 1],
    ['group', -1, 0],
  ] as const)('two that overlap push each other apart from the step on in which their %s says so', (field, off, on) => {
    const world = rigidWorld({ precision, forces: [] });
    const [a, b] = [0, 0.8].map((x) => spawn(world, { position: { x }, collider: { ...unit, mask: 1, [field]: off } }));
    const { Collider, Position } = world.components;
    run(world, 0.5);
    expect(Position.x[b] - Position.x[a]).toBeCloseTo(0.8, 6);
    for (const id of [a, b]) Collider[field][id] = on;
    run(world, 2);
    expect(Position.x[b] - Position.x[a]).toBeGreaterThan(1 - SLOP);
  });

  it.each([
    ['static', {}],
    ['kinematic', { velocity: {}, kinematic: {} }],
  ] as const)('a %s door that becomes solid pushes out what sleeps in it', (_how, kind) => {
    const { world, crate } = worldWithCrate(precision, 0);
    const door = spawn(world, { ...kind, position: { x: -0.45, y: 1 }, collider: { shape: box(0.4, 2), mask: 0 } });
    run(world, 2);
    expect(isAsleep(world, crate)).toBe(true);
    world.components.Collider.mask[door] = 1;
    step(world, DT);
    expect(isAsleep(world, crate)).toBe(false);
    run(world, 2);
    expect(world.components.Position.x[crate]).toBeGreaterThan(0.25 - SLOP);
  });

  it('other layers of the ground, on which it still stands, do not wake a crate', () => {
    const { world, ground, crate } = worldWithCrate(precision, 2);
    world.components.Collider.layers[ground] = 3;
    step(world, DT);
    expect(isAsleep(world, crate)).toBe(true);
  });

  it.each([
    [0.3, 'awake'],
    [2, 'asleep'],
  ] as const)('a crate whose mask is off for a step does not sink, after %d s %s', (seconds, how) => {
    const { world, crate } = worldWithCrate(precision, seconds);
    expect(isAsleep(world, crate)).toBe(how === 'asleep');
    const { mask } = world.components.Collider;
    mask[crate] = 0;
    step(world, DT);
    mask[crate] = 1;
    // It fell for one step.
    expect(lowest(world, crate, 30)).toBeGreaterThan(0.5 - SLOP);
  });

  it('a sensor that begins to look sees what is in it', () => {
    const { world } = worldWithCrate(precision, 0.3);
    const sensor = spawn(world, { position: { y: 0.5 }, collider: { radius: 0.2, sensor: true, mask: 0 } });
    run(world, 0.2);
    world.components.Collider.mask[sensor] = 1;
    step(world, DT);
    expect(sensorEvents(world).begin.count).toBe(1);
  });

  it('joined bodies collide, or do not, from the step on in which the column says so', () => {
    const { world, ground, crate } = worldWithCrate(precision, 0.1);
    const { Joint, Position } = world.components;
    const joint = createJoint(world, distance({ a: ground, b: crate, limits: { upper: 50 }, collide: true }));
    run(world, 2);
    expect(isAsleep(world, crate)).toBe(true);
    Joint.collide[joint] = 0;
    run(world, 0.5);
    expect(Position.y[crate]).toBeLessThan(0);
    Position.y[crate] = 3;
    Joint.collide[joint] = 1;
    run(world, 2);
    expect(Math.abs(Position.y[crate] - 0.5)).toBeLessThan(SLOP);
  });
});
