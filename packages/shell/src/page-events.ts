/** What happens to the page around a game. */
export interface PageEvents {
  /** The page was hidden: another tab or window covers it. */
  onHidden(): void;
  /** The system asks for reduced motion now, or no longer. */
  onReducedMotion(isWanted: boolean): void;
}

const REDUCED_MOTION = '(prefers-reduced-motion: reduce)';

/** Whether the system asks for reduced motion. */
export const systemReducesMotion = (): boolean => matchMedia(REDUCED_MOTION).matches;

/** Listens until the signal. */
export function listenToPage({ onHidden, onReducedMotion }: PageEvents, signal: AbortSignal): void {
  document.addEventListener('visibilitychange', () => document.hidden && onHidden(), { signal });
  const motion = matchMedia(REDUCED_MOTION);
  motion.addEventListener('change', ({ matches }) => onReducedMotion(matches), { signal });
}
