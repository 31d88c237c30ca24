/** Mouse and touch: press, hold for a larger shell, release to launch. Every pointer launches its own shell. */
import { placeOnCanvas } from '@principia/render-core';
import { heldStars, SHELLS } from '@principia/scenes';
import type { ViewContext } from '@principia/shell';
import type { PlayerControls } from './controls.ts';
import type { Settings } from './settings.ts';
import { clampToSky, type FireworksGame, SWARM } from './sim.ts';

type SkyPoint = { readonly x: number; readonly y: number; readonly z: number };

export interface SkyMapping {
  /** The point of the sky under a point of the canvas, CSS pixels. */
  world(x: number, y: number): SkyPoint;
  screen(x: number, y: number, z: number): { x: number; y: number };
  /** Whether dragging rotates the view instead of launching a shell. */
  readonly rotatesView?: boolean;
}

/** Distance beyond which a pointer rotates the view, CSS pixels. */
const DRAG_THRESHOLD = 12;

export interface SkyPointer {
  /** Shows the size of the held shells; call it once a frame. */
  update(): void;
  destroy(): void;
}

export function listenToSky(
  context: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
  canvas: HTMLCanvasElement,
  mapping: SkyMapping,
): SkyPointer {
  const rings = new Map<number, Ring>();
  const pointAt = (event: PointerEvent) => {
    const place = placeOnCanvas(canvas, event);
    const { x, y, z } = mapping.world(place.x, place.y);
    return clampToSky(x, y, z);
  };
  const forget = (finger: number) => {
    rings.get(finger)?.element.remove();
    rings.delete(finger);
  };
  const move = (event: PointerEvent) => {
    const ring = rings.get(event.pointerId);
    if (ring === undefined) return;
    const distance = Math.hypot(event.clientX - ring.startX, event.clientY - ring.startY);
    if (mapping.rotatesView === true && distance > DRAG_THRESHOLD) {
      cancel(event);
      return;
    }
    const { x, y, z } = pointAt(event);
    const place = mapping.screen(x, y, z);
    ring.element.style.translate = `${place.x}px ${place.y}px`;
  };
  const press = (event: PointerEvent) => {
    if (event.button !== 0) return;
    canvas.focus({ preventScroll: true });
    // A pointer released outside the window may be pressed twice.
    forget(event.pointerId);
    capture(canvas, event.pointerId);
    const element = document.createElement('div');
    element.className = 'fw-ring';
    context.element.append(element);
    rings.set(event.pointerId, { element, startX: event.clientX, startY: event.clientY });
    move(event);
    controls.startHold(context.sim(), event.pointerId);
  };
  const release = (event: PointerEvent) => {
    if (!rings.has(event.pointerId)) return;
    forget(event.pointerId);
    controls.fire(context.sim(), event.pointerId, pointAt(event));
  };
  const cancel = (event: PointerEvent) => {
    if (!rings.has(event.pointerId)) return;
    forget(event.pointerId);
    context.sim().press({ do: 'forget', finger: event.pointerId });
  };
  const stop = listen(canvas, { pointerdown: press, pointermove: move, pointerup: release, pointercancel: cancel });
  return {
    update() {
      if (rings.size === 0) return;
      for (const [finger, { element }] of rings)
        showPower(element, context.sim().powerOf(finger, controls.kind), controls);
    },
    destroy() {
      stop();
      for (const finger of [...rings.keys()]) forget(finger);
    },
  };
}

/** The ring around a held pointer, and where the pointer was pressed, CSS pixels. */
interface Ring {
  readonly element: HTMLElement;
  readonly startX: number;
  readonly startY: number;
}

function listen(canvas: HTMLCanvasElement, listeners: Record<string, (event: PointerEvent) => void>): () => void {
  for (const [type, listener] of Object.entries(listeners)) canvas.addEventListener(type as 'pointerdown', listener);
  canvas.style.touchAction = 'none';
  canvas.style.cursor = 'crosshair';
  return () => {
    for (const [type, listener] of Object.entries(listeners))
      canvas.removeEventListener(type as 'pointerdown', listener);
  };
}

function showPower(element: HTMLElement, power: number, { kind }: PlayerControls): void {
  const isSwarm = kind === SWARM;
  // A swarm's ring is large from the first second, so that the number in it is readable.
  element.style.setProperty('--power', String(isSwarm ? 0.6 + 0.4 * power : power));
  const stars = isSwarm ? String(heldStars(SHELLS[SWARM], power)) : '';
  if (element.textContent !== stars) element.textContent = stars;
}

/** A pointer from a synthetic event cannot be captured. */
function capture(canvas: HTMLCanvasElement, pointer: number): void {
  try {
    canvas.setPointerCapture(pointer);
  } catch {}
}
