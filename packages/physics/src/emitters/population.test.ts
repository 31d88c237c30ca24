import { describe, expect, test } from 'vitest';
import { emitting, living, run } from '../../../../test/support/emitting.ts';
import { step } from '../world/step.ts';
import { aliveCount, emitterCounts, moveEmitter } from './emitter.ts';
import type { EmitterOptions } from './options.ts';

describe('the number of living particles', () => {
  test('is exactly rate × lifetime for equal lifetimes', () => {
    const { world, emitter } = emitting({ rate: 37.5, lifetime: 2 });
    run(world, 10);
    expect(Math.abs(aliveCount(emitter) - 75)).toBeLessThanOrEqual(1);
    expect(living(emitter)).toHaveLength(aliveCount(emitter));
    const { born, ended, dropped } = emitterCounts(emitter);
    expect(born - ended).toBe(aliveCount(emitter));
    expect(dropped).toBe(0);
  });

  test('is rate × mean lifetime within statistical error (ch12-sparks: 60 × 7)', () => {
    const { world, emitter } = emitting({ rate: 60, lifetime: [6, 8] });
    run(world, 10, 1 / 30);
    let sum = 0;
    const samples = 200;
    for (let i = 0; i < samples; i++) {
      run(world, 0.5, 1 / 30);
      sum += aliveCount(emitter) / samples;
    }
    // Births are regular, deaths uniform over 2 s: the standard deviation is below sqrt(60 · 2 / 6), and samples 2 s
    // apart are independent.
    expect(Math.abs(sum - 420)).toBeLessThan((3 * Math.sqrt(20)) / Math.sqrt(samples / 4) + 1);
  });

  test('fractions of a birth accumulate', () => {
    const { world, emitter } = emitting({ rate: 0.7, lifetime: 1000 });
    run(world, 100);
    expect(emitterCounts(emitter).born).toBe(Math.floor(0.7 * (100 - 1 / 60)));
  });

  test('a full pool skips births and counts them, or ends the oldest (ch12-emitter)', () => {
    const skipping = emitting({ capacity: 120, rate: 30, lifetime: 100 });
    run(skipping.world, 10);
    expect(emitterCounts(skipping.emitter)).toEqual({ alive: 120, born: 120, ended: 0, dropped: 179 });
    const recycling = emitting({ capacity: 120, rate: 30, lifetime: 100, whenFull: 'oldest', speed: 0 });
    recycling.world.phases.input.push((w) => moveEmitter(recycling.emitter, { x: w.time }, true));
    run(recycling.world, 10);
    expect(emitterCounts(recycling.emitter)).toEqual({ alive: 120, born: 299, ended: 179, dropped: 0 });
    // Age at recycling: 120 births at 30 per second.
    const ages = living(recycling.emitter).map((eid) => 10 - recycling.world.components.Position.x[eid]);
    expect(Math.max(...ages)).toBeLessThan(4 + 0.1);
    expect(Math.min(...ages)).toBeLessThan(0.1);
  });

  test('a rate far beyond the capacity costs no time', () => {
    const { world, emitter } = emitting({ capacity: 10, rate: 1e9, lifetime: 100 });
    run(world, 1);
    expect(aliveCount(emitter)).toBe(10);
    expect(emitterCounts(emitter).dropped).toBeGreaterThan(9e8);
  });

  test('drops nothing where those that end in the step make room, however many are born in it', () => {
    const { world, emitter } = emitting({ capacity: 10, rate: 6000, lifetime: 0.001 });
    run(world, 1);
    // Of the 100 of a step, the six of the last millisecond are alive.
    const { alive, born, ended, dropped } = emitterCounts(emitter);
    expect([alive, born, ended, dropped]).toEqual([6, 5900, 5894, 0]);
  });

  test('a life shorter than a step is counted but never visible', () => {
    const { world, emitter } = emitting({ rate: 1000, lifetime: 0.001 });
    run(world, 1, 0.1);
    expect(emitterCounts(emitter).born).toBe(900);
    expect(aliveCount(emitter)).toBeLessThanOrEqual(1);
  });
});

describe('the length of the step', () => {
  const stream: Partial<EmitterOptions> = {
    rate: 200,
    lifetime: [0.5, 1.5],
    speed: [1, 3],
    spread: 0.3,
    positionSpread: { x: 0.1 },
  };

  /** Returns the living particles at 3 s, sorted by position. */
  function state(dt: number): string[] {
    const { world, emitter } = emitting(stream);
    const steps = Math.round(3 / dt) + 1;
    for (let i = 0; i < steps - 1; i++) step(world, dt);
    // A last, tiny step makes the births up to 3 s appear.
    step(world, 1e-9);
    const { x, y } = world.components.Position;
    return living(emitter)
      .map((eid) => `${x[eid].toFixed(6)},${y[eid].toFixed(6)}`)
      .sort();
  }

  test('does not change a stream without forces', () => {
    const fine = state(1 / 128);
    expect(fine.length).toBeGreaterThan(180);
    expect(state(1 / 64)).toEqual(fine);
    expect(state(1 / 16)).toEqual(fine);
  });

  test('leaves no gaps along the path of a moving emitter', () => {
    const { world, emitter } = emitting({ rate: 100, lifetime: 10, speed: 0 });
    for (let i = 1; i <= 10; i++) {
      moveEmitter(emitter, { x: i });
      step(world, 0.1);
    }
    const x = living(emitter)
      .map((eid) => world.components.Position.x[eid])
      .sort((a, b) => a - b);
    expect(x).toHaveLength(90);
    for (let i = 1; i < x.length; i++) expect(x[i] - x[i - 1]).toBeCloseTo(0.1, 9);
  });
});
