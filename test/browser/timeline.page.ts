/** The page of `timeline.test.ts`: a fall on a floor, with a bar of its recorded time unless the address says `bare`. */
import { boxWalls, createPhysicsWorld, replaceForce, spawn, uniformGravity } from '@principia/physics';
import { startGame } from '@principia/shell';
import { openPixiView, type PixiView } from '@principia/shell/pixi';
import { paintBodies } from '../support/paint-bodies.ts';

let view: PixiView | undefined;

const lab = {
  /** Where the floor is on the page, CSS pixels from the top. */
  floor: () => view?.toScreen(0, 0, 0).y,
};

declare global {
  var timelineLab: typeof lab;
}

globalThis.timelineLab = lab;

startGame({
  title: 'A fall',
  hasTimeline: !new URLSearchParams(location.search).has('bare'),
  settings: { g: { kind: 'number', label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 0, max: 30, integer: false } },
  create({ values, seed }) {
    const floor = boxWalls({ min: { y: 0 } });
    const world = createPhysicsWorld({ seed, forces: [uniformGravity({ y: -values.g })], walls: [floor] });
    spawn(world, { position: { y: 0.3 }, velocity: {}, mass: 1, collider: { radius: 0.3 } });
    return { world, dt: 1 / 120 };
  },
  apply({ world }, _name, values) {
    replaceForce(world, uniformGravity({ y: -values.g }));
    return true;
  },
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      async open(context) {
        view = await openPixiView(context, {
          bounds: () => ({ minX: -2, minY: 0, maxX: 2, maxY: 5 }),
          paint: paintBodies,
        });
        return view;
      },
    },
  },
});
