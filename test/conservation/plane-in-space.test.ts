/** A world of two dimensions is one of three in which everything lies in a plane: the same to the bit. */
import { INTEGRATORS, type PhysicsWorldOptions, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { chain, heap, type Make, rope } from '../support/small-worlds.ts';

const UNITS = { m: 1, kg: 1, s: 1 };

const CASES: readonly { readonly name: string; readonly make: Make; readonly options?: PhysicsWorldOptions }[] = [
  { name: 'balls that do not turn', make: heap(false) },
  { name: 'a rope', make: rope },
  { name: 'a rope in f32', make: rope, options: { precision: 'f32' } },
  ...Object.entries(INTEGRATORS).map(([name, { create }]) => ({
    name: `a chain by ${name}`,
    make: chain,
    options: { integrator: create() },
  })),
];

it.each(CASES)('$name', ({ make, options = {} }) => {
  const [plane, space] = ([2, 3] as const).map((dimensions) => {
    const world = make(UNITS, { capacity: 300, ...options, dimensions });
    for (let i = 0; i < 60; i++) step(world, 1 / 64);
    return world;
  });
  const rows = plane.lastId + 1;
  for (const axis of ['x', 'y', 'z'] as const) {
    expect(space.components.Position[axis].slice(0, rows)).toEqual(plane.components.Position[axis].slice(0, rows));
    expect(space.components.Velocity[axis].slice(0, rows)).toEqual(plane.components.Velocity[axis].slice(0, rows));
  }
});
