/** What both views share: taps that explode, the magnet, the tilt of a device, the sound of impacts, and the hint. */
import { listenToTaps, Synth, showHint, type ViewContext } from '@principia/shell';
import { offerTilt } from './device-tilt.ts';
import { listenToHolds } from './held-magnet.ts';
import { Impacts } from './impacts.ts';
import type { Settings } from './settings.ts';
import type { BallsRun } from './sim.ts';
import { WORDS } from './words.ts';

export interface Play {
  /** Call it once a frame. */
  update(): void;
  /** Call it when the world was replaced. */
  refresh(): void;
  destroy(): void;
}

type Point = { x: number; y: number; z: number };

/** @param point the point of the room under a place on the canvas, CSS pixels */
export function createPlay(
  context: ViewContext<Settings, BallsRun>,
  canvas: HTMLCanvasElement,
  point: (x: number, y: number) => Point,
): Play {
  const synth = new Synth();
  let impacts = new Impacts(context.sim(), synth);
  const log = () => context.sim().log;
  const removeHint = showHint(context.element, WORDS.hint);
  const stopTaps = listenToTaps(canvas, (x, y) => {
    const at = point(x, y);
    log().add({ kind: 'blast', x: at.x, y: at.y, z: at.z });
    synth.noise({ frequency: 900, to: 60, loudness: 0.7, seconds: 0.7 });
  });
  const stopHolds = listenToHolds(context.element, canvas, {
    isTaken: (pointer) => context.dragging().holds(pointer) || context.isSpaceHeld(),
    attract(x, y) {
      const at = point(x, y);
      log().add({ kind: 'magnet', x: at.x, y: at.y, z: at.z });
    },
    release: () => log().add({ kind: 'magnet off' }),
  });
  const tilt = offerTilt(context.element, ({ x, y, z }) => log().add({ kind: 'tilt', x, y, z }), context.showMessage);
  return {
    update() {
      synth.set(context.values().sound);
      impacts.update();
    },
    refresh() {
      impacts = new Impacts(context.sim(), synth);
      tilt.refresh();
    },
    destroy() {
      stopTaps();
      stopHolds();
      tilt.destroy();
      removeHint();
      synth.destroy();
    },
  };
}
