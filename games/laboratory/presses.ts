/** Presses on the picture where no body is: an example may let them place and launch bodies, or hold something down. */
import { placeOnCanvas } from '@principia/render-core';
import type { Point, PointerEventName } from '@principia/scenes/examples';
import type { Settings, ViewContext } from '@principia/shell';
import type { LabRun } from './lab-run.ts';
import { disturb } from './on-display.ts';

/** A press that lasts. */
interface Press {
  readonly pointer: number;
  readonly run: LabRun;
  readonly from: Point;
  at: Point;
}

/** CSS pixels by which a finger may slip without turning the view. */
const SLIP = 6;

export interface PressOptions {
  /** The point of the world under a place on the canvas, CSS pixels. */
  pointUnder(x: number, y: number): Point;
  /** Milliseconds after which a press that has not moved acts, where a drag turns the view; default: it acts at once. */
  readonly patience?: number;
}

export interface Presses {
  /** The line from the place of the press to the pointer, while one is pressed. */
  aim(): { readonly from: Point; readonly to: Point } | undefined;
  destroy(): void;
}

/** Passes presses on the canvas of a view on to the run on display. It must be called after the view listens itself. */
export function listenToPresses(
  context: ViewContext<Settings, LabRun>,
  canvas: HTMLCanvasElement,
  { pointUnder, patience = 0 }: PressOptions,
): Presses {
  const stop = new AbortController();
  let press: Press | undefined;

  const placeOf = (event: PointerEvent): Point => {
    const { x, y } = placeOnCanvas(canvas, event);
    return pointUnder(x, y);
  };
  const tell = (name: PointerEventName, { run, at, from }: Press) => {
    disturb(run);
    run.point(name, at, from);
  };
  const begin = (down: PointerEvent) => {
    const run = context.sim();
    const at = placeOf(down);
    press = { pointer: down.pointerId, run, from: at, at };
    tell('press', press);
  };
  const stay = waitForStay(patience, begin);
  const end = (name: 'release' | 'cancel') => {
    stay.forget();
    const ended = press;
    press = undefined;
    // Another run may have begun meanwhile.
    if (ended !== undefined && ended.run === context.sim()) tell(name, ended);
  };
  const isOther = ({ pointerId }: PointerEvent) => pointerId !== (press?.pointer ?? stay.pointer());

  const listeners = {
    pointerdown(event: PointerEvent) {
      // Two fingers move the view.
      if ((press?.pointer ?? stay.pointer()) !== undefined) return end('cancel');
      if (event.button !== 0 || context.isSpaceHeld() || context.dragging().dragged.length > 0) return;
      stay.start(event);
    },
    pointermove(event: PointerEvent) {
      if (isOther(event)) return;
      if (press === undefined) return stay.move(event);
      press.at = placeOf(event);
      if (press.run === context.sim()) tell('move', press);
    },
    pointerup(event: PointerEvent) {
      if (isOther(event)) return;
      stay.finish();
      end('release');
    },
    pointercancel: (event: PointerEvent) => void (isOther(event) || end('cancel')),
  };
  for (const [type, listener] of Object.entries(listeners)) {
    canvas.addEventListener(type, listener as EventListener, { signal: stop.signal });
  }
  globalThis.addEventListener('blur', () => end('cancel'), { signal: stop.signal });
  return {
    aim: () => (press === undefined ? undefined : { from: press.from, to: press.at }),
    destroy() {
      end('cancel');
      stop.abort();
    },
  };
}

/** Calls `begin` with a press when it has stayed in place for `patience` milliseconds, or ends. */
function waitForStay(patience: number, begin: (down: PointerEvent) => void) {
  let waiting: { readonly down: PointerEvent; readonly timer: ReturnType<typeof setTimeout> } | undefined;
  const forget = () => {
    clearTimeout(waiting?.timer);
    waiting = undefined;
  };
  const finish = () => {
    const down = waiting?.down;
    forget();
    if (down !== undefined) begin(down);
  };
  return {
    pointer: () => waiting?.down.pointerId,
    start(down: PointerEvent) {
      waiting = { down, timer: setTimeout(finish, patience) };
      if (patience === 0) finish();
    },
    move({ clientX, clientY }: PointerEvent) {
      if (waiting === undefined) return;
      const { down } = waiting;
      if (Math.hypot(clientX - down.clientX, clientY - down.clientY) > SLIP) forget();
    },
    finish,
    forget,
  };
}

/** @returns the view, which ends to listen to presses when it is destroyed */
export function withPresses<V extends { destroy(): void }>(view: V, presses: Presses): V {
  return {
    ...view,
    destroy() {
      presses.destroy();
      view.destroy();
    },
  };
}
