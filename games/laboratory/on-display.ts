/** The view and the run on display, for links that hold a moment, for buttons that act, and for figures that are judged. */
import type { View } from '@principia/shell';
import { refitWhenCovered } from './covers.ts';
import type { LabRun } from './lab-run.ts';

let present: View | undefined;

/** @returns the same view, which fits itself into what panels leave free */
export function showing(view: View): View {
  present = refitWhenCovered(view);
  return present;
}

export const presentView = (): View | undefined => present;

let lengthenTrails: (() => void) | undefined;

/** Notes how the picture on display adds the present pose to its trails. */
export function trailing(record: () => void): void {
  lengthenTrails = record;
}

/** Adds the present pose to the trails, which otherwise happens once a frame. */
export const recordTrails = (): void => lengthenTrails?.();

let run: LabRun | undefined;

/** @returns the same run */
export function presenting(started: LabRun): LabRun {
  run = started;
  return started;
}

export const presentRun = (): LabRun | undefined => run;

const disturbed = new WeakSet<object>();

/** Notes that the reader took part in the run: its figures no longer prove anything. */
export function disturb(touched: object): void {
  disturbed.add(touched);
}

export const isDisturbed = (touched: object): boolean => disturbed.has(touched);

/** Presses or releases the key of an action. */
export function actOn(acted: LabRun | undefined, name: string, isDown: boolean): void {
  if (acted === undefined) return;
  disturb(acted);
  acted.act(name, isDown);
}
