/** The state of the game as text and numbers. */
import { headingOf } from './heading.ts';
import type { BlackHoleGame } from './sim.ts';

/** The result for the card with the high scores; a demo or autopilot game is not ranked. */
export function outcomeOf({ rules, isDemo, autopilot }: BlackHoleGame) {
  if (rules.phase !== 'over' || isDemo) return undefined;
  const { score, bonus, dodged } = rules;
  const levels = `${dodged} ${dodged === 1 ? 'level' : 'levels'} cleared`;
  const lines = [levels, `${score} ${score === 1 ? 'point' : 'points'} + ${bonus} bonus`];
  return { title: 'Game over', score: autopilot ? 0 : score + bonus, lines };
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
