/** The view on display, for links that hold its camera. */
import type { View } from '@principia/shell';
import { refitWhenCovered } from './covers.ts';

let present: View | undefined;

/** @returns the same view, which fits itself into what panels leave free */
export function showing(view: View): View {
  present = refitWhenCovered(view);
  return present;
}

export const presentView = (): View | undefined => present;
