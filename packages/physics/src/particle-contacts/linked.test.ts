import { describe, expect, test } from 'vitest';
import { spawn } from '../bodies/spawn.ts';
import { energy } from '../diagnostics/energy.ts';
import { springs } from '../forces/springs.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { particleContacts } from '../presets/particle-contacts.ts';
import { createCloth } from '../soft-bodies/cloth.ts';
import { createPhysicsWorld } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import { xpbd } from '../xpbd/xpbd.ts';
import { contacts } from './contacts.ts';

const make = (integrator = xpbd({ substeps: 5, iterations: 1 })) =>
  createPhysicsWorld({ dimensions: 3, preset: particleContacts, capacity: 2000, integrator, forces: [springs()] });

describe('bodies joined by a spring', () => {
  test.each([0.024, 0.026, 0.03])(
    'a free cloth at rest stays at rest, with colliders of %d m, 0.05 m apart',
    (radius) => {
      const world = make();
      createCloth(world, {
        corner: {},
        columns: 10,
        rows: 10,
        spacing: 0.05,
        mass: 0.1,
        shear: 500,
        pins: 'none',
        components: { collider: { radius } },
      });
      for (let s = 0; s < 120; s++) step(world, 1 / 60);
      // Rounding of positions of 0.5 m, 1e-16, over sub-steps of 1/300 s gives speeds of 3e-14 m/s: 1e-28 J for 0.1 kg.
      expect(energy(world).kinetic).toBeLessThan(1e-28);
    },
  );

  test.each([
    ['shorter than the sum of their radii, do not', 0.15, 0],
    ['longer than it, do', 0.25, 1],
  ])('collide: %s', (_, length, expected) => {
    const world = make(velocityVerlet);
    const collider = { radius: 0.1, restitution: 1 };
    const a = spawn(world, { position: {}, velocity: {}, mass: 1, collider });
    const b = spawn(world, { position: { x: 0.21 }, velocity: { x: -1 }, mass: 1, collider });
    spawn(world, { spring: { a, b, length, stiffness: 1e-3 } });
    let met = 0;
    for (let s = 0; s < 20; s++) {
      step(world, 1e-3);
      met = Math.max(met, contacts(world).count);
    }
    expect(met).toBe(expected);
    // Equal masses change their velocities; the spring gives 4e-7 N s.
    expect(world.components.Velocity.x[a]).toBeCloseTo(-expected, 5);
  });
});
