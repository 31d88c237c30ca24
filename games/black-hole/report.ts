/** The state of the game as text and numbers. */
import type { Outcome } from '@principia/shell';
import { dayOfSeed, unbroken } from './daily.ts';
import { headingOf } from './heading.ts';
import type { BlackHoleGame } from './sim.ts';
import { WORDS } from './words.ts';

/** The result for the card with the high scores; a demo, a game in which the autopilot flew, or one that began higher is not ranked. */
export function outcomeOf({ rules, isDemo, seed }: BlackHoleGame): Outcome | undefined {
  if (rules.phase !== 'over' || isDemo) return undefined;
  const { score, bonus, dodged, slingshots } = rules;
  const cleared = dodged - rules.firstLevel + 1;
  const points = WORDS.points(score, bonus);
  const flown = WORDS.slingshots(slingshots);
  const lines = [`${WORDS.cleared(cleared)}, ${flown}`, points];
  const isWhole = rules.firstLevel === 1;
  if (!isWhole) lines.push(WORDS.notRanked(rules.firstLevel));
  const day = dayOfSeed(seed);
  return {
    title: day === undefined ? WORDS.over : WORDS.dailyTitle(unbroken(day)),
    score: rules.isAssisted || !isWhole ? 0 : score + bonus,
    lines,
    // The number after the seed of a day is that of the next day.
    ...(day === undefined ? {} : { nextSeed: 1 }),
    share:
      day === undefined ? WORDS.share(dodged + 1, flown, points) : WORDS.shareDaily(day, dodged + 1, flown, points),
  };
}

/** The state that tests read. */
export function reportState(game: BlackHoleGame) {
  const { phase, lives, score, bonus, dodged, goalPoints, fuel, slings, push, eventCount } = game.rules;
  const { scene, isDemo, isReplay } = game;
  return {
    phase,
    lives,
    score,
    bonus,
    dodged,
    goalPoints,
    fuel,
    slings,
    heading: headingOf(push),
    push,
    eventCount,
    isDemo,
    isReplay,
    holes: scene.holes,
    ship: scene.ship,
    hash: game.hash(),
    log: [...game.log.entries],
  };
}
