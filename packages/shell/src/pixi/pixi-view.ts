/** A view drawn by pixi.js: canvas, camera, and pointers that hold bodies. A game adds what is to be seen. */
// What most pictures are made of; who uses text or other parts of pixi imports `pixi.js/text` and the like.
import 'pixi.js/graphics';
import {
  type BodySource,
  type Bounds2,
  type Camera2D,
  fit,
  listenToPointers,
  toScreen,
  type ViewportSize,
  watchViewport,
  worldSource,
  zoomAt,
} from '@principia/render-core';
import { applyCamera, openScreen } from '@principia/render-pixi';
import { Container } from 'pixi.js';
import type { Simulation, Stage, View } from '../game.ts';
import { pickBody2D } from '../pick.ts';
import type { Settings } from '../settings.ts';

/** A finger may miss a body by this much, CSS pixels. */
const FINGER = 10;
const DEFAULT_MARGIN = 18;
const ZOOM_LIMITS = { min: 10, max: 20_000 };

/** Everything drawn of one world. */
export interface Picture {
  /** Drawn in metres, y up. */
  readonly container: Container;
  /** Called once a frame. @param alpha where between the last two steps the picture is, 0 to 1 */
  update(alpha: number, pixelsPerMetre: number): void;
  /** A setting changed. */
  refresh?(): void;
  destroy(): void;
}

/** What a game tells of its picture. */
export interface PixiViewOptions<Sim extends Simulation> {
  /** What is to be seen whole, m. */
  bounds(sim: Sim): Bounds2;
  /** Makes the picture of a world; called anew for every new world. */
  paint(sim: Sim, source: BodySource): Picture;
  /** Room around the bounds, CSS pixels; default 18. */
  readonly margin?: number;
  /** Whether pointers may hold bodies; default true. */
  readonly grab?: boolean;
  /** A pointer takes hold of all bodies nearer than this, m; default 0: of the one under it alone. */
  readonly hand?: number;
}

/** Opens a view on `stage`: what a renderer's `open` returns. */
export async function openPixiView<S extends Settings, Sim extends Simulation>(
  stage: Stage<S, Sim>,
  options: PixiViewOptions<Sim>,
): Promise<View> {
  const screen = await openScreen(stage.element, { backgroundAlpha: 0, antialias: true });
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const camera: Camera2D = { x: 0, y: 0, pixelsPerMetre: 100 };
  let shown = show(stage, options, content);
  let isFitted = true;

  const fitAll = () => {
    isFitted = true;
    fitInto(camera, options, stage, viewport);
  };
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
    if (isFitted) queueMicrotask(fitAll);
  });
  const navigated = () => {
    isFitted = false;
  };
  const canGrab = options.grab ?? true;
  const pick = (x: number, y: number) =>
    canGrab ? pickBody2D(shown.source, stage.alpha(), x, y, FINGER / camera.pixelsPerMetre) : 0;
  const take = (id: number, x: number, y: number, pointer: number) => {
    stage.holding().grab(pointer, id, x, y);
    for (const other of bodiesWithin(shown.source, x, y, options.hand ?? 0)) stage.holding().grab(pointer, other, x, y);
  };
  const pointers = holdByPointers(stage, canvas, camera, { pick, take, onNavigate: navigated });
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') {
        shown.picture.refresh?.();
        return;
      }
      shown.picture.destroy();
      shown = show(stage, options, content);
    },
    draw(alpha) {
      applyCamera(content, camera, viewport);
      shown.picture.update(alpha, camera.pixelsPerMetre);
      screen.render();
    },
    fit: fitAll,
    zoom(factor) {
      navigated();
      zoomAt(camera, viewport, viewport.width / 2, viewport.height / 2, factor, ZOOM_LIMITS);
    },
    toScreen: (x, y) => toScreen(camera, viewport, x, y, { x: 0, y: 0 }),
    destroy() {
      pointers.destroy();
      viewport.destroy();
      shown.picture.destroy();
      screen.destroy();
    },
  };
}

function show<S extends Settings, Sim extends Simulation>(
  stage: Stage<S, Sim>,
  options: PixiViewOptions<Sim>,
  parent: Container,
) {
  const sim = stage.sim();
  const source = worldSource(sim.world);
  const picture = options.paint(sim, source);
  parent.addChild(picture.container);
  return { source, picture };
}

/** Shows the bounds in the part of the window that nothing covers. */
function fitInto<S extends Settings, Sim extends Simulation>(
  camera: Camera2D,
  { bounds, margin = DEFAULT_MARGIN }: PixiViewOptions<Sim>,
  stage: Stage<S, Sim>,
  size: ViewportSize,
): void {
  const { top, right, bottom, left } = stage.insets();
  const free = { width: size.width - left - right, height: size.height - top - bottom };
  if (!(free.width > 0 && free.height > 0)) return;
  fit(camera, bounds(stage.sim()), free, margin);
  camera.x += (right - left) / 2 / camera.pixelsPerMetre;
  camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
}

function* bodiesWithin({ ids, count, position }: BodySource, x: number, y: number, reach: number) {
  for (let slot = 0; slot < count; slot++) {
    const id = ids[slot];
    if (Math.hypot(position.x[id] - x, position.y[id] - y) < reach) yield id;
  }
}

interface Hand {
  readonly pick: (x: number, y: number) => number;
  readonly take: (id: number, x: number, y: number, pointer: number) => void;
  readonly onNavigate: () => void;
}

function holdByPointers<S extends Settings, Sim extends Simulation>(
  stage: Stage<S, Sim>,
  canvas: HTMLCanvasElement,
  camera: Camera2D,
  { pick, take, onNavigate }: Hand,
) {
  return listenToPointers(canvas, {
    camera,
    pick,
    onNavigate,
    zoomLimits: ZOOM_LIMITS,
    onGrab(id, x, y, pointer) {
      canvas.style.cursor = 'grabbing';
      take(id, x, y, pointer);
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
