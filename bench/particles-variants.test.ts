import { energy, step } from '@principia/physics';
import { particles } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { applyVariant, LAW_COUNTS, variantParameters } from './particles-variants.ts';
import { inFlight } from './peers/in-flight.ts';

describe.each([2, 3] as const)('in %iD', (dimensions) => {
  const create = (options = {}) => particles.create({ count: 100, dimensions, ...options });

  test.each(LAW_COUNTS)('with %i laws bodies stay on the floor', (laws) => {
    const variant = { resting: true, laws };
    const { world, dt } = applyVariant(create(variantParameters(variant)), variant);
    expect(world.forces).toHaveLength(laws);
    for (let s = 0; s < 100; s++) step(world, dt);
    const { Position, Velocity, Collider } = world.components;
    for (let id = 1; id <= 100; id++) {
      expect(Position.y[id]).toBe(Collider.radius[id]);
      expect(Velocity.y[id]).toBe(0);
    }
    expect(world.faults.faults).toEqual([]);
  });

  test('every further law moves bodies in flight', () => {
    const kinetic = LAW_COUNTS.map((laws) => {
      const { world, dt } = applyVariant(create(), { resting: false, laws });
      for (let s = 0; s < 10; s++) step(world, dt);
      return energy(world).kinetic;
    });
    expect(new Set(kinetic).size).toBe(LAW_COUNTS.length);
  });

  test('the peer in flight is there where ours rest, with as many bodies and laws', () => {
    expect(inFlight(create())).toBeUndefined();
    const variant = { resting: true, laws: 3 } as const;
    const peer = inFlight(applyVariant(create(variantParameters(variant)), variant));
    expect(new Set(Array.from(peer?.positions('y') ?? []).filter((y) => y !== 0)).size).toBe(100);
  });
});
