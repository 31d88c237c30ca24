// A library on top of the packages, whose declarations TypeScript writes: `scripts/check-packages.mjs` compiles it with
// `declaration`, where the type of an export that nothing annotates has to consist of types that the packages export.
import {
  accelerationField,
  axialVector,
  axialVectorOverTime,
  bodies,
  boxWalls,
  columnsOf,
  contactEvents,
  createPhysicsWorld,
  createRunner,
  defineComponent,
  defineForce,
  defineIntegrator,
  defineLaw,
  energy,
  lawFromPotential,
  localSystem,
  mutualGravity,
  realField,
  restrictForce,
  scalar,
  snapshot,
  table,
  uniformGravity,
  vector,
  vectorOverTime,
} from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { createBodyLayer } from '@principia/render-pixi';
import { createBodyMesh } from '@principia/render-three';
import { gas } from '@principia/scenes';
import { startGame } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { openThreeView } from '@principia/shell/three';

export const bowl = defineLaw({
  name: 'bowl',
  parameters: { steepness: scalar('1/s²', { min: 0 }) },
  acceleration: ({ position }, { steepness }) => position.mul(steepness).negate(),
});
export const trap = lawFromPotential({
  name: 'trap',
  parameters: { depth: scalar('J'), width: scalar('m', { default: 1 }) },
  potential: ({ position }, { depth, width }) => position.lengthSquared().div(width.square()).exp().mul(depth),
});
export const parameters = [
  scalar('m'),
  scalar('m', { default: 1 }),
  vector('m'),
  vectorOverTime('m'),
  axialVector('T'),
  axialVectorOverTime('T'),
];
export const numbers = scalar('m', { default: 1 });
export const rows = table(['x', 'strength'], () => ({ at: 0, count: 0 }));

export const Sail = defineComponent({ fields: { area: realField('m²') } });
export const world = createPhysicsWorld({ components: [Sail], walls: [boxWalls({ min: { y: 0 } })] });
export const walls = boxWalls({ min: { y: 0 } });
export const sails = columnsOf(world, Sail);
export const { Position, Velocity } = world.components;
export const { previous, scratch, kernels, ranges, phases, faults } = world;

export const forces = [uniformGravity(), mutualGravity(), restrictForce(uniformGravity(), { from: 1 })];
export const wind = accelerationField((_x, y, _z, _time, out) => {
  out.x = y;
});
export const results = [
  energy(world),
  snapshot(world),
  contactEvents(world),
  bodies(world),
  createRunner(world),
] as const;
export const more = [defineForce, defineIntegrator, localSystem] as const;

export const source = worldSource(world);
export const drawn = () => [createBodyLayer({ source }), createBodyMesh({ source })] as const;
export const scene = gas;
export const start = [startGame, openPixiView, openThreeView] as const;
