/** A view drawn by pixi.js: canvas, camera, and pointers that drag bodies. A game supplies the picture. */
// Most pictures use graphics only. A game that uses text or other extensions imports `pixi.js/text` and so on itself.
import 'pixi.js/graphics';
import {
  type BodySource,
  type Bounds2,
  type Camera2D,
  fit,
  listenToPointers,
  toScreen,
  toWorld,
  type ViewportSize,
  watchViewport,
  worldSource,
  type ZoomLimits,
  zoomAt,
} from '@principia/render-core';
import { applyCamera, openScreen, type Screen } from '@principia/render-pixi';
import { Container } from 'pixi.js';
import type { Simulation, View, ViewContext } from '../game.ts';
import { pickBody2D } from '../pick.ts';
import type { Settings } from '../settings.ts';

/** Distance by which a touch may miss a body, CSS pixels. */
const TOUCH_SLACK = 10;
const DEFAULT_MARGIN = 18;
/** Limits of the scale, relative to that of the whole picture. */
const ZOOM_RANGE = { min: 0.1, max: 200 };

/** The drawing of one world. */
export interface Picture {
  /** Coordinates in metres, y up. */
  readonly container: Container;
  /** Called once a frame. @param alpha position of the picture between the last two steps, 0 to 1 */
  update(alpha: number, pixelsPerMetre: number): void;
  /** Called when a setting changed. */
  refresh?(): void;
  /** Ends the drawing when its world is replaced. */
  destroy(): void;
}

/** Options of `openPixiView`. */
export interface PixiViewOptions<Sim extends Simulation> {
  /** The region that must be visible, m. */
  bounds(sim: Sim): Bounds2;
  /** Creates the picture of a world; called again for every new world. */
  paint(sim: Sim, source: BodySource): Picture;
  /** The y axis of the world points down on the screen; default false. */
  yDown?(sim: Sim): boolean;
  /** Margin around the bounds, CSS pixels; default 18. */
  readonly margin?: number;
  /** Whether pointers may drag bodies; default true. */
  readonly grab?: boolean;
  /**
   * Finds the body under a point, m, which a touch may miss by `slack`; 0 for none. Default: the body whose circle contains
   * the point.
   */
  pick?(sim: Sim, point: { readonly x: number; readonly y: number }, slack: number): number;
  /** Radius within which a pointer grabs all bodies, m; default 0, which grabs only the body under the pointer. */
  readonly grabRadius?: number;
}

/** A view whose places on the canvas are places in the world. */
export interface PixiView extends View {
  /** The point of the world under a place on the canvas, CSS pixels. */
  toWorld(x: number, y: number): { readonly x: number; readonly y: number };
}

/**
 * Opens a view in `context`; returned by a renderer's `open`.
 * @throws what `openScreen` and `paint` throw; then nothing of the view stays
 */
export async function openPixiView<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  options: PixiViewOptions<Sim>,
): Promise<PixiView> {
  const screen = await openScreen(context.element, { backgroundAlpha: 0, antialias: true });
  try {
    return viewOf(screen, context, options);
  } catch (error) {
    screen.destroy();
    throw error;
  }
}

function viewOf<S extends Settings, Sim extends Simulation>(
  screen: Screen,
  context: ViewContext<S, Sim>,
  options: PixiViewOptions<Sim>,
): PixiView {
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const camera: Camera2D = { x: 0, y: 0, pixelsPerMetre: 100 };
  const zoomLimits = { min: 10, max: 20_000 };
  let shown = show(context, options, content);
  let isFitted = true;

  const fitAll = () => {
    isFitted = true;
    fitInto(camera, options, context, viewport);
    zoomLimits.min = ZOOM_RANGE.min * camera.pixelsPerMetre;
    zoomLimits.max = ZOOM_RANGE.max * camera.pixelsPerMetre;
  };
  /** The camera's y axis points up; this is the sign of the world's. */
  const up = () => (options.yDown?.(context.sim()) ? -1 : 1);
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
    if (isFitted) queueMicrotask(fitAll);
  });
  const navigated = () => {
    isFitted = false;
  };
  const pointers = dragByPointers(context, canvas, camera, {
    options,
    source: () => shown.source,
    up,
    zoomLimits,
    onNavigate: navigated,
  });
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return shown.picture.refresh?.();
      shown.picture.destroy();
      shown = show(context, options, content);
      if (isFitted) fitAll();
    },
    draw(alpha) {
      applyCamera(content, camera, viewport);
      shown.picture.update(alpha, camera.pixelsPerMetre);
      screen.render();
    },
    fit: fitAll,
    zoom(factor) {
      navigated();
      zoomAt(camera, viewport, viewport.width / 2, viewport.height / 2, factor, zoomLimits);
    },
    camera: () => [camera.x, up() * camera.y, viewport.height / camera.pixelsPerMetre],
    setCamera([x, y, height]) {
      if (!(height > 0 && Number.isFinite(x + y + height))) return;
      navigated();
      Object.assign(camera, { x, y: up() * y, pixelsPerMetre: viewport.height / height });
    },
    ...placesOf(camera, viewport, up),
    destroy() {
      pointers.destroy();
      viewport.destroy();
      shown.picture.destroy();
      screen.destroy();
    },
  };
}

/** Where points of the world are on the canvas, and the reverse. */
function placesOf(camera: Camera2D, viewport: ViewportSize, up: () => number): Pick<PixiView, 'toScreen' | 'toWorld'> {
  return {
    toScreen: (x, y) => toScreen(camera, viewport, x, up() * y, { x: 0, y: 0 }),
    toWorld(screenX, screenY) {
      const { x, y } = toWorld(camera, viewport, screenX, screenY, { x: 0, y: 0 });
      return { x, y: up() * y };
    },
  };
}

function show<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  options: PixiViewOptions<Sim>,
  parent: Container,
) {
  const sim = context.sim();
  const source = worldSource(sim.world);
  const picture = options.paint(sim, source);
  picture.container.scale.y *= options.yDown?.(sim) ? -1 : 1;
  parent.addChild(picture.container);
  return { source, picture };
}

/** Fits the bounds into the part of the window that nothing covers. */
function fitInto<S extends Settings, Sim extends Simulation>(
  camera: Camera2D,
  { bounds, yDown, margin = DEFAULT_MARGIN }: PixiViewOptions<Sim>,
  context: ViewContext<S, Sim>,
  size: ViewportSize,
): void {
  const { top, right, bottom, left } = context.insets();
  const free = { width: size.width - left - right, height: size.height - top - bottom };
  if (!(free.width > 0 && free.height > 0)) return;
  const { minX, maxX, minY, maxY } = bounds(context.sim());
  const isDown = yDown?.(context.sim()) ?? false;
  fit(camera, isDown ? { minX, maxX, minY: -maxY, maxY: -minY } : { minX, maxX, minY, maxY }, free, margin);
  camera.x += (right - left) / 2 / camera.pixelsPerMetre;
  camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
}

function* bodiesWithin({ ids, count, position }: BodySource, x: number, y: number, maxDistance: number) {
  for (let slot = 0; slot < count; slot++) {
    const id = ids[slot];
    if (Math.hypot(position.x[id] - x, position.y[id] - y) < maxDistance) yield id;
  }
}

interface DragSupport<Sim extends Simulation> {
  readonly options: PixiViewOptions<Sim>;
  /** The bodies on display. */
  readonly source: () => BodySource;
  /** 1 if the world's y axis points up, -1 if it points down. */
  readonly up: () => 1 | -1;
  readonly zoomLimits: ZoomLimits;
  readonly onNavigate: () => void;
}

function dragByPointers<S extends Settings, Sim extends Simulation>(
  context: ViewContext<S, Sim>,
  canvas: HTMLCanvasElement,
  camera: Camera2D,
  { options, source, up, zoomLimits, onNavigate }: DragSupport<Sim>,
) {
  // The camera's y axis points up.
  const pick = (x: number, cameraY: number) => {
    const slack = TOUCH_SLACK / camera.pixelsPerMetre;
    const y = up() * cameraY;
    if (options.grab === false) return 0;
    if (options.pick !== undefined) return options.pick(context.sim(), { x, y }, slack);
    return pickBody2D(source(), context.alpha(), x, y, slack);
  };
  return listenToPointers(canvas, {
    camera,
    pick,
    onNavigate,
    zoomLimits,
    primaryPans: context.isSpaceHeld,
    onGrab(id, x, cameraY, pointer) {
      const y = up() * cameraY;
      canvas.style.cursor = 'grabbing';
      context.dragging().grab(pointer, id, x, y);
      for (const other of bodiesWithin(source(), x, y, options.grabRadius ?? 0))
        context.dragging().grab(pointer, other, x, y);
    },
    onDrag: (_, x, y, pointer) => context.dragging().move(pointer, x, up() * y),
    onRelease(_id, _x, _y, vx, vy, pointer) {
      canvas.style.cursor = '';
      context.dragging().release(pointer, vx, up() * vy);
    },
    onHover(x, y) {
      canvas.style.cursor = pick(x, y) === 0 ? '' : 'grab';
    },
  });
}
