// Rows in which entities wait to be a particle are left out of the work of a step.
import { addComponent, removeComponent } from 'bitecs';
import { describe, expect, it } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { bodies } from '../ecs/ranges.ts';
import { quadraticDrag } from '../forces/drag.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { defineForce } from '../laws/force.ts';
import { pairsWithin } from '../queries/pairs-within.ts';
import { bodyAt } from '../queries/pick.ts';
import { restore, snapshot } from '../snapshot/snapshot.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { localSystem } from '../world/systems.ts';
import { aliveCount, burst, createEmitter } from './emitter.ts';
import type { Emitter } from './types.ts';

const DT = 1 / 64;

/** A world whose emitter has this capacity, and the number of rows that local systems were given in the last step. */
function pool(capacity: number, lifetime = 1) {
  const world = createPhysicsWorld({
    capacity: 10_000,
    precision: 'f64',
    forces: [uniformGravity({ y: -10 }), quadraticDrag()],
  });
  const emitter = createEmitter(world, { capacity, lifetime, speed: [1, 5], quadraticDrag: 0.1 });
  const rows = { count: 0 };
  world.phases.begin.push(() => {
    rows.count = 0;
  });
  world.phases.finish.push(
    localSystem('count rows', (_, first, last) => {
      rows.count += last - first;
    }),
  );
  return { world, emitter, rows };
}

function living({ ids, world }: Emitter): number[] {
  return [...ids].filter((id) => world.components.Mass.value[id] > 0);
}

describe('what waits to be a particle', () => {
  it('takes part in no loop, wherever in the pool the living are', () => {
    const { world, emitter, rows } = pool(4096);
    step(world, DT);
    expect(rows.count).toBe(0);
    for (let turn = 0; turn < 100; turn++) {
      burst(emitter, 100);
      step(world, DT);
      expect(aliveCount(emitter)).toBe(100);
      // Slots are given in turn: the living are neighbours, in one group or at both ends, each in blocks of 16 rows.
      expect(rows.count).toBeGreaterThanOrEqual(100);
      expect(rows.count).toBeLessThanOrEqual(100 + 4 * 15);
      for (let i = 0; i < 65; i++) step(world, DT);
      expect(rows.count).toBe(0);
    }
  });

  it('does so beside bodies and other pools, and a body in the middle of them moves', () => {
    const { world, rows } = pool(1000);
    const ball = spawn(world, { position: {}, velocity: { x: 1 }, mass: 1 });
    createEmitter(world, { capacity: 1000 });
    for (let i = 0; i < 64; i++) step(world, DT);
    expect(world.components.Position.x[ball]).toBe(1);
    expect(rows.count).toBe(16);
  });

  it('changes no bit of the living: a pool that is nearly full computes the same', () => {
    const large = pool(8000);
    const small = pool(64);
    for (const { world, emitter } of [large, small]) {
      for (let i = 0; i < 40; i++) {
        if (i % 8 === 0) burst(emitter, 12);
        step(world, DT);
      }
    }
    const states = [large, small].map(({ world, emitter }) => {
      const { Position, Velocity } = world.components;
      return living(emitter).map((id) => [Position.x[id], Position.y[id], Velocity.x[id], Velocity.y[id]]);
    });
    expect(states[0]).toHaveLength(60);
    expect(states[0]).toEqual(states[1]);
  });

  it('goes on to the bit after a snapshot is restored', () => {
    const { world, emitter } = pool(2000);
    burst(emitter, 30);
    step(world, DT);
    const start = snapshot(world);
    const run = () => {
      burst(emitter, 20);
      for (let i = 0; i < 30; i++) step(world, DT);
      return stateHash(world);
    };
    const hash = run();
    restore(world, start);
    expect(run()).toBe(hash);
  });

  it('stays out while a force and a system ask for the bodies in the middle of a step', () => {
    const world = createPhysicsWorld({ capacity: 10_000, precision: 'f64' });
    const asks = (): void => {
      expect(bodies(world).count).toBe(2002);
      bodyAt(world, { x: 50 });
      pairsWithin(world, 1);
    };
    // 1 N on each body from its own row: the answer must not depend on who was asked meanwhile.
    const push = defineForce({
      name: 'push',
      equation: 'F = 1 N',
      reads: ['Mass'],
      local: true,
      accumulate({ components: { Mass }, scratch }, first, last) {
        asks();
        for (let row = first; row < last; row++) if (Mass.value[row] > 0) scratch.force.x[row] += 1;
      },
    });
    world.forces.push(push);
    const visited = new Set<number>();
    world.phases.events.push(
      localSystem('look', (_, first, last) => {
        asks();
        for (let row = first; row < last; row++) visited.add(row);
      }),
    );
    const low = spawn(world, { position: { x: -9 }, velocity: {}, mass: 1 });
    createEmitter(world, { capacity: 2000 });
    const high = spawn(world, { position: { x: 9 }, velocity: {}, mass: 1 });
    for (let i = 0; i < 64; i++) step(world, DT);
    const { Velocity } = world.components;
    expect([Velocity.x[low], Velocity.x[high]]).toEqual([1, 1]);
    expect([visited.has(low), visited.has(high)]).toEqual([true, true]);
  });

  it('moves again when the pool gave it up', () => {
    const { world, emitter } = pool(1000);
    const { Appearance, Mass, Velocity, Position, QuadraticDrag } = world.components;
    const [id] = emitter.ids;
    step(world, DT);
    removeComponent(world, id, Appearance);
    step(world, DT);
    addComponent(world, id, Appearance);
    Mass.value[id] = 1;
    QuadraticDrag.coefficient[id] = 0;
    Velocity.x[id] = 3;
    for (let i = 0; i < 64; i++) step(world, DT);
    expect(Position.x[id]).toBeCloseTo(3, 9);
  });
});
