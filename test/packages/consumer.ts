// A program of somebody who has installed the packages: `scripts/check-packages.mjs` compiles it against what npm would
// publish, strictly and with every declaration checked, as Node 16 and as bundlers resolve modules. Each
// `@ts-expect-error` fails that compilation where wrong use is no longer noticed, as where a type has become `any`.
import {
  createPhysicsWorld,
  defineLaw,
  discInertia,
  type PhysicsWorld,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { type BodySource, type Camera2D, fit as fitCamera, worldSource } from '@principia/render-core';
import { type BodyLayer, createBodyLayer } from '@principia/render-pixi';
import { type BodyMesh, createBodyMesh } from '@principia/render-three';
import { gas, type Scene } from '@principia/scenes';
import { type GameDefinition, type RunningGame, type Simulation, startGame } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { Container } from 'pixi.js';
import type { Object3D } from 'three';

const world: PhysicsWorld = createPhysicsWorld({
  dimensions: 3,
  precision: 'f32',
  forces: [uniformGravity({ y: -1 })],
});
const ball: number = spawn(world, { position: { x: 1 }, mass: 2, collider: { radius: 0.5 }, testParticle: {} });
const speed: number = world.components.Velocity.x[ball];
const inertia: number = discInertia(2, 0.5);
export const numbers: number[] = [speed, inertia];
// @ts-expect-error: no such option
createPhysicsWorld({ nonsense: true });
// @ts-expect-error: worlds have two or three dimensions
createPhysicsWorld({ dimensions: 4 });
// @ts-expect-error: a position has no such axis
spawn(world, { position: { w: 1 } });
// @ts-expect-error: a mark has no value
spawn(world, { position: {}, testParticle: true });
// @ts-expect-error: a law is an object that says what it computes
defineLaw(5);

const source: BodySource = worldSource(world);
const camera: Camera2D = { x: 0, y: 0, pixelsPerMetre: 1 };
fitCamera(camera, { minX: 0, minY: 0, maxX: 1, maxY: 1 }, { width: 100, height: 100 });
// @ts-expect-error: bounds have four sides
fitCamera(camera, { minX: 0 }, { width: 100, height: 100 });

export const layer = (): BodyLayer => createBodyLayer({ source });
export const container: Container = layer().container;
// @ts-expect-error: no such option
createBodyLayer({ source, nonsense: true });

export const mesh = (): BodyMesh => createBodyMesh({ source });
export const object: Object3D = mesh().object;
// @ts-expect-error: there are two forms
createBodyMesh({ source, form: 'nonsense' });

export const scene: Scene<'fraction'> = gas;
gas.create({ count: 10, fraction: 0.1 });
// @ts-expect-error: a gas has no such parameter
gas.create({ nonsense: 1 });

// biome-ignore lint/complexity/noBannedTypes: a game without settings
export const play = (game: GameDefinition<{}, Simulation>): RunningGame => startGame(game);
// @ts-expect-error: a game has a title
startGame({ nonsense: true });
export const view = openPixiView;
