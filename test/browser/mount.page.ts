/** The page of `mount.test.ts`: games that start in an element of the page, or on all of it, and stop again. */
import { boxWalls, createPhysicsWorld, replaceForce, spawn, uniformGravity } from '@principia/physics';
import { createBodyMesh } from '@principia/render-three';
import { FOUR_WAYS, type GameDefinition, type RunningGame, type Simulation, startGame } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { openThreeView } from '@principia/shell/three';
import { paintBodies } from '../support/paint-bodies.ts';

type Fall = Simulation & { readonly pressed: string[] };

const SETTINGS = {
  g: { kind: 'number', label: 'Gravity', unit: 'm/s²', initial: 9.81, min: 0, max: 30, integer: false },
} as const;

const steps = new Map<Fall, () => number>();
const game: GameDefinition<typeof SETTINGS, Fall> = {
  title: 'A fall',
  hasTimeline: true,
  settings: SETTINGS,
  create({ values, seed }) {
    const floor = boxWalls({ min: { y: 0 } });
    const world = createPhysicsWorld({ seed, forces: [uniformGravity({ y: -values.g })], walls: [floor] });
    spawn(world, { position: { y: 4 }, velocity: {}, mass: 1, collider: { radius: 0.3, restitution: 1 } });
    const fall = { world, dt: 1 / 120, pressed: [] };
    steps.set(fall, () => world.tick);
    return fall;
  },
  apply({ world }, _name, values) {
    replaceForce(world, uniformGravity({ y: -values.g }));
    return true;
  },
  report: ({ pressed }) => ({ pressed }),
  controls: {
    buttons: FOUR_WAYS,
    press: ({ pressed }, name) => pressed.push(name),
    release() {},
  },
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      open: (context) =>
        openPixiView(context, {
          bounds: () => ({ minX: -2, minY: 0, maxX: 2, maxY: 5 }),
          paint: paintBodies,
        }),
    },
    three: {
      label: '3D',
      dimensions: 2,
      open: (context) =>
        openThreeView(context, {
          bounds: () => ({ min: { x: -2, y: 0, z: -1 }, max: { x: 2, y: 5, z: 1 } }),
          direction: { x: 0, y: 0, z: 1 },
          paint(_sim, source) {
            const { object, update, destroy } = createBodyMesh({ source });
            return { object, update, destroy };
          },
        }),
    },
  },
};

const lab = {
  running: [] as RunningGame[],
  /** Steps of all worlds together, those of stopped games too. */
  steps: () => [...steps.values()].reduce((sum, ticks) => sum + ticks(), 0),
  forget: () => steps.clear(),
  /** @param selector of the element; none for the whole page */
  start(selector?: string, query?: string): RunningGame {
    const parent = selector === undefined ? undefined : (document.querySelector(selector) as HTMLElement);
    const running = startGame(game, {
      ...(parent === undefined ? {} : { parent }),
      ...(query === undefined ? {} : { query }),
    });
    lab.running.push(running);
    return running;
  },
  stopAll() {
    for (const { stop } of lab.running.splice(0)) stop();
  },
};

declare global {
  var mountLab: typeof lab;
}

globalThis.mountLab = lab;
