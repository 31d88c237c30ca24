/** Presses on the picture where no body is: an example may let them place and launch bodies, or hold something down. */
import { toWorld } from '@principia/render-core';
import type { Point, PointerEventName } from '@principia/scenes/examples';
import type { Settings, View, ViewContext } from '@principia/shell';
import type { LabRun } from './lab-run.ts';
import { disturb } from './on-display.ts';

/** A press that lasts. */
interface Press {
  readonly pointer: number;
  readonly run: LabRun;
  readonly from: Point;
  at: Point;
}

export interface Presses {
  /** The line from the place of the press to the pointer, while one is pressed. */
  aim(): { readonly from: Point; readonly to: Point } | undefined;
  destroy(): void;
}

/** Passes presses on the canvas of a view on to the run on display. It must be called after the view listens itself. */
export function listenToPresses(context: ViewContext<Settings, LabRun>, view: View): Presses {
  const { canvas } = view;
  const stop = new AbortController();
  const { signal } = stop;
  let press: Press | undefined;

  const placeOf = ({ clientX, clientY }: PointerEvent, { picture }: LabRun): Point => {
    const [x, y, metres] = view.camera?.() ?? [0, 0, 1];
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const up = picture.yDown ? -1 : 1;
    const camera = { x, y: up * y, pixelsPerMetre: height / metres };
    const at = toWorld(camera, { width, height }, clientX - left, clientY - top, { x: 0, y: 0 });
    return { x: at.x, y: up * at.y };
  };
  const tell = (name: PointerEventName, { run, at, from }: Press) => {
    disturb(run);
    run.point(name, at, from);
  };
  const end = (name: 'release' | 'cancel') => {
    const ended = press;
    press = undefined;
    // Another run may have begun meanwhile.
    if (ended !== undefined && ended.run === context.sim()) tell(name, ended);
  };
  const isOther = ({ pointerId }: PointerEvent) => pointerId !== press?.pointer;

  canvas.addEventListener(
    'pointerdown',
    (event) => {
      // Two fingers move the view.
      if (press !== undefined) return end('cancel');
      const { pointerId, button } = event;
      if (button !== 0 || context.isSpaceHeld() || context.dragging().dragged.length > 0) return;
      const run = context.sim();
      const at = placeOf(event, run);
      press = { pointer: pointerId, run, from: at, at };
      tell('press', press);
    },
    { signal },
  );
  canvas.addEventListener(
    'pointermove',
    (event) => {
      if (press === undefined || isOther(event)) return;
      press.at = placeOf(event, press.run);
      if (press.run === context.sim()) tell('move', press);
    },
    { signal },
  );
  canvas.addEventListener('pointerup', (event) => isOther(event) || end('release'), { signal });
  canvas.addEventListener('pointercancel', (event) => isOther(event) || end('cancel'), { signal });
  globalThis.addEventListener('blur', () => end('cancel'), { signal });
  return {
    aim: () => (press === undefined ? undefined : { from: press.from, to: press.at }),
    destroy() {
      end('cancel');
      stop.abort();
    },
  };
}
