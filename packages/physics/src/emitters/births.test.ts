// Data of one's own for particles: which were born, and that what waits to be one is not there.
import { addComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { defineComponent, real } from '../components/define.ts';
import { columnsOf } from '../ecs/own-components.ts';
import { attractors } from '../forces/attractors.ts';
import { fixedCharges } from '../forces/fixed-charges.ts';
import { mutualCoulomb } from '../n-body/mutual-coulomb.ts';
import { mutualGravity } from '../n-body/mutual-gravity.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { Force } from '../world/types.ts';
import { aliveCount, births, burst, createEmitter } from './emitter.ts';

const DT = 1 / 64;

describe('births', () => {
  test('are those of the last step, in their order', () => {
    const world = createPhysicsWorld();
    const emitter = createEmitter(world, { capacity: 8, lifetime: 1, speed: 0 });
    expect(births(emitter).count).toBe(0);
    burst(emitter, 3);
    step(world, DT);
    const { ids, count } = births(emitter);
    expect([...ids.subarray(0, count)]).toEqual([...emitter.ids.subarray(0, 3)]);
    step(world, DT);
    expect(births(emitter).count).toBe(0);
    burst(emitter, 2);
    step(world, DT);
    expect([...births(emitter).ids.subarray(0, births(emitter).count)]).toEqual([...emitter.ids.subarray(3, 5)]);
  });

  test('of a full pool that ends its oldest particles are those that are left', () => {
    const world = createPhysicsWorld();
    const emitter = createEmitter(world, { capacity: 4, lifetime: 9, speed: 0, whenFull: 'oldest' });
    for (let i = 0; i < 3; i++) burst(emitter, 3);
    step(world, DT);
    expect(births(emitter).count).toBe(4);
    expect(new Set(births(emitter).ids.subarray(0, 4)).size).toBe(4);
  });

  test('give each life its own data before the first step of it', () => {
    const Heat = defineComponent({ fields: { k: real('K', { initial: 300 }) } });
    const world = createPhysicsWorld({ components: [Heat] });
    const smoke = createEmitter(world, { capacity: 2, lifetime: 0.5, speed: 1 });
    const heat = columnsOf(world, Heat);
    for (const id of smoke.ids) addComponent(world, id, heat);
    world.phases.begin.push(() => {
      const { ids, count } = births(smoke);
      for (let i = 0; i < count; i++) heat.k[ids[i]] = 300;
    });
    world.phases.finish.push(() => {
      for (const id of smoke.ids) if (world.components.Mass.value[id] > 0) heat.k[id] -= 5;
    });
    for (let life = 0; life < 3; life++) {
      burst(smoke, 1);
      step(world, DT);
      expect(heat.k[births(smoke).ids[0]]).toBe(295);
      for (let i = 0; i < 40; i++) step(world, DT);
      expect(aliveCount(smoke)).toBe(0);
    }
  });
});

describe('what waits to be a particle is no source', () => {
  const sources: readonly (readonly [string, Force, 'Charge' | 'Attractor' | 'Mass'])[] = [
    ['mutualCoulomb', mutualCoulomb({ k: 1, softening: 0.1 }), 'Charge'],
    ['mutualCoulomb by the tree', mutualCoulomb({ k: 1, softening: 0.1, method: 'tree' }), 'Charge'],
    ['fixedCharges', fixedCharges(1), 'Charge'],
    ['attractors', attractors(), 'Attractor'],
    ['mutualGravity', mutualGravity({ G: 1 }), 'Mass'],
  ];

  test.each(sources)('%s', (name, force, component) => {
    const world = createPhysicsWorld({ precision: 'f64', forces: [force] });
    const { Charge, Attractor, Velocity } = world.components;
    const probe = spawn(world, { position: { x: 3 }, velocity: {}, mass: 1, charge: 1 });
    const emitter = createEmitter(world, { capacity: 64, lifetime: 0.5, speed: 0, position: { y: 4 } });
    for (const id of emitter.ids) {
      if (component === 'Charge') addComponent(world, id, set(Charge, { value: 1e-2 }));
      if (component === 'Attractor') addComponent(world, id, set(Attractor, { mu: 1e-2 }));
    }
    for (let i = 0; i < 8; i++) step(world, DT);
    expect([Velocity.x[probe], Velocity.y[probe]]).toEqual([0, 0]);
    burst(emitter, 1);
    step(world, DT);
    step(world, DT);
    // A particle acts from where it is: it pushes away from (0, 4), or pulls there. It has mass, so it is no fixed charge.
    const [vx, vy] = [Velocity.x[probe], Velocity.y[probe]];
    expect(Math.sign(vx * vy)).toBe(name === 'fixedCharges' ? 0 : -1);
    // Lifetime of 0.5 s, of which two steps are over.
    for (let i = 0; i < 31; i++) step(world, DT);
    expect(aliveCount(emitter)).toBe(0);
    const [x, y] = [Velocity.x[probe], Velocity.y[probe]];
    for (let i = 0; i < 8; i++) step(world, DT);
    expect([Velocity.x[probe], Velocity.y[probe]]).toEqual([x, y]);
  });

  test('but a charge that stands still among them is one', () => {
    const world = createPhysicsWorld({ precision: 'f64', forces: [mutualCoulomb({ k: 1 })] });
    createEmitter(world, { capacity: 64 });
    const probe = spawn(world, { position: { x: 3 }, velocity: {}, mass: 1, charge: 1 });
    spawn(world, { position: {}, charge: 9 });
    step(world, DT);
    // k q Q / r² = 1, over half a step after the drift: the place has changed by 1e-4.
    expect(Math.abs(world.components.Velocity.x[probe] / DT - 1)).toBeLessThan(1e-3);
  });
});
