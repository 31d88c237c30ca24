import type { GlobalSystem } from './types.ts';

/** Names a system for encoded snapshots. The name of a function is not used for that: minifiers change it. */
export function nameSystem<Run extends GlobalSystem>(systemName: string, run: Run): Run {
  return Object.assign(run, { systemName });
}
