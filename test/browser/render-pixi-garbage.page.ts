/** The page of `render-pixi-garbage.test.ts`. */
import { createBodyLayer } from '@principia/render-pixi';
import { Application, Container } from 'pixi.js';
import { createTestBodySource } from '../support/body-source.ts';

/** Bytes of heap that one `update` leaves behind when every column was uploaded, over many frames. */
async function garbage(count: number, frames: number): Promise<number> {
  const app = new Application();
  await app.init({ width: 128, height: 128, preference: 'webgl', autoStart: false, antialias: false });
  document.body.append(app.canvas);
  const source = createTestBodySource(Math.ceil(count / 1024) * 1024);
  source.show(Array.from({ length: count }, (_, id) => id));
  const layer = createBodyLayer({ source });
  const root = new Container({ children: [layer.container] });
  const memory = (performance as unknown as { memory: { usedJSHeapSize: number } }).memory;
  const { gc } = globalThis as unknown as { gc(): void };
  const run = () => {
    for (let i = 0; i < frames; i++) {
      source.versions.pose++;
      source.versions.style++;
      layer.update(i / frames);
    }
  };
  layer.update(0);
  app.renderer.render(root);
  run();
  gc();
  const before = memory.usedJSHeapSize;
  run();
  const after = memory.usedJSHeapSize;
  app.destroy(true);
  return (after - before) / frames;
}

declare global {
  var garbageOf: typeof garbage;
}
globalThis.garbageOf = garbage;
