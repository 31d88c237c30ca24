// Components that all particles of an emitter have.
import { describe, expect, it } from 'vitest';
import { codeOf, emitting, living, run } from '../../../../test/support/emitting.ts';
import { magneticField } from '../forces/magnetic-field.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { rungeKutta4 } from '../integrators/runge-kutta-4.ts';
import { burst } from './emitter.ts';

describe('particles of an emitter', () => {
  it.each([1, 2])('with a charge go round in a magnetic field, at m v/(q B), in life %i of their row', (life) => {
    const { world, emitter } = emitting(
      { capacity: 40, lifetime: 2, direction: { x: 1 }, spread: 0, speed: 3, mass: 0.5, charge: 2 },
      { precision: 'f64', forces: [magneticField({ z: 1.5 })], integrator: rungeKutta4 },
    );
    for (let each = 1; each < life; each++) {
      burst(emitter, 40);
      run(world, 2.5);
    }
    burst(emitter, 40);
    run(world, 1, 1 / 256);
    const { Position } = world.components;
    // A positive charge turns clockwise about a field towards us: its centre is below the start. A step turns it by ω h = 6/256,
    // of which the scheme errs by (ω h)⁵/120 = 6e-11, for 256 steps.
    const radius = (0.5 * 3) / (2 * 1.5);
    expect(living(emitter)).toHaveLength(40);
    for (const id of living(emitter)) {
      expect(Math.abs(Math.hypot(Position.x[id], Position.y[id] + radius) - radius)).toBeLessThan(256 * 6e-11);
    }
  });

  it('with a negative factor of gravity rise', () => {
    const { world, emitter } = emitting(
      { lifetime: 9, speed: 0, gravityScale: -0.25 },
      { precision: 'f64', forces: [uniformGravity({ y: -8 })] },
    );
    burst(emitter, 1);
    run(world, 2, 1 / 64);
    // Exact for a constant acceleration.
    expect(world.components.Velocity.y[living(emitter)[0]]).toBeCloseTo(2 * 2, 12);
  });

  it('refuses a charge and a factor that are no numbers', () => {
    expect(codeOf(() => emitting({ charge: Number.NaN }))).toBe('E_NONFINITE');
    expect(codeOf(() => emitting({ charge: '1' as never }))).toBe('E_TYPE');
    expect(codeOf(() => emitting({ gravityScale: 1e7 }))).toBe('E_RANGE');
  });

  it('pass its layers, mask and group on to the colliders, which keep them from one life to the next', () => {
    const { world, emitter } = emitting({
      capacity: 3,
      lifetime: 0.1,
      collider: { radius: 0.1, layers: 2, mask: 5, group: -1 },
    });
    burst(emitter, 3);
    run(world, 0.5);
    const { layers, mask, group } = world.components.Collider;
    for (const id of emitter.ids) expect([layers[id], mask[id], group[id]]).toEqual([2, 5, -1]);
  });
});
