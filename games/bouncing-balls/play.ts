/** What both views share: taps that explode, holds that stop time or attract, the tilt of a device, the sound of impacts, and the hint. */
import { listenToTaps, Synth, showHint, type ViewContext } from '@principia/shell';
import { offerTilt } from './device-tilt.ts';
import { listenToHolds } from './holds.ts';
import { Impacts } from './impacts.ts';
import { createMagnetButton } from './magnet-button.ts';
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
    isMagnet: () => context.values().magnet,
    freeze(isFrozen) {
      context.sim().time.isFrozen = isFrozen;
    },
    attract(x, y) {
      const at = point(x, y);
      log().add({ kind: 'magnet', x: at.x, y: at.y, z: at.z });
    },
    release: () => log().add({ kind: 'magnet off' }),
  });
  const magnet = createMagnetButton(context.element, () => context.toggle('magnet'));
  const tilt = offerTilt(context.element, ({ x, y, z }) => log().add({ kind: 'tilt', x, y, z }), context.showMessage);
  return {
    update() {
      synth.set(context.values().sound);
      impacts.update();
      magnet.show(context.values().magnet);
    },
    refresh() {
      impacts = new Impacts(context.sim(), synth);
      tilt.refresh();
    },
    destroy() {
      stopTaps();
      stopHolds();
      tilt.destroy();
      magnet.destroy();
      removeHint();
      synth.destroy();
    },
  };
}
