/** The first world of a page, with particles under two laws in a box. */
import { boxWalls, createPhysicsWorld, quadraticDrag, spawnMany, step, uniformGravity } from '@principia/physics';
import { provideFirstWorld } from './first-world.ts';

provideFirstWorld((precision) => {
  const world = createPhysicsWorld({
    precision,
    forces: [uniformGravity(), quadraticDrag()],
    walls: [boxWalls({ min: { x: 0, y: 0 }, max: { x: 1000 } })],
  });
  const x = Float64Array.from({ length: 100 }, (_, i) => i);
  spawnMany(world, 100, { position: { x, y: 1 }, velocity: { x: 1 }, mass: 1, quadraticDrag: 0.01 });
  step(world, 1 / 60);
});
