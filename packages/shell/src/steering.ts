import { placeOnCanvas } from '@principia/render-core';

/** Distances from the craft, CSS pixels: below the first the engine is off, beyond the second it gives full thrust. */
const DEAD_ZONE = 8;
const FULL_THRUST = 60;

/** What `listenToSteering` asks for and tells. */
export interface SteeringOptions {
  /** Position of the craft on the canvas, CSS pixels. */
  craft(): { x: number; y: number };
  /** Takes fractions of full thrust, y up; (0, 0) when the pointer is released. */
  steer(x: number, y: number): void;
}

/** A canvas that steers a craft until `destroy()`. */
export interface Steering {
  /** Call it once a frame, because the craft moves below a resting pointer. */
  update(): void;
  /** Lets go of the craft, as when the pointer is released, and stops listening. */
  destroy(): void;
}

/**
 * Control by touch or mouse: a craft goes towards the pointer that is down, the harder the farther away it is, with full thrust
 * from 60 CSS pixels on. Sets `touch-action: none` on the canvas, and restores it on `destroy()`.
 */
export function listenToSteering(canvas: HTMLCanvasElement, { craft, steer }: SteeringOptions): Steering {
  let pointer: number | undefined;
  // A typed array, because a captured variable would allocate a number on the heap in every frame.
  const sent = new Float64Array(2);
  let place = { x: 0, y: 0 };
  const send = (x: number, y: number) => {
    if (x === sent[0] && y === sent[1]) return;
    sent[0] = x;
    sent[1] = y;
    steer(x, y);
  };
  const update = () => {
    if (pointer === undefined) return;
    const { x, y } = craft();
    const dx = place.x - x;
    const dy = y - place.y;
    const distance = Math.hypot(dx, dy);
    const strength = Math.min(1, (distance - DEAD_ZONE) / (FULL_THRUST - DEAD_ZONE));
    if (strength > 0) send(rounded((strength * dx) / distance), rounded((strength * dy) / distance));
    else send(0, 0);
  };
  const down = (event: PointerEvent) => {
    if (event.button !== 0 || pointer !== undefined) return;
    place = placeOnCanvas(canvas, event);
    pointer = event.pointerId;
    canvas.setPointerCapture(pointer);
    // A press always counts, for a flight that ended has forgotten the last one.
    sent.fill(Number.NaN);
    update();
  };
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    place = placeOnCanvas(canvas, event);
    update();
  };
  const letGo = () => {
    pointer = undefined;
    send(0, 0);
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId === pointer) letGo();
  };
  const handlers = [
    ['pointerdown', down],
    ['pointermove', move],
    ['pointerup', up],
    ['pointercancel', up],
  ] as const;
  const { touchAction } = canvas.style;
  canvas.style.touchAction = 'none';
  for (const [type, handler] of handlers) canvas.addEventListener(type, handler);
  return {
    update,
    destroy() {
      for (const [type, handler] of handlers) canvas.removeEventListener(type, handler);
      canvas.style.touchAction = touchAction;
      if (pointer !== undefined) letGo();
    },
  };
}

/** Twentieths, as the game logs them, so that a resting pointer sends nothing new. */
function rounded(value: number): number {
  return Math.round(20 * value) / 20;
}
