import { energy, restore, snapshot, stateHash, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { blast, createBalls } from './sim.ts';

const VALUES = { count: 40, gravity: 0, restitution: 1, drag: 0, friction: 0, collisions: false, wrap: false };

function make(values: Partial<typeof VALUES> = {}, dimensions: 2 | 3 = 2) {
  return createBalls({ values: { ...VALUES, ...values }, seed: 3, dimensions });
}

function run(sim: ReturnType<typeof make>, seconds: number) {
  for (let i = 0; i < seconds / sim.dt; i++) step(sim.world, sim.dt);
}

it.each([2, 3] as const)('balls that wrap around keep their velocity along the open sides, in %iD', (dimensions) => {
  const sim = make({ wrap: true }, dimensions);
  const { Position, Velocity } = sim.world.components;
  const axes = dimensions === 3 ? (['x', 'z'] as const) : (['x'] as const);
  const before = axes.map((axis) => Velocity[axis].slice());
  run(sim, 8);
  for (const [i, axis] of axes.entries()) {
    expect(Velocity[axis]).toEqual(before[i]);
    for (const id of sim.balls) {
      expect(Position[axis][id]).toBeGreaterThanOrEqual(sim.room.min[axis]);
      expect(Position[axis][id]).toBeLessThan(sim.room.max[axis]);
      // The picture between two steps shows no ball on its way through the room.
      expect(Math.abs(Position[axis][id] - sim.world.previous.Position[axis][id])).toBeLessThan(0.2);
    }
  }
});

it('a blast gives energy to what is near, away from its centre', () => {
  const sim = make();
  const { Position, Velocity } = sim.world.components;
  Velocity.x.fill(0);
  Velocity.y.fill(0);
  const [first] = sim.balls;
  const centre = { x: Position.x[first] - 0.5, y: Position.y[first], z: 0 };
  blast(sim, centre);
  expect(energy(sim.world).kinetic).toBeGreaterThan(0);
  for (const id of sim.balls) {
    const outwards = Velocity.x[id] * (Position.x[id] - centre.x) + Velocity.y[id] * (Position.y[id] - centre.y);
    expect(outwards).toBeGreaterThanOrEqual(0);
  }
});

it('pours the same balls after a rewind', () => {
  const sim = make({ gravity: 9.81, collisions: true });
  run(sim, 1);
  sim.spout.isOpen = true;
  run(sim, 1);
  const taken = snapshot(sim.world);
  run(sim, 1);
  const hash = stateHash(sim.world);
  sim.spout.isOpen = false;
  restore(sim.world, taken);
  expect(sim.spout.isOpen).toBe(true);
  run(sim, 1);
  expect(stateHash(sim.world)).toBe(hash);
});
