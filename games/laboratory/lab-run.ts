import type { ExampleRun } from '@principia/scenes/examples';
import type { Ghosts } from './ghosts.ts';

/** A run of an example on its page, with the runs that are shown beside it. */
export interface LabRun extends ExampleRun {
  readonly ghosts: Ghosts;
}
