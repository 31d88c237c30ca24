/** The game in words and numbers. */
import type { BlackHoleGame } from './sim.ts';

/** The end, for the card with the high scores; what the computer played is nobody's score. */
export function outcomeOf({ rules, isDemo, autopilot }: BlackHoleGame) {
  if (rules.phase !== 'over' || isDemo) return undefined;
  const { score, bonus, dodged } = rules;
  const levels = `${dodged} ${dodged === 1 ? 'level' : 'levels'} cleared`;
  const lines = [levels, `${score} ${score === 1 ? 'point' : 'points'} + ${bonus} bonus`];
  return { title: 'Game over', score: autopilot ? 0 : score + bonus, lines };
}

/** What tests see. */
export function tell(game: BlackHoleGame) {
  const { phase, lives, score, bonus, dodged, prize, fuel, slings, heading, newsCount } = game.rules;
  const { scene, isDemo, isReplay } = game;
  return {
    phase,
    lives,
    score,
    bonus,
    dodged,
    prize,
    fuel,
    slings,
    heading: heading ?? '',
    newsCount,
    isDemo,
    isReplay,
    holes: scene.holes,
    ship: scene.ship,
    hash: game.hash(),
    log: [...game.log.entries],
  };
}

/** Lives in words. */
export function livesText(lives: number): string {
  return `lives left: ${lives}`;
}

/** The score in words; none at the start. */
export function dodgeText(score: number): string {
  if (score === 0) return '';
  return score === 1 ? '1 hole dodged' : `${score} holes dodged`;
}
