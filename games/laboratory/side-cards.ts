/** The cards beside the picture of an example. With the plots they are the larger part of a page, and come after the first frame. */
import type { Example } from '@principia/scenes/examples';
import type { GameCard } from '@principia/shell';
import { createAboutCard } from './about-card.ts';
import { createChecksCard } from './checks-card.ts';
import type { LabRun } from './lab-run.ts';
import { createPlotsCard } from './plots-card.ts';
import { createWordsCard } from './words-card.ts';

export function createSideCards(parent: HTMLElement, example: Example): GameCard<LabRun>[] {
  return [
    createAboutCard(parent, example),
    createChecksCard(parent, example),
    createWordsCard(parent),
    // Before the plots, which record them.
    { record: (run) => run.ghosts.follow(run.world.tick), show() {} },
    ...createPlotsCard(parent, example),
  ];
}
