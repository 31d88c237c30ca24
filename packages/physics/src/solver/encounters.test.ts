// Bodies that fly into each other: the impact is that of the moment at which they meet, wherever in a step it falls.
import { createRandom, type PhysicsWorld, softStep, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** Gap at which the time of impact counts, m: 5 mm, met to a quarter. */
const MAX_GAP = 0.00625;
/** Rounding of f32 in a sum of some ten operations. */
const ROUNDING = 1e-6;

const RADII = [0.5, 0.3] as const;
const MASSES = [1, 2] as const;

/** A disc that flies along x at a disc at rest, whose centre is `offset` beside its way. Without friction. */
function encounter(precision: 'f32' | 'f64', speed: number, offset: number, start: number) {
  const world = rigidWorld({ precision, forces: [], integrator: softStep({ sleepTime: 0 }) });
  const [a, b] = RADII.map((radius, i) =>
    spawn(world, {
      position: i === 0 ? { x: -start, y: 0 } : { x: 0, y: offset },
      velocity: { x: i === 0 ? speed : 0, y: 0 },
      mass: MASSES[i],
      collider: { radius, restitution: 1, friction: 0 },
    }),
  );
  for (let t = 0; t < (2 * start) / speed; t += DT) step(world, DT);
  return { world, a, b };
}

const velocityOf = ({ components: { Velocity } }: PhysicsWorld, id: number) =>
  [Velocity.x[id], Velocity.y[id]] as const;

describe.each(['f32', 'f64'] as const)('two discs in %s', (precision) => {
  // Source: elastic impact of smooth spheres, for example Landau and Lifshitz, Mechanics, § 17: the disc that was at rest leaves
  // along the line of centres, at the speed 2 m v cos θ / (m + M), where sin θ is the offset over the sum of the radii.
  it.each([3, 10, 30])('part along their line of centres at the impact, at %i m/s', (speed) => {
    const random = createRandom(speed);
    const sum = RADII[0] + RADII[1];
    const [m, M] = MASSES;
    for (let n = 0; n < 40; n++) {
      const offset = random.uniform(-0.9, 0.9) * sum;
      const { world, a, b } = encounter(precision, speed, offset, random.uniform(2, 4));
      const [vx, vy] = velocityOf(world, b);
      const [ux, uy] = velocityOf(world, a);
      const sine = vy / Math.hypot(vx, vy);
      const [nearest, furthest] = [Math.abs(offset) / (sum + MAX_GAP), Math.abs(offset) / sum];
      expect(Math.sign(sine)).toBe(Math.sign(offset));
      expect(Math.abs(sine)).toBeGreaterThan(nearest - ROUNDING);
      expect(Math.abs(sine)).toBeLessThan(furthest + ROUNDING);
      const wanted = ((2 * m) / (m + M)) * speed * Math.sqrt(1 - sine * sine);
      expect(Math.abs(Math.hypot(vx, vy) / wanted - 1)).toBeLessThan(10 * ROUNDING);
      expect(Math.abs(m * ux + M * vx - m * speed)).toBeLessThan(10 * ROUNDING * m * speed);
      expect(Math.abs(m * uy + M * vy)).toBeLessThan(10 * ROUNDING * m * speed);
    }
  });
});
