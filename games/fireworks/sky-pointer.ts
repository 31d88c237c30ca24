/** Mouse and touch: press, hold for a larger shell, release to launch. Every pointer launches its own shell. */
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
  stage: ViewContext<Settings, FireworksGame>,
  controls: PlayerControls,
  canvas: HTMLCanvasElement,
  places: SkyMapping,
): SkyPointer {
  const rings = new Map<number, HTMLElement>();
  const starts = new Map<number, { x: number; y: number }>();
  const at = (event: PointerEvent) => {
    const { left, top } = canvas.getBoundingClientRect();
    const { x, y, z } = places.world(event.clientX - left, event.clientY - top);
    return clampToSky(x, y, z);
  };
  const forget = (finger: number) => {
    rings.get(finger)?.remove();
    rings.delete(finger);
    starts.delete(finger);
  };
  const move = (event: PointerEvent) => {
    const ring = rings.get(event.pointerId);
    if (ring === undefined) return;
    const start = starts.get(event.pointerId) ?? { x: 0, y: 0 };
    if (places.rotatesView === true && Math.hypot(event.clientX - start.x, event.clientY - start.y) > DRAG_THRESHOLD) {
      cancel(event);
      return;
    }
    const { x, y, z } = at(event);
    const place = places.screen(x, y, z);
    ring.style.translate = `${place.x}px ${place.y}px`;
  };
  const press = (event: PointerEvent) => {
    if (event.button !== 0) return;
    canvas.focus({ preventScroll: true });
    // A pointer released outside the window may be pressed twice.
    forget(event.pointerId);
    capture(canvas, event.pointerId);
    const ring = document.createElement('div');
    ring.className = 'fw-ring';
    stage.element.append(ring);
    rings.set(event.pointerId, ring);
    starts.set(event.pointerId, { x: event.clientX, y: event.clientY });
    move(event);
    controls.startHold(stage.sim(), event.pointerId);
  };
  const release = (event: PointerEvent) => {
    if (!rings.has(event.pointerId)) return;
    forget(event.pointerId);
    controls.fire(stage.sim(), event.pointerId, at(event));
  };
  const cancel = (event: PointerEvent) => {
    if (!rings.has(event.pointerId)) return;
    forget(event.pointerId);
    stage.sim().press({ do: 'forget', finger: event.pointerId });
  };
  const listeners = { pointerdown: press, pointermove: move, pointerup: release, pointercancel: cancel };
  for (const [type, listener] of Object.entries(listeners)) canvas.addEventListener(type as 'pointerdown', listener);
  canvas.style.touchAction = 'none';
  canvas.style.cursor = 'crosshair';
  return {
    update() {
      if (rings.size === 0) return;
      for (const [finger, ring] of rings) {
        const power = stage.sim().powerOf(finger, controls.kind);
        const isSwarm = controls.kind === SWARM;
        // A swarm's ring is large from the first second, so that the number in it is readable.
        ring.style.setProperty('--power', String(isSwarm ? 0.6 + 0.4 * power : power));
        const stars = isSwarm ? String(heldStars(SHELLS[SWARM], power)) : '';
        if (ring.textContent !== stars) ring.textContent = stars;
      }
    },
    destroy() {
      for (const [type, listener] of Object.entries(listeners))
        canvas.removeEventListener(type as 'pointerdown', listener);
      for (const finger of [...rings.keys()]) forget(finger);
    },
  };
}

/** A pointer from a synthetic event cannot be captured. */
function capture(canvas: HTMLCanvasElement, pointer: number): void {
  try {
    canvas.setPointerCapture(pointer);
  } catch {}
}
