// Force evaluations of an integrator whose result it does not use are not made.
import { expect, test } from 'vitest';
import { steps } from '../../../../test/support/worlds.ts';
import { createPhysicsWorld, defineForce, defineIntegrator, defineLaw, spawn, vec3 } from '../index.ts';

const byLaw = defineLaw({ name: 'push', acceleration: ({ time }) => vec3(0, time) });

/** The same force as user code, with the times at which it was asked for. */
function byFunction() {
  const times: number[] = [];
  const force = defineForce({
    name: 'push',
    accumulate({ scratch, components }, first, last, time) {
      times.push(time);
      for (let row = first; row < last; row++) scratch.force.y[row] += components.Mass.value[row] * time;
    },
  });
  return { force, times };
}

test.each(['first', 'last', 'nested'])('an unused evaluation, %s', (place) => {
  const integrator = defineIntegrator(
    { name: 'with an unused evaluation', order: 1, evaluations: 1, symplectic: false },
    ({ position, velocity, dt }, kick) => {
      if (place === 'first') kick(position, velocity, 0, dt);
      if (place === 'nested') kick(position, velocity.add(kick(position, velocity, 0, dt)), 0.25, dt);
      const after = velocity.add(kick(position, velocity, 0.5, dt));
      if (place === 'last') kick(position, after, 1, dt);
      return { position: position.add(after.mul(dt)), velocity: after };
    },
  );
  const { force, times } = byFunction();
  for (const each of [byLaw(), force]) {
    const world = createPhysicsWorld({ precision: 'f64', integrator, forces: [each] });
    const body = spawn(world, { position: {}, velocity: {}, mass: 2 });
    steps(world, 10, 0.5);
    // The midpoint rule is exact for a force that grows with time: v = t²/2.
    expect(world.components.Velocity.y[body]).toBe(12.5);
  }
  expect(new Set(times)).toEqual(new Set(Array.from({ length: 10 }, (_, i) => 0.5 * i + 0.25)));
});
