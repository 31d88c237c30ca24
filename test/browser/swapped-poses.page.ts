/** The page of `swapped-poses.test.ts`: a world takes a step between two pictures of it. */
import { createPhysicsWorld, spawn, step } from '@principia/physics';
import { type BodySource, SHAPES, worldSource } from '@principia/render-core';
import { createBodyLayer, openScreen } from '@principia/render-pixi';
import { createBodyMesh } from '@principia/render-three';
import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';

const SIZE = 192;

interface Layer {
  update(alpha: number): void;
  destroy(): void;
}

interface Stage {
  readonly canvas: HTMLCanvasElement;
  /** A new layer takes the place of the last. */
  show(source: BodySource): Layer;
  render(): void;
}

async function pixiStage(): Promise<Stage> {
  const parent = document.createElement('div');
  parent.style.cssText = `width: ${SIZE}px; height: ${SIZE}px`;
  document.body.append(parent);
  const screen = await openScreen(parent);
  screen.stage.scale.set(SIZE / 12);
  screen.stage.position.set(SIZE / 2);
  return {
    canvas: screen.canvas,
    show(source) {
      const layer = createBodyLayer({ source });
      screen.stage.removeChildren();
      screen.stage.addChild(layer.container);
      return layer;
    },
    render: () => screen.render(),
  };
}

function threeStage(): Stage {
  const renderer = new WebGLRenderer();
  renderer.setSize(SIZE, SIZE);
  document.body.append(renderer.domElement);
  const camera = new PerspectiveCamera();
  camera.position.z = 14;
  const scene = new Scene();
  return {
    canvas: renderer.domElement,
    show(source) {
      const bodies = createBodyMesh({ source });
      scene.clear();
      scene.add(bodies.object);
      return bodies;
    },
    render: () => renderer.render(scene, camera),
  };
}

/** Bodies whose places are the same numbers however they are worked out. */
function crossing(dimensions: 2 | 3) {
  const world = createPhysicsWorld({ dimensions, capacity: 64 });
  for (let i = 0; i < 5; i++) {
    spawn(world, {
      position: { x: -3, y: 2 * i - 4 },
      velocity: { x: 32 * (i + 1), y: 16 },
      angularVelocity: dimensions === 2 ? 64 : { x: 32, z: 64 },
      appearance: { size: 0.75, shape: [SHAPES.disc, SHAPES.markedDisc, SHAPES.box][i % 3] },
    });
  }
  return world;
}

function pixels({ canvas, render }: Stage): Uint8ClampedArray {
  render();
  const context = new OffscreenCanvas(SIZE, SIZE).getContext('2d');
  if (context === null) throw new Error('no 2D context');
  context.drawImage(canvas, 0, 0, SIZE, SIZE);
  return context.getImageData(0, 0, SIZE, SIZE).data;
}

async function loseContext({ canvas }: Stage): Promise<void> {
  const extension = canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
  for (const [name, act] of [
    ['webglcontextlost', () => extension?.loseContext()],
    ['webglcontextrestored', () => extension?.restoreContext()],
  ] as const) {
    const happened = new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
    act();
    await happened;
    await new Promise((resolve) => setTimeout(resolve));
  }
}

/** Pixels of which two pictures show another colour, which rounding alone does not make. */
function differing(a: Uint8ClampedArray, b: Uint8ClampedArray): number {
  const pixels = new Set<number>();
  for (let i = 0; i < a.length; i++) if (Math.abs(a[i] - b[i]) > 2) pixels.add(i >> 2);
  return pixels.size;
}

/**
 * Pixels in which a layer that has drawn the last step differs from a new one that has not, at a quarter of the way
 * between the poses; and from itself at three quarters, and from its last picture.
 */
async function stepBetween(renderer: 'pixi' | 'three', dimensions: 2 | 3, losesContext: boolean) {
  const stage = renderer === 'pixi' ? await pixiStage() : threeStage();
  const world = crossing(dimensions);
  const source = worldSource(world);
  const layer = stage.show(source);
  layer.update(0.25);
  const before = pixels(stage);
  step(world, 1 / 64);
  if (losesContext) await loseContext(stage);
  layer.update(0.75);
  const later = pixels(stage);
  layer.update(0.25);
  const followed = pixels(stage);
  const fresh = stage.show(source);
  fresh.update(0.25);
  const anew = pixels(stage);
  return {
    fresh: differing(followed, anew),
    later: differing(followed, later),
    before: differing(followed, before),
  };
}

const lab = { stepBetween };
declare global {
  var swapLab: typeof lab;
}
globalThis.swapLab = lab;
