/** The view and the run on display, for links that hold a moment and for buttons that act. */
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

let run: LabRun | undefined;

/** @returns the same run */
export function presenting(started: LabRun): LabRun {
  run = started;
  return started;
}

export const presentRun = (): LabRun | undefined => run;
