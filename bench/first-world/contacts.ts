/** The first world of a page, with an emitter and balls that collide with each other and a wall. */
import {
  boxWalls,
  createEmitter,
  createPhysicsWorld,
  linearDrag,
  particleContacts,
  spawnMany,
  step,
  uniformGravity,
} from '@principia/physics';
import { provideFirstWorld } from './first-world.ts';

provideFirstWorld((precision) => {
  const world = createPhysicsWorld({
    precision,
    preset: particleContacts,
    forces: [uniformGravity(), linearDrag()],
    walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 1000 } })],
  });
  const x = Float64Array.from({ length: 100 }, (_, i) => 0.9 * i);
  spawnMany(world, 100, { position: { x, y: 0.5 }, velocity: { x: 1 }, mass: 1, collider: { radius: 0.5 } });
  createEmitter(world, { capacity: 100, rate: 600, lifetime: 1, speed: 5, direction: { y: 1 } });
  step(world, 1 / 60);
});
