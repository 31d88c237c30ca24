/** The page of `view-refresh.test.ts`: a ball in a box whose size is a setting, painted at the second attempt. */
import { createPhysicsWorld, spawn } from '@principia/physics';
import { createBodyLayer } from '@principia/render-pixi';
import { createBodyMesh } from '@principia/render-three';
import { type Simulation, startGame, type View } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { openThreeView } from '@principia/shell/three';

type Box = Simulation & { readonly size: number };

let view: View | undefined;
let attempts = 0;
const fails = new URLSearchParams(location.search).get('tab') === 'fails';

function refuseOnce(): void {
  attempts++;
  if (fails && attempts === 1) throw new Error('no picture yet');
}

const lab = {
  /** Where the upper right corner of the box is on the canvas, CSS pixels. */
  corner(): number[] {
    const size = __game.state().values.size as number;
    const { x, y } = view?.toScreen(size, size, 0) ?? { x: 0, y: 0 };
    return [Math.round(x), Math.round(y)];
  },
  camera: () => view?.camera?.() ?? [],
};

declare global {
  var viewLab: typeof lab;
}

globalThis.viewLab = lab;

startGame<
  { size: { kind: 'number'; label: string; unit: string; initial: number; min: number; max: number; integer: false } },
  Box
>({
  title: 'A box',
  settings: { size: { kind: 'number', label: 'Size', unit: 'm', initial: 2, min: 1, max: 40, integer: false } },
  create({ values: { size } }) {
    const world = createPhysicsWorld({ capacity: 1 });
    spawn(world, { position: {}, mass: 1, collider: 0.1 * size });
    return { world, dt: 1 / 60, size };
  },
  apply: () => false,
  renderers: {
    pixi: {
      label: '2D',
      dimensions: 2,
      async open(context) {
        view = await openPixiView(context, {
          bounds: ({ size }) => ({ minX: -size, minY: -size, maxX: size, maxY: size }),
          paint(_sim, source) {
            refuseOnce();
            const { container, update, destroy } = createBodyLayer({ source });
            return { container, update, destroy };
          },
        });
        return view;
      },
    },
    three: {
      label: '3D',
      dimensions: 2,
      async open(context) {
        view = await openThreeView(context, {
          bounds: ({ size }) => ({ min: { x: -size, y: -size, z: 0 }, max: { x: size, y: size, z: 0 } }),
          direction: { x: 0, y: 0, z: 1 },
          paint(_sim, source) {
            refuseOnce();
            const { object, update, destroy } = createBodyMesh({ source });
            return { object, update, destroy };
          },
        });
        return view;
      },
    },
  },
});
