/** The page of `npm run frame-cost`: draws 100 000 particles and times the JavaScript, and that of pixi's `ParticleContainer`. */
import { step } from '@principia/physics';
import { type BodySource, worldSource } from '@principia/render-core';
import { createBodyLayer, openScreen } from '@principia/render-pixi';
import { createBodyMesh } from '@principia/render-three';
import { particles } from '@principia/scenes';
import { Application, Container, Particle, ParticleContainer, Texture } from 'pixi.js';
import { OrthographicCamera, PerspectiveCamera, Scene, WebGLRenderer } from 'three';

/** Milliseconds of JavaScript per frame after a step: `update()` of the bodies and `render()` of the library. */
export type FrameTime = readonly [update: number, render: number];

/** A renderer of a body source. */
interface Picture {
  readonly gl: WebGL2RenderingContext;
  update(): void;
  render(): void;
}

/** A small size keeps the fill cost of a software renderer low. */
const SIZE = 128;

async function pixiPicture(source: BodySource): Promise<Picture> {
  const parent = document.createElement('div');
  parent.style.cssText = `width: ${SIZE}px; height: ${SIZE}px`;
  document.body.append(parent);
  const screen = await openScreen(parent);
  const layer = createBodyLayer({ source });
  screen.stage.addChild(layer.container);
  screen.stage.y = SIZE;
  return {
    gl: screen.canvas.getContext('webgl2') as WebGL2RenderingContext,
    update: () => layer.update(0.5),
    render: () => screen.render(),
  };
}

/** What a game would do with pixi alone: copy every position to an object of pixi's in each frame. */
async function particleContainerPicture(source: BodySource): Promise<Picture> {
  const app = new Application();
  await app.init({ width: SIZE, height: SIZE, preference: 'webgl', autoStart: false, antialias: false });
  document.body.append(app.canvas);
  const particles = Array.from({ length: source.count }, () => new Particle({ texture: Texture.WHITE }));
  const container = new ParticleContainer({ particles, dynamicProperties: { position: true } });
  const root = new Container({ children: [container] });
  const { x, y } = source.position;
  return {
    gl: app.canvas.getContext('webgl2') as WebGL2RenderingContext,
    update: () => {
      for (let i = 0; i < particles.length; i++) {
        particles[i].x = x[source.ids[i]];
        particles[i].y = SIZE - y[source.ids[i]];
      }
    },
    render: () => app.renderer.render(root),
  };
}

function threePicture(source: BodySource): Picture {
  const renderer = new WebGLRenderer();
  renderer.setSize(SIZE, SIZE);
  document.body.append(renderer.domElement);
  const bodies = createBodyMesh({ source });
  const scene = new Scene().add(bodies.object);
  const camera = source.dimensions === 2 ? new OrthographicCamera(0, 100, 100, 0, 1, 1000) : new PerspectiveCamera();
  camera.position.z = 200;
  if (source.dimensions === 3) camera.position.set(50, 50, 200);
  return {
    gl: renderer.getContext() as WebGL2RenderingContext,
    update: () => bodies.update(0.5),
    render: () => renderer.render(scene, camera),
  };
}

const PICTURES = { pixi: pixiPicture, three: threePicture, ParticleContainer: particleContainerPicture };

async function open(renderer: keyof typeof PICTURES, dimensions: 2 | 3, count: number) {
  const { world, dt } = particles.create({ dimensions, count });
  const source = worldSource(world);
  const picture = await PICTURES[renderer](source);
  const { gl } = picture;
  const pixel = new Uint8Array(4);
  const frame = (): FrameTime => {
    // Waits until the GPU has drawn the last frame, so that its work is not timed.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    step(world, dt);
    const start = performance.now();
    picture.update();
    const updated = performance.now();
    picture.render();
    return [updated - start, performance.now() - updated];
  };
  Object.assign(globalThis, { __frames: (count: number) => Array.from({ length: count }, frame) });
}

Object.assign(globalThis, { __open: open });
