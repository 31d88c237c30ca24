/** The picture in 2D, drawn by pixi.js. */
import {
  type BodySource,
  type Camera2D,
  fit,
  listenToPointers,
  toScreen,
  watchViewport,
  worldSource,
  zoomAt,
} from '@principia/render-core';
import {
  applyCamera,
  type BodyLayer,
  createBodyLayer,
  createTrailLayer,
  type TrailLayer,
} from '@principia/render-pixi';
import type { BouncingBalls } from '@principia/scenes';
import { pickBody2D, type Stage, type View } from '@principia/shell';
import { Application, Container } from 'pixi.js';
import { createRoom2D } from './room-2d.ts';
import type { Settings } from './settings.ts';
import { createShading } from './shading.ts';

/** A finger may miss a ball by this much, CSS pixels. */
const FINGER = 10;
const MARGIN = 18;
/** Balls with trails; more would hide each other. */
const MOST_TRAILS = 2000;

export async function openView2D(stage: Stage<Settings, BouncingBalls>): Promise<View> {
  const app = new Application();
  await app.init({
    preference: ['webgl', 'webgpu'],
    backgroundAlpha: 0,
    autoStart: false,
    autoDensity: true,
    antialias: true,
  });
  const { canvas } = app;
  stage.element.append(canvas);
  app.stage.eventMode = 'none';
  const content = new Container();
  app.stage.addChild(content);
  const camera: Camera2D = { x: 0, y: 0, pixelsPerMetre: 100 };
  let picture = createPicture(stage, content);
  let isFitted = true;

  const show = () => {
    isFitted = true;
    fitInto(camera, stage, viewport);
  };
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    app.renderer.resize(width, height, resolution);
    if (isFitted) queueMicrotask(show);
  });
  const navigated = () => {
    isFitted = false;
  };
  const pointers = listenTo(stage, canvas, camera, () => picture.source, navigated);
  return {
    canvas,
    refresh(change) {
      if (change === 'world') {
        picture.destroy();
        picture = createPicture(stage, content);
      } else {
        picture.showTrails(stage.values().trails);
      }
    },
    draw(alpha) {
      applyCamera(content, camera, viewport);
      picture.update(alpha, camera.pixelsPerMetre);
      app.render();
    },
    fit: show,
    zoom(factor) {
      navigated();
      zoomAt(camera, viewport, viewport.width / 2, viewport.height / 2, factor, ZOOM_LIMITS);
    },
    toScreen: (x, y) => toScreen(camera, viewport, x, y, { x: 0, y: 0 }),
    destroy() {
      pointers.destroy();
      viewport.destroy();
      picture.destroy();
      app.destroy({ removeView: true, releaseGlobalResources: false }, { children: true });
    },
  };
}

const ZOOM_LIMITS = { min: 10, max: 20_000 };

/** Shows the whole room in the part of the window that nothing covers. */
function fitInto(camera: Camera2D, stage: Stage<Settings, BouncingBalls>, size: { width: number; height: number }) {
  const { min, max } = stage.sim().room;
  const { top, right, bottom, left } = stage.insets();
  const free = { width: size.width - left - right, height: size.height - top - bottom };
  if (!(free.width > 0 && free.height > 0)) return;
  fit(camera, { minX: min.x, minY: min.y, maxX: max.x, maxY: max.y }, free, MARGIN);
  camera.x += (right - left) / 2 / camera.pixelsPerMetre;
  camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
}

function listenTo(
  stage: Stage<Settings, BouncingBalls>,
  canvas: HTMLCanvasElement,
  camera: Camera2D,
  source: () => BodySource,
  onNavigate: () => void,
) {
  const pick = (x: number, y: number) => pickBody2D(source(), stage.alpha(), x, y, FINGER / camera.pixelsPerMetre);
  return listenToPointers(canvas, {
    camera,
    pick,
    onNavigate,
    zoomLimits: ZOOM_LIMITS,
    onGrab(id, x, y, pointer) {
      canvas.style.cursor = 'grabbing';
      stage.holding().grab(pointer, id, x, y);
    },
    onDrag: (_, x, y, pointer) => stage.holding().move(pointer, x, y),
    onRelease(_id, _x, _y, vx, vy, pointer) {
      canvas.style.cursor = '';
      stage.holding().release(pointer, vx, vy);
    },
    onHover(x, y) {
      canvas.style.cursor = pick(x, y) === 0 ? '' : 'grab';
    },
  });
}

/** Everything drawn of one world. */
function createPicture(stage: Stage<Settings, BouncingBalls>, parent: Container) {
  const sim = stage.sim();
  const source = worldSource(sim.world);
  const room = createRoom2D(sim);
  const shading = createShading(sim);
  // Unmarked balls look the same whichever way they are turned.
  const layer: BodyLayer = createBodyLayer({ source, rotation: shading !== undefined, minimumPixels: 0.8 });
  const trailPlace = new Container();
  let trails: TrailLayer | undefined;
  const parts = [room.ground, trailPlace, shading?.below, layer.container, shading?.above, room.walls];
  const root = new Container({ children: parts.filter((part) => part !== undefined) });
  parent.addChild(root);
  const showTrails = (shown: boolean) => {
    if (shown === (trails !== undefined)) return;
    trails?.destroy();
    trails = shown
      ? createTrailLayer({
          source,
          bodies: sim.balls.subarray(0, MOST_TRAILS),
          length: 48,
          thickness: Math.min(5, 60 * sim.radius),
          opacity: 0.5,
          blendMode: 'add',
        })
      : undefined;
    if (trails !== undefined) trailPlace.addChild(trails.container);
  };
  showTrails(stage.values().trails);
  return {
    source,
    showTrails,
    update(alpha: number, pixelsPerMetre: number) {
      trails?.update(alpha);
      shading?.update(alpha, pixelsPerMetre);
      layer.update(alpha);
    },
    destroy() {
      showTrails(false);
      shading?.destroy();
      layer.destroy();
      room.destroy();
      root.destroy({ children: true, context: true });
    },
  };
}
