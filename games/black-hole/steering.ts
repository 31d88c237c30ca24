/** Control by touch or mouse: thrust points towards the pointer; a double tap changes the layout. */
import type { Heading } from './heading.ts';
import type { Input } from './sim.ts';

/** A second tap within this time, s, and distance, CSS pixels, counts as a double tap. */
const DOUBLE = { seconds: 0.35, pixels: 30 } as const;
/** Distance from the ship within which the direction is undefined, CSS pixels. */
const DEAD_ZONE = 6;

export interface SteeringOptions {
  /** Position of the ship on the canvas, CSS pixels. */
  ship(): { x: number; y: number };
  press(input: Input): void;
}

export interface Steering {
  /** Call it once a frame, because the ship moves below a resting pointer. */
  update(): void;
  destroy(): void;
}

export function listenToSteering(canvas: HTMLCanvasElement, { ship, press }: SteeringOptions): Steering {
  let pointer: number | undefined;
  let heading: Heading | undefined;
  const place = { x: 0, y: 0 };
  const tap = { time: Number.NEGATIVE_INFINITY, x: 0, y: 0 };
  const locate = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect();
    place.x = event.clientX - box.left;
    place.y = event.clientY - box.top;
  };
  const update = () => {
    if (pointer === undefined) return;
    const { x, y } = ship();
    const wanted = nearestHeading(place.x - x, place.y - y) ?? heading;
    if (wanted === undefined || wanted === heading) return;
    heading = wanted;
    press(wanted);
  };
  const down = (event: PointerEvent) => {
    if (event.button !== 0 || pointer !== undefined) return;
    locate(event);
    const seconds = event.timeStamp / 1000;
    const isDouble =
      seconds - tap.time < DOUBLE.seconds && Math.hypot(place.x - tap.x, place.y - tap.y) < DOUBLE.pixels;
    Object.assign(tap, place, { time: isDouble ? Number.NEGATIVE_INFINITY : seconds });
    if (isDouble) {
      press('redraw');
      return;
    }
    pointer = event.pointerId;
    canvas.setPointerCapture(pointer);
    update();
  };
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    locate(event);
    update();
  };
  const up = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    pointer = undefined;
    if (heading !== undefined) press('release');
    heading = undefined;
  };
  const handlers = [
    ['pointerdown', down],
    ['pointermove', move],
    ['pointerup', up],
    ['pointercancel', up],
  ] as const;
  canvas.style.touchAction = 'none';
  for (const [type, handler] of handlers) canvas.addEventListener(type, handler);
  return {
    update,
    destroy() {
      for (const [type, handler] of handlers) canvas.removeEventListener(type, handler);
    },
  };
}

/** The direction of the screen that is nearest to an offset, y down. */
function nearestHeading(dx: number, dy: number): Heading | undefined {
  if (Math.max(Math.abs(dx), Math.abs(dy)) < DEAD_ZONE) return undefined;
  if (Math.abs(dx) > Math.abs(dy)) return dx > 0 ? 'right' : 'left';
  return dy > 0 ? 'down' : 'up';
}
