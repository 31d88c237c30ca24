/** The state of the game as text and numbers. */
import type { Outcome } from '@principia/shell';
import { dayOfSeed } from './daily.ts';
import { headingOf } from './heading.ts';
import type { BlackHoleGame } from './sim.ts';

/** The result for the card with the high scores; a demo or autopilot game, or one that began higher, is not ranked. */
export function outcomeOf({ rules, isDemo, autopilot, seed }: BlackHoleGame): Outcome | undefined {
  if (rules.phase !== 'over' || isDemo) return undefined;
  const { score, bonus, dodged } = rules;
  const cleared = dodged - rules.firstLevel + 1;
  const points = `${score} ${score === 1 ? 'point' : 'points'} + ${bonus} bonus`;
  const lines = [`${cleared} ${cleared === 1 ? 'level' : 'levels'} cleared`, points];
  const isWhole = rules.firstLevel === 1;
  if (!isWhole) lines.push(`Not ranked: it began at level ${rules.firstLevel}.`);
  const day = dayOfSeed(seed);
  const which = day === undefined ? '' : `, daily ${day}`;
  return {
    title: day === undefined ? 'Game over' : `Daily challenge ${day}`,
    score: autopilot || !isWhole ? 0 : score + bonus,
    lines,
    // The number after the seed of a day is that of the next day.
    ...(day === undefined ? {} : { nextSeed: 1 }),
    share: `Black hole${which}: level ${dodged + 1}, ${points}`,
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

/** The remaining lives as text. */
export function livesText(lives: number): string {
  return `lives left: ${lives}`;
}

/** The score as text; empty at the start. */
export function scoreText(score: number): string {
  if (score === 0) return '';
  return score === 1 ? '1 hole dodged' : `${score} holes dodged`;
}
