/** What starts a paused game. */
export function resumeHint(): string {
  return hasCoarsePointer() ? 'Tap ▶ to play.' : 'Press Space or ▶ to play.';
}

/** Whether the main pointer is a finger: texts then name gestures and buttons instead of keys. */
export function hasCoarsePointer(): boolean {
  return globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
}
