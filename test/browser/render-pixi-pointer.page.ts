/** The page of `render-pixi-pointer.test.ts`: a pixi canvas in a resizable box, with pointers and camera wired up. */
import { fit as fitCamera, listenToPointers, watchViewport } from '@principia/render-core';
import { applyCamera, createBodyLayer } from '@principia/render-pixi';
import { Application, Container } from 'pixi.js';
import { createTestBodySource } from '../support/body-source.ts';

const box = document.createElement('div');
box.style.cssText = 'width:400px;height:300px';
document.body.append(box);

const app = new Application();
await app.init({ background: 0x000000, preference: 'webgl', autoDensity: true });
box.append(app.canvas);

const source = createTestBodySource(1024);
source.size[1] = 2;
source.show([1]);
const layer = createBodyLayer({ source });
const world = new Container({ children: [layer.container] });
app.stage.addChild(world);

const camera = { x: 0, y: 0, pixelsPerMetre: 1 };
const log: (string | number)[][] = [];
const sizes: number[][] = [];
const viewport = watchViewport(app.canvas, (width, height, resolution) => {
  sizes.push([width, height, resolution]);
  app.renderer.resize(width, height, resolution);
});
fitCamera(camera, { minX: -10, minY: -7.5, maxX: 10, maxY: 7.5 }, viewport);

const move = (x: number, y: number) => {
  source.position.x[1] = source.previousPosition.x[1] = x;
  source.position.y[1] = source.previousPosition.y[1] = y;
  source.versions.pose++;
};
listenToPointers(app.canvas, {
  camera,
  pick: (x, y) => (Math.hypot(x - source.position.x[1], y - source.position.y[1]) <= source.size[1] ? 1 : 0),
  onGrab: (id) => log.push(['grab', id]),
  onDrag: (_, x, y) => move(x, y),
  onRelease: (id, x, y, vx, vy) => log.push(['release', id, x, y, vx, vy]),
});
app.ticker.add(() => {
  applyCamera(world, camera, viewport);
  layer.update(1);
});

export const pointerLab = {
  box,
  state: () => ({ camera: { ...camera }, x: source.position.x[1], y: source.position.y[1], log, sizes }),
};

declare global {
  var pixiPointerLab: typeof pointerLab;
}
globalThis.pixiPointerLab = pointerLab;
