/** The page of `render-pixi-cost.test.ts`: times frames of JavaScript, ours and those of pixi's `ParticleContainer`. */
import { createBodyLayer } from '@principia/render-pixi';
import { Application, Container, Particle, ParticleContainer, Texture } from 'pixi.js';
import { createTestBodySource, type TestBodySource } from '../support/body-source.ts';

/** Medians of milliseconds of JavaScript per frame: bringing the picture up to date, and `render()`. */
export interface FrameCost {
  update: number;
  render: number;
}

async function openApp(): Promise<Application> {
  const app = new Application();
  await app.init({ width: 128, height: 128, preference: 'webgl', autoStart: false, antialias: false });
  document.body.append(app.canvas);
  return app;
}

function crowd(count: number): TestBodySource {
  const source = createTestBodySource(Math.ceil(count / 1024) * 1024);
  for (let id = 0; id < count; id++) {
    source.position.x[id] = source.previousPosition.x[id] = (id * 7919) % 128;
    source.position.y[id] = source.previousPosition.y[id] = -((id * 104729) % 128);
    source.radius[id] = 1;
    source.ids[id] = id;
  }
  source.count = count;
  source.lastId = count - 1;
  return source;
}

/** Waits until the GPU is done, so that one candidate's pixels do not slow the other's JavaScript. */
function drain(app: Application): void {
  const gl = app.canvas.getContext('webgl2');
  gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

function time(app: Application, root: Container, sync: () => void, costs: number[][]): void {
  const start = performance.now();
  sync();
  const synced = performance.now();
  app.renderer.render(root);
  costs.push([synced - start, performance.now() - synced]);
  drain(app);
}

function median(costs: number[][]): FrameCost {
  const pick = (i: number) => costs.map((cost) => cost[i]).sort((a, b) => a - b)[costs.length >> 1];
  return { update: pick(0), render: pick(1) };
}

export const costLab = {
  /**
   * Frames of `count` moving bodies, in turn: our layer with every column uploaded and two bodies drawn (the cost of
   * JavaScript without the software renderer's), our layer with all drawn, and a `ParticleContainer`.
   */
  async compare(count: number, rounds: number) {
    const app = await openApp();
    const source = crowd(count);
    const layer = createBodyLayer({ source, rotation: false, defaultColor: 0xffffff });
    const ours = new Container({ children: [layer.container] });
    const particles = Array.from(
      { length: count },
      () => new Particle({ texture: Texture.WHITE, scaleX: 2, scaleY: 2 }),
    );
    const container = new ParticleContainer({ particles, dynamicProperties: { position: true } });
    const theirs = new Container({ children: [container] });
    const { x, y } = source.position;
    const pull = (shown: number) => {
      source.count = shown;
      source.versions.pose++;
      layer.update(0.5);
    };
    const push = () => {
      for (let i = 0; i < count; i++) {
        particles[i].x = x[i];
        particles[i].y = -y[i];
      }
    };
    const costs: number[][][] = [[], [], []];
    for (let round = -3; round < rounds; round++) {
      const into = round < 0 ? [[], [], []] : costs;
      time(app, ours, () => pull(2), into[0]);
      time(app, ours, () => pull(count), into[1]);
      time(app, theirs, push, into[2]);
    }
    app.destroy(true);
    return { twoDrawn: median(costs[0]), allDrawn: median(costs[1]), particleContainer: median(costs[2]) };
  },

  /** Bytes of heap that one `update` leaves behind when every column was uploaded, over many frames. */
  async garbage(count: number, frames: number) {
    const app = await openApp();
    const source = crowd(count);
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
  },
};

declare global {
  var pixiCostLab: typeof costLab;
}
globalThis.pixiCostLab = costLab;
