import type { ExampleRun } from '@principia/scenes/examples';
import type { Ghosts } from './ghosts.ts';

/** A run of an example on its page, with the runs that are shown beside it. */
export interface LabRun extends ExampleRun {
  readonly ghosts: Ghosts;
}

/** Pictures whose trails get poses that no frame shows. */
export interface Trailing {
  /** Adds the present pose to the trails. */
  recordTrails(): void;
}
