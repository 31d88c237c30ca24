/** Worlds of all kinds move the same to the bit in other units. */
import { INTEGRATORS, type PhysicsWorldOptions, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { KILOGRAM, METRE, SECOND } from '../support/other-units.ts';
import { chain, heap, type Make, machine, rope, sparks, stars, type Units } from '../support/small-worlds.ts';

const AXES = ['x', 'y', 'z'] as const;

interface Case {
  readonly name: string;
  readonly make: Make;
  readonly options?: PhysicsWorldOptions;
  /** The units that may be others; by default all. */
  readonly free?: readonly (keyof Units)[];
}

/** Contacts of balls push overlaps out by some radii a second. */
const NO_TIME = ['m', 'kg'] as const;
/** Rigid bodies are solved by lengths and times that suit those of 0.1 to 10 m. */
const ONLY_MASS = ['kg'] as const;

const CASES: readonly Case[] = [
  { name: 'balls', make: heap(true), free: NO_TIME },
  { name: 'balls in space', make: heap(false), options: { precision: 'f32', dimensions: 3 }, free: NO_TIME },
  { name: 'rigid bodies on joints', make: machine, free: ONLY_MASS },
  { name: 'rigid bodies on joints in f32', make: machine, options: { precision: 'f32' }, free: ONLY_MASS },
  { name: 'a rope', make: rope },
  { name: 'a rope in f32', make: rope, options: { precision: 'f32' } },
  { name: 'stars', make: stars },
  { name: 'stars in space', make: stars, options: { precision: 'f32', dimensions: 3 } },
  { name: 'sparks', make: sparks, options: { precision: 'f32' } },
  ...Object.entries(INTEGRATORS)
    // It has a central mass and its gravity.
    .filter(([name]) => name !== 'wisdomHolman')
    .map(([name, { create }]) => ({ name: `a chain by ${name}`, make: chain, options: { integrator: create() } })),
];

describe('worlds move the same in other units', () => {
  /** Coordinates and velocities after 60 steps of 1/64 s, in metres and seconds. */
  function motion(make: Make, units: Units, options: PhysicsWorldOptions): number[] {
    const world = make(units, { capacity: 300, ...options });
    for (let i = 0; i < 60; i++) step(world, units.s / 64);
    const { Position, Velocity } = world.components;
    const ids = Array.from({ length: world.lastId }, (_, i) => i + 1);
    return ids.flatMap((id) =>
      AXES.flatMap((axis) => [Position[axis][id] / units.m, (Velocity[axis][id] * units.s) / units.m]),
    );
  }

  it.each(CASES)('$name', ({ make, options = {}, free = ['m', 'kg', 's'] }) => {
    const units = { m: 1, kg: 1, s: 1 };
    const ours = motion(make, units, options);
    const others = { m: METRE, kg: KILOGRAM, s: SECOND };
    const changed = free.map((unit) => [unit, others[unit]]);
    expect(motion(make, { ...units, ...Object.fromEntries(changed) }, options)).toEqual(ours);
    expect(ours.some((value) => Math.abs(value) > 1)).toBe(true);
  });
});
