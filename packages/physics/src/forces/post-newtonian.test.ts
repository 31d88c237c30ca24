import { describe, expect, test } from 'vitest';
import { attractors, createPhysicsWorld, postNewtonian, rungeKutta4, spawn, step } from '../index.ts';

const G = 2;
const MASS = 3;
const MU = G * MASS;

/**
 * Computes an orbit of Mercury's shape about a mass with `epsilon` = μ/(c² a (1 - e²)), from pericentre.
 * @returns mean advance of the pericentre per revolution over `turns`, rad
 */
function advance(epsilon: number, turns: number, stepsATurn: number): number {
  const [a, e] = [1.5, 0.2056];
  const near = a * (1 - e);
  const speedOfLight = Math.sqrt(MU / (epsilon * a * (1 - e * e)));
  const world = createPhysicsWorld({ capacity: 10, forces: [attractors()], integrator: rungeKutta4 });
  const sun = spawn(world, { position: {}, mass: MASS, attractor: MU });
  world.forces.push(postNewtonian({ central: sun, G, speedOfLight }));
  const speed = Math.sqrt((MU / a) * ((1 + e) / (1 - e)));
  const planet = spawn(world, { position: { x: near }, velocity: { y: speed }, mass: 1 });
  const { Position: p, Velocity: v } = world.components;
  const radial = () => p.x[planet] * v.x[planet] + p.y[planet] * v.y[planet];
  const angle = () => Math.atan2(p.y[planet], p.x[planet]);
  const dt = (2 * Math.PI * Math.sqrt(a ** 3 / MU)) / stepsATurn;
  let passed = 0;
  let [before, from] = [radial(), angle()];
  for (;;) {
    step(world, dt);
    const [now, to] = [radial(), angle()];
    // At the pericentre the distance is minimal; r·v and the angle are odd functions of time about it.
    if (before < 0 && now >= 0 && ++passed === turns) return (from + ((to - from) * before) / (before - now)) / turns;
    [before, from] = [now, to];
  }
}

describe('the post-Newtonian correction', () => {
  test.each([1e-5, 4e-5])(
    'turns the pericentre by 6π μ/(c² a (1 - e²)) a revolution, where that is 6π · %d',
    (epsilon) => {
      // The next order is about 10 ε of it. A step is 1/2000 of a revolution: the error of Runge-Kutta 4, about
      // (2π/2000)⁴, is 1e-10 per revolution.
      const wanted = 6 * Math.PI * epsilon;
      expect(Math.abs(advance(epsilon, 10, 2000) / wanted - 1)).toBeLessThan(10 * epsilon + 1e-4);
    },
  );

  test('vanishes for an infinite speed of light: the ellipse is closed', () => {
    expect(Math.abs(advance(1e-18, 3, 2000))).toBeLessThan(1e-9);
  });
});
