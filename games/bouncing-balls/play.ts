/** What both views share: taps that explode, the sound of impacts, and the hint. */
import { hasCoarsePointer, listenToTaps, Synth, showHint, type ViewContext } from '@principia/shell';
import { Impacts } from './impacts.ts';
import type { Settings } from './settings.ts';
import { type BallsRun, blast } from './sim.ts';

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
  const removeHint = showHint(
    context.element,
    hasCoarsePointer()
      ? 'Tap to blow balls up, drag to throw them'
      : 'Click to blow balls up, drag to throw them, hold V to pour',
  );
  const stopTaps = listenToTaps(canvas, (x, y) => {
    const centre = point(x, y);
    blast(context.sim(), centre);
    synth.noise({ frequency: 900, to: 60, loudness: 0.7, seconds: 0.7 });
  });
  return {
    update() {
      synth.set(context.values().sound);
      impacts.update();
    },
    refresh() {
      impacts = new Impacts(context.sim(), synth);
    },
    destroy() {
      stopTaps();
      removeHint();
      synth.destroy();
    },
  };
}
