/** The page of `failing-world.test.ts`: a game whose worlds of some dimensions cannot be made, `?failing=2,3` at the start. */
import { createPhysicsWorld, spawn } from '@principia/physics';
import { createBodyMesh } from '@principia/render-three';
import { startGame } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { openThreeView } from '@principia/shell/three';
import { paintBodies } from '../support/paint-bodies.ts';

const lab = { failing: (new URLSearchParams(location.search).get('failing') ?? '').split(',').map(Number) };

declare global {
  var failingLab: typeof lab;
}

globalThis.failingLab = lab;

startGame(
  {
    title: 'A drift',
    hasTimeline: true,
    settings: { v: { kind: 'number', label: 'Speed', unit: 'm/s', initial: 0.1, min: 0, max: 30, integer: false } },
    create({ values, seed, dimensions }) {
      if (lab.failing.includes(dimensions)) throw new Error(`There is no room of ${dimensions} dimensions.`);
      const world = createPhysicsWorld({ seed });
      spawn(world, { position: {}, velocity: { x: values.v }, mass: 1, collider: { radius: 0.3 } });
      return { world, dt: 1 / 120 };
    },
    apply: () => false,
    renderers: {
      pixi: {
        label: '2D',
        dimensions: 2,
        open: (context) =>
          openPixiView(context, {
            bounds: () => ({ minX: -2, minY: -2, maxX: 2, maxY: 2 }),
            paint: paintBodies,
          }),
      },
      three: {
        label: '3D',
        dimensions: 3,
        open: (context) =>
          openThreeView(context, {
            bounds: () => ({ min: { x: -2, y: -2, z: -2 }, max: { x: 2, y: 2, z: 2 } }),
            direction: { x: 0, y: 0, z: 1 },
            paint(_sim, source) {
              const { object, update, destroy } = createBodyMesh({ source });
              return { object, update, destroy };
            },
          }),
      },
    },
  },
  { query: '' },
);
