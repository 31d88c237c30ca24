import { words } from './words.ts';

/** What starts a paused game. */
export function resumeHint(): string {
  return hasCoarsePointer() ? words().resumeByTouch : words().resumeByKey;
}

/** Whether the main pointer is a finger: texts then name gestures and buttons instead of keys. */
export function hasCoarsePointer(): boolean {
  return globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
}
