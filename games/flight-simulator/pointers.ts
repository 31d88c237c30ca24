/** The mouse flies: a drag is the stick, the wheel the throttle. The right button, Space or a finger looks around. */
import type { ViewContext } from '@principia/shell';
import type { FlightCamera } from './camera.ts';
import type { Settings } from './settings.ts';
import type { Flight } from './sim.ts';

/** Distance of a full deflection from where the mouse was pressed, CSS pixels. */
const REACH = 90;
/** Throttle per CSS pixel of the wheel: a notch is a tenth. */
const LEVER = 1 / 1000;
/** Steps per unit of the stick. */
const STEPS = 20;

const STYLE = `position: absolute; left: 0; top: 0; width: ${2 * REACH}px; height: ${2 * REACH}px; margin: -${REACH}px;
  border: 1px solid #ffffff70; border-radius: 50%; box-sizing: border-box; pointer-events: none; display: none; place-items: center`;
const KNOB = 'width: 36px; height: 36px; border-radius: 50%; background: #ffffff66; border: 1px solid #fff';

/** @returns a function that stops listening */
export function listenToPointers(
  context: ViewContext<Settings, Flight>,
  canvas: HTMLCanvasElement,
  { own }: FlightCamera,
): () => void {
  const stop = new AbortController();
  const { signal } = stop;
  const stick = createMouseStick(context.element, (x, y) => context.sim().stick(x, y));
  canvas.style.touchAction = 'none';
  const listen = (type: 'pointermove' | 'pointerup' | 'pointercancel', use: (event: PointerEvent) => void) =>
    canvas.addEventListener(type, use, { signal });
  canvas.addEventListener(
    'pointerdown',
    (event) => {
      canvas.setPointerCapture(event.pointerId);
      if (event.pointerType === 'mouse' && event.button === 0 && !context.isSpaceHeld()) stick.press(event);
    },
    { signal },
  );
  listen('pointermove', (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return;
    if (stick.isHeld) return stick.move(event);
    own.turn -= event.movementX / 160;
    own.lift = Math.min(1.2, Math.max(-0.5, own.lift + event.movementY / 220));
  });
  listen('pointerup', stick.release);
  listen('pointercancel', stick.release);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      context.sim().moveLever(-LEVER * event.deltaY);
    },
    { signal, passive: false },
  );
  return () => {
    stop.abort();
    stick.release();
    stick.remove();
  };
}

/** A ring where the mouse was pressed, and a knob in it. @param steer takes fractions, y up */
function createMouseStick(parent: HTMLElement, steer: (x: number, y: number) => void) {
  const ring = document.createElement('div');
  ring.style.cssText = STYLE;
  const knob = document.createElement('i');
  knob.style.cssText = KNOB;
  ring.append(knob);
  parent.append(ring);
  const centre = { x: 0, y: 0 };
  const set = (x: number, y: number) => {
    const shrink = 1 / Math.max(1, Math.hypot(x, y));
    const [right, down] = [x * shrink, y * shrink];
    knob.style.translate = `${REACH * right}px ${REACH * down}px`;
    steer(Math.round(STEPS * right) / STEPS, -Math.round(STEPS * down) / STEPS);
  };
  const held = {
    isHeld: false,
    press({ clientX, clientY, offsetX, offsetY }: PointerEvent) {
      held.isHeld = true;
      [centre.x, centre.y] = [clientX, clientY];
      ring.style.translate = `${offsetX}px ${offsetY}px`;
      ring.style.display = 'grid';
      set(0, 0);
    },
    move: ({ clientX, clientY }: PointerEvent) => set((clientX - centre.x) / REACH, (clientY - centre.y) / REACH),
    release() {
      if (!held.isHeld) return;
      held.isHeld = false;
      ring.style.display = 'none';
      set(0, 0);
    },
    remove: () => ring.remove(),
  };
  return held;
}
