/** The 2D view, drawn by pixi.js. */
import {
  type Camera2D,
  fit,
  toScreen,
  toWorld,
  type Viewport,
  watchViewport,
  worldSource,
} from '@principia/render-core';
import { applyCamera, type BodyLayer, createBodyLayer, openScreen } from '@principia/render-pixi';
import type { View, ViewContext } from '@principia/shell';
import { Container, RendererType, Sprite, Texture, type WebGLRenderer } from 'pixi.js';
import type { PlayerControls } from './controls.ts';
import { createHud } from './hud.ts';
import { paintShore, paintSky } from './landscape.ts';
import { createLight2D } from './light-2d.ts';
import { LightClock } from './light-clock.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';
import { listenToSky } from './sky-pointer.ts';

/** Visible region, m: the sky that shells reach, and some water. */
const VISIBLE = { minX: -50, minY: -8, maxX: 50, maxY: 58 };
const VISIBLE_HEIGHT = VISIBLE.maxY - VISIBLE.minY;
/** A tall window zooms in as long as it shows this width, m, and this fraction of its height stays free. */
const MIN_WIDTH = 72;
const MIN_FREE_SHARE = 0.38;

export async function openView2D(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
): Promise<View> {
  const screen = await openScreen(context.element, { background: '#03040d' });
  const { canvas, renderer } = screen;
  const light = renderer.type === RendererType.WEBGL ? createLight2D(renderer as WebGLRenderer) : undefined;
  const shining = new Container();
  const backdrop = createBackdrop();
  screen.stage.addChild(backdrop.sky, light?.container ?? shining, backdrop.shore);
  const camera: Camera2D = { x: 0, y: 20, pixelsPerMetre: 10 };
  const clock = new LightClock();
  let layer = createSparks(context.sim(), shining);
  let zoomed = 1;
  const fitAll = () => {
    const ground = fitCamera(camera, viewport, context.insets().right, zoomed);
    backdrop.paint(viewport, ground, camera.pixelsPerMetre);
    light?.clear();
  };
  const setZoom = (factor: number) => {
    zoomed = factor;
    fitAll();
  };
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
    light?.resize(width, height, resolution);
    queueMicrotask(fitAll);
  });
  const shown = { x: 0, y: 0 };
  const place = (x: number, y: number) => toScreen(camera, viewport, x, y, shown);
  const pointer = listenToSky(context, controls, canvas, {
    world: (x, y) => ({ ...toWorld(camera, viewport, x, y, { x: 0, y: 0 }), z: 0 }),
    screen: place,
  });
  const hud = createHud(context, controls);
  let time = 0;
  let hasShone = false;
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      layer.destroy();
      layer = createSparks(context.sim(), shining);
      clock.reset();
      light?.clear();
    },
    draw(alpha, seconds) {
      const sim = context.sim();
      if (!context.reducedMotion) time += seconds;
      applyCamera(shining, camera, viewport);
      layer.update(alpha);
      // Before the first light nothing fades, so the first frame does not wait for the shader programs.
      hasShone ||= sim.scene.alive + sim.scene.flying > 0;
      if (light !== undefined && hasShone && clock.advance(sim, alpha, context.values().glow)) {
        shining.alpha = clock.gain;
        light.add(shining, clock.fade);
      }
      light?.show(1 - place(0, 0).y / viewport.height, time);
      pointer.update();
      hud.update(seconds, place);
      screen.render();
    },
    fit: () => setZoom(1),
    zoom: (factor) => setZoom(Math.min(4, Math.max(0.4, zoomed * factor))),
    toScreen: place,
    destroy() {
      for (const part of [pointer, hud, viewport, layer, light, backdrop, screen]) part?.destroy();
    },
  };
}

/**
 * Fits the camera to the window.
 * @param right width of the panel, CSS pixels @returns height of the waterline above the bottom of the window, CSS pixels
 */
function fitCamera(camera: Camera2D, viewport: Viewport, right: number, zoomed: number): number {
  // Shells burst where the panel does not hide them; the landscape fills the window.
  const { height } = viewport;
  const width = Math.max(1, viewport.width - right);
  fit(camera, VISIBLE, { width, height }, 0);
  const closer = Math.min(width / MIN_WIDTH, ((1 - MIN_FREE_SHARE) * height) / VISIBLE_HEIGHT);
  camera.pixelsPerMetre = Math.max(camera.pixelsPerMetre, closer);
  // Free height is shared between above and below, so that shells burst near the centre of the window.
  const free = Math.max(0, height - VISIBLE_HEIGHT * camera.pixelsPerMetre);
  const lift = Math.min(0.26 * height, 0.8 * Math.max(0, free - 0.25 * height));
  const ground = lift - VISIBLE.minY * camera.pixelsPerMetre;
  camera.pixelsPerMetre *= zoomed;
  camera.x = right / 2 / camera.pixelsPerMetre;
  // The waterline keeps its height under zoom.
  camera.y = (height / 2 - ground) / camera.pixelsPerMetre;
  return ground;
}

function createSparks({ world }: FireworksGame, parent: Container): BodyLayer {
  const layer = createBodyLayer({
    source: worldSource(world),
    blendMode: 'add',
    rotation: false,
    minimumPixels: 1.1,
  });
  parent.addChild(layer.container);
  return layer;
}

/** Sky and shore, repainted for every window size. */
function createBackdrop() {
  const sky = new Sprite();
  const shore = new Sprite();
  let painted = '';
  const put = (sprite: Sprite, canvas: HTMLCanvasElement, resolution: number) => {
    if (sprite.texture !== Texture.EMPTY) sprite.texture.destroy(true);
    sprite.texture = Texture.from({ resource: canvas, resolution });
  };
  return {
    sky,
    shore,
    /** @param ground height of the waterline above the bottom of the window, CSS pixels */
    paint({ width, height, resolution }: Viewport, ground: number, pixelsPerMetre: number) {
      const scale = pixelsPerMetre * resolution;
      const horizon = Math.round((height - ground) * resolution);
      const plan = { width: width * resolution, height: height * resolution, horizon, scale };
      const wanted = Object.values(plan).join(' ');
      if (wanted === painted) return;
      painted = wanted;
      put(sky, paintSky(plan), resolution);
      put(shore, paintShore(plan), resolution);
    },
    destroy() {
      for (const sprite of [sky, shore]) sprite.destroy({ texture: true, textureSource: true });
    },
  };
}
