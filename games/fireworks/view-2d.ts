/** The picture in 2D, drawn by pixi.js. */
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
import type { Stage, View } from '@principia/shell';
import { Container, RendererType, Sprite, Texture, type WebGLRenderer } from 'pixi.js';
import type { Desk } from './desk.ts';
import { createHud } from './hud.ts';
import { paintShore, paintSky } from './landscape.ts';
import { createLight2D } from './light-2d.ts';
import { LightClock } from './light-clock.ts';
import type { Settings } from './settings.ts';
import type { FireworksGame } from './sim.ts';
import { listenToSky } from './sky-pointer.ts';

/** What is to be seen, m: the sky that shells reach, and some water. */
const SEEN = { minX: -50, minY: -8, maxX: 50, maxY: 58 };
const SEEN_HEIGHT = SEEN.maxY - SEEN.minY;
/** A tall window comes closer, as long as it shows this width, m, and `SEEN` leaves this part of its height free. */
const LEAST_WIDTH = 72;
const LEAST_FREE = 0.38;

export async function openView2D(stage: Stage<Settings, FireworksGame>, desk: Desk): Promise<View> {
  const screen = await openScreen(stage.element, { background: '#03040d' });
  const { canvas, renderer } = screen;
  const light = renderer.type === RendererType.WEBGL ? createLight2D(renderer as WebGLRenderer) : undefined;
  const shining = new Container();
  const backdrop = createBackdrop();
  screen.stage.addChild(backdrop.sky, light?.container ?? shining, backdrop.shore);
  const camera: Camera2D = { x: 0, y: 20, pixelsPerMetre: 10 };
  const clock = new LightClock();
  let layer = createSparks(stage.sim(), shining);
  let zoomed = 1;
  const look = () => {
    // Shells burst where the panel does not hide them; the landscape is as wide as the window.
    const { right } = stage.insets();
    const { height } = viewport;
    const width = Math.max(1, viewport.width - right);
    fit(camera, SEEN, { width, height }, 0);
    const closer = Math.min(width / LEAST_WIDTH, ((1 - LEAST_FREE) * height) / SEEN_HEIGHT);
    camera.pixelsPerMetre = Math.max(camera.pixelsPerMetre, closer);
    // What stays free goes above and below, so that shells burst before the eyes and not at the feet.
    const free = Math.max(0, height - SEEN_HEIGHT * camera.pixelsPerMetre);
    const lift = Math.min(0.26 * height, 0.8 * Math.max(0, free - 0.25 * height));
    const ground = lift - SEEN.minY * camera.pixelsPerMetre;
    camera.pixelsPerMetre *= zoomed;
    camera.x = right / 2 / camera.pixelsPerMetre;
    // The ground stays where it is, however close.
    camera.y = (height / 2 - ground) / camera.pixelsPerMetre;
    backdrop.paint(viewport, ground, camera.pixelsPerMetre);
    light?.clear();
  };
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
    light?.resize(width, height, resolution);
    queueMicrotask(look);
  });
  const shown = { x: 0, y: 0 };
  const place = (x: number, y: number) => toScreen(camera, viewport, x, y, shown);
  const pointer = listenToSky(stage, desk, canvas, {
    world: (x, y) => ({ ...toWorld(camera, viewport, x, y, { x: 0, y: 0 }), z: 0 }),
    screen: place,
  });
  const hud = createHud(stage, desk);
  let time = 0;
  let hasShone = false;
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      layer.destroy();
      layer = createSparks(stage.sim(), shining);
      clock.reset();
      light?.clear();
    },
    draw(alpha, seconds) {
      const sim = stage.sim();
      if (!stage.reducedMotion) time += seconds;
      applyCamera(shining, camera, viewport);
      layer.update(alpha);
      // As long as nothing has shone there is no light to fade: the first frame waits for no program of it.
      hasShone ||= sim.scene.alive + sim.scene.flying > 0;
      if (light !== undefined && hasShone && clock.advance(sim, alpha, stage.values().glow)) {
        shining.alpha = clock.gain;
        light.add(shining, clock.fade);
      }
      light?.show(1 - place(0, 0).y / viewport.height, time);
      pointer.update();
      hud.update(seconds, place);
      screen.render();
    },
    fit() {
      zoomed = 1;
      look();
    },
    zoom(factor) {
      zoomed = Math.min(4, Math.max(0.4, zoomed * factor));
      look();
    },
    toScreen: place,
    destroy() {
      pointer.destroy();
      hud.destroy();
      viewport.destroy();
      layer.destroy();
      light?.destroy();
      backdrop.destroy();
      screen.destroy();
    },
  };
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

/** Sky and shore, painted anew for every size of the window. */
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
    /** @param ground height of the water's edge above the lower end of the window, CSS pixels */
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
