// A world of default memory has room for all features at once, whatever its capacity.
import {
  boxWalls,
  burst,
  clothWind,
  createCloth,
  createEmitter,
  createPhysicsWorld,
  createSoftBody,
  destroyWorld,
  INTEGRATORS,
  type Integrator,
  mutualCoulomb,
  mutualGravity,
  type PhysicsWorld,
  type Preset,
  particleContacts,
  rigidBodies,
  softStep,
  spawn,
  springs,
  standard,
  step,
  uniformGravity,
  xpbd,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';

const CAPACITIES = [1, 64, 800, 1023, 1024, 1500, 3000];
const own = [...Object.values(INTEGRATORS).map(({ create }) => create()), xpbd({ substeps: 2, iterations: 1 })];

const cases = ([2, 3] as const).flatMap((dimensions) =>
  [
    { name: 'standard', preset: standard, integrators: own },
    { name: 'particleContacts', preset: particleContacts, integrators: own },
    ...(dimensions === 2 ? [{ name: 'rigidBodies', preset: rigidBodies, integrators: [softStep()] }] : []),
  ].flatMap(({ name, preset, integrators }) =>
    integrators.map((integrator) => ({ name, preset, dimensions, integrator, method: integrator.name })),
  ),
);

/** Fills a world with bodies, an emitter, a cloth in the wind and gas in a skin, as far as its capacity goes. */
function fill(world: PhysicsWorld): void {
  const { capacity, dimensions } = world;
  const count = Math.max(1, Math.floor(capacity / 4));
  for (let i = 0; i < count; i++) {
    spawn(world, { position: { x: 2 * (i % 60), y: 2 * Math.floor(i / 60) }, mass: 1, charge: 1e-9, collider: 0.4 });
  }
  if (capacity < 64) return;
  burst(createEmitter(world, { capacity: count }), 1);
  const corner = { x: -500, y: -500 };
  // A cloth has two springs a node.
  const columns = Math.floor(Math.sqrt(capacity / 16));
  const sheet = createCloth(world, { corner, columns, rows: columns, spacing: 1, mass: 1, structural: 10 });
  if (dimensions === 3) world.forces.push(clothWind({ triangles: sheet.triangles, velocity: { z: 1 } }));
  if (capacity < 3000) return;
  createSoftBody(world, { centre: { x: 500, y: 500 }, radius: 1, mass: 1, stiffness: 10, pressure: 1 });
}

function takesAStep(preset: Preset, integrator: Integrator, dimensions: 2 | 3, precision: 'f32' | 'f64'): void {
  for (const capacity of CAPACITIES) {
    for (const method of ['direct', 'tree'] as const) {
      const forces = [
        uniformGravity(),
        mutualGravity({ softening: 0.1, method }),
        mutualCoulomb({ softening: 0.1, method }),
        springs(),
      ];
      // A box takes one entity of a world of rigid bodies.
      const walls = capacity === 1 ? [] : [boxWalls({ min: { y: -1000 } })];
      const world = createPhysicsWorld({ capacity, dimensions, precision, preset, integrator, forces, walls });
      fill(world);
      step(world, 1e-4);
      // Springs that go slack have a kink, at which an adaptive integrator may ask for shorter steps (E_STEP).
      const codes = world.faults.faults.map(({ code }) => code).filter((code) => code !== 'E_STEP');
      expect([capacity, method, world.tick, ...codes]).toEqual([capacity, method, 1]);
      destroyWorld(world);
    }
  }
}

describe.each(['f32', 'f64'] as const)(
  'all features fit in a world of default memory and any capacity, %s',
  (precision) => {
    it.each(cases)('$name, $method, $dimensions D', ({ preset, integrator, dimensions }) => {
      takesAStep(preset, integrator, dimensions, precision);
    });
  },
);
