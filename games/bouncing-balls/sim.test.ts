import { energy, restore, snapshot, stateHash, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { blast } from './blast.ts';
import { longestMove } from './longest-move.ts';
import { createBalls } from './sim.ts';

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

it.each([2, 3] as const)(
  'trails take a way across the room for none, and a fast flight for one, in %iD',
  (dimensions) => {
    const { room, radius } = make({ wrap: true }, dimensions);
    const longest = longestMove({ room });
    // Who leaves at a side is put to the other, and seen up to four steps later: 1 m at 15 m/s.
    for (const axis of ['x', 'z'] as const) {
      const across = room.max[axis] - room.min[axis] - 2 * radius;
      if (across > 0) expect(across).toBeGreaterThan(longest + 1);
    }
    expect(longest).toBeGreaterThan(2);
  },
);

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
  sim.log.add({ kind: 'pour', isOpen: true });
  run(sim, 1);
  const taken = snapshot(sim.world);
  run(sim, 1);
  const hash = stateHash(sim.world);
  sim.log.add({ kind: 'pour', isOpen: false });
  run(sim, 0.1);
  restore(sim.world, taken);
  run(sim, 1);
  expect(stateHash(sim.world)).toBe(hash);
});

it('lets go of the spout and the magnet that a restored moment has on', () => {
  const sim = make();
  sim.log.add({ kind: 'pour', isOpen: true });
  sim.log.add({ kind: 'magnet', x: 4, y: 2.5, z: 0 });
  run(sim, 0.1);
  const taken = snapshot(sim.world);
  sim.log.add({ kind: 'pour', isOpen: false });
  sim.log.add({ kind: 'magnet off' });
  run(sim, 0.1);
  const entries = [...sim.log.entries];
  sim.letGo();
  run(sim, 0.1);
  expect(sim.log.entries).toEqual(entries);
  restore(sim.world, taken);
  sim.letGo();
  run(sim, 0.1);
  expect(sim.log.entries.slice(2).map(({ input }) => input)).toEqual([
    { kind: 'pour', isOpen: false },
    { kind: 'magnet off' },
  ]);
});

/** Puts the first ball somewhere, at rest, and the others out of the way. */
function single(values: Partial<typeof VALUES>, x: number, y: number) {
  const sim = make(values);
  const { Position, Velocity } = sim.world.components;
  Velocity.x.fill(0);
  Velocity.y.fill(0);
  const [id] = sim.balls;
  Position.x[id] = x;
  Position.y[id] = y;
  return { sim, id, Velocity };
}

it('a magnet pulls by μ/r² as long as it is held', () => {
  const { sim, id, Velocity } = single({ count: 5 }, 2, 2.5);
  sim.log.add({ kind: 'magnet', x: 4, y: 2.5, z: 0 });
  // Forces change when the step with the input is over; the next one accelerates.
  step(sim.world, sim.dt);
  expect(Velocity.x[id]).toBe(0);
  step(sim.world, sim.dt);
  // The ball comes 11 mm nearer in the step, by which the pull of 160/2² m/s² grows by 1.1 %.
  expect(Velocity.x[id] / ((160 / 4) * sim.dt)).toBeGreaterThan(0.999);
  expect(Velocity.x[id] / ((160 / 4) * sim.dt)).toBeLessThan(1.012);
  expect(Velocity.y[id]).toBeCloseTo(0, 6);
  sim.log.add({ kind: 'magnet off' });
  step(sim.world, sim.dt);
  const speed = Velocity.x[id];
  step(sim.world, sim.dt);
  expect(Velocity.x[id]).toBe(speed);
});

it('a tilt turns gravity, and the panel sets its strength', () => {
  const { sim, id, Velocity } = single({ count: 5, gravity: 3 }, 3, 3);
  sim.tilt.setStrength(5);
  sim.log.add({ kind: 'tilt', x: 0.6, y: -0.8, z: 0 });
  step(sim.world, sim.dt);
  const before = { x: Velocity.x[id], y: Velocity.y[id] };
  for (let i = 0; i < 12; i++) step(sim.world, sim.dt);
  // 12 steps of 1/60 s at 5 m/s², to the rounding of 12 additions in f32.
  expect(Velocity.x[id] - before.x).toBeCloseTo(5 * 0.6 * 0.2, 6);
  expect(Velocity.y[id] - before.y).toBeCloseTo(-5 * 0.8 * 0.2, 6);
});

it.each([2, 3] as const)('a log of inputs gives the same run, in %iD', (dimensions) => {
  const values = { ...VALUES, gravity: 9.81, restitution: 0.8, collisions: true };
  const sim = createBalls({ values, seed: 3, dimensions });
  sim.log.add({ kind: 'tilt', x: 0.5, y: -0.75, z: -0.25 });
  run(sim, 0.5);
  sim.log.add({ kind: 'magnet', x: 4, y: 3, z: 1 });
  run(sim, 0.5);
  sim.log.add({ kind: 'magnet off' });
  sim.log.add({ kind: 'blast', x: 4, y: 1, z: 0 });
  sim.log.add({ kind: 'pour', isOpen: true });
  run(sim, 0.5);
  const again = createBalls({ values, seed: 3, dimensions, log: sim.log.entries });
  run(again, 1.5);
  expect(stateHash(again.world)).toBe(stateHash(sim.world));
  const other = createBalls({ values, seed: 3, dimensions });
  run(other, 1.5);
  expect(stateHash(other.world)).not.toBe(stateHash(sim.world));
});
