/** Creates worlds that together use every kernel module, in a bundle with all exports. */
import * as physics from '@principia/physics';
import { type FirstWorld, provideFirstWorld } from './first-world.ts';

const {
  particleContacts,
  createCloth,
  createEmitter,
  createPhysicsWorld,
  dormandPrince,
  explode,
  linearDrag,
  mutualGravity,
  periodicDrive,
  spawn,
  springs,
  step,
  uniformGravity,
  xpbd,
} = physics;

provideFirstWorld((precision) => {
  for (const start of [contacts, cloth, stars]) start(precision);
});

const contacts: FirstWorld = (precision) => {
  const forces = [uniformGravity(), linearDrag(), periodicDrive({ angularFrequency: 1, sine: { x: 1 } })];
  const world = createPhysicsWorld({ precision, preset: particleContacts, forces });
  for (let x = 0; x < 100; x++) spawn(world, { position: { x }, mass: 1, collider: { radius: 0.6 } });
  createEmitter(world, { capacity: 100, rate: 600, lifetime: 1, speed: 5, direction: { y: 1 } });
  explode(world, { impulse: 1, radius: 10 });
  step(world, 1 / 60);
};

const cloth: FirstWorld = (precision) => {
  const world = createPhysicsWorld({
    dimensions: 3,
    precision,
    integrator: xpbd({ substeps: 2, iterations: 1 }),
    forces: [uniformGravity(), springs()],
  });
  createCloth(world, { corner: {}, columns: 20, rows: 20, spacing: 0.05, mass: 0.3, shear: 500 });
  step(world, 1 / 60);
};

const stars: FirstWorld = (precision) => {
  const world = createPhysicsWorld({
    precision,
    integrator: dormandPrince(),
    forces: [mutualGravity({ G: 1, softening: 0.1 })],
  });
  for (let x = 0; x < 100; x++) spawn(world, { position: { x, y: x % 7 }, mass: 1 });
  step(world, 1 / 60);
};

// Keeps exports that no world uses in the bundle.
Object.assign(globalThis, { physics });
