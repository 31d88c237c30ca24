import { withSettings } from './address.ts';
import type { Settings, ValuesOf } from './settings.ts';

/** Shortest time between two changes of the address, ms: browsers refuse pages that change it more than a hundred times in 30 s. */
const INTERVAL = 500;

/**
 * Keeps the settings in the address of the page, so that it can be copied, and loaded again, at any time.
 * @param values the present settings @returns what to call after each change of them
 */
export function keepInAddress<S extends Settings>(settings: S, values: ValuesOf<S>, signal: AbortSignal): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  signal.addEventListener('abort', () => clearTimeout(timer));
  const write = () => {
    timer = undefined;
    try {
      history.replaceState(history.state, '', withSettings(location.href, settings, values));
    } catch {
      // A page without an origin of its own, as in some frames, may not change its address.
    }
  };
  return () => {
    if (!signal.aborted) timer ??= setTimeout(write, INTERVAL);
  };
}
