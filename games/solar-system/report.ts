/** What the shell and the tests learn about a game. */
import { BODY_NAMES } from '@principia/scenes';
import { inLanguage, type Outcome } from '@principia/shell';
import { dayText } from './dates.ts';
import { indexOf } from './flight.ts';
import { type Mission, pointsOf } from './missions.ts';
import type { SolarGame } from './sim.ts';
import { distanceText, speedText, WORDS } from './words.ts';

/** The result of a flight that ended, unless it was repeated from a link. */
export function outcomeOf(sim: SolarGame): Outcome | undefined {
  const { flight, mission } = sim;
  if (mission === undefined || sim.isReplay || !isOver(sim)) return undefined;
  const days = sim.flightDays();
  const points = scoreOf(sim);
  return {
    title: titleOf(sim),
    score: points,
    lines: [...flightLines(sim, mission), WORDS.points(points)],
    ...(flight.phase === 'arrived'
      ? { share: WORDS.share(WORDS.missions[mission.id].title, points, speedText(flight.deltaV), Math.round(days)) }
      : {}),
  };
}

export function isOver({ flight: { phase } }: SolarGame): boolean {
  return phase === 'arrived' || phase === 'lost' || phase === 'crashed';
}

export function scoreOf(sim: SolarGame): number {
  const { mission, flight } = sim;
  if (mission === undefined || flight.phase !== 'arrived') return 0;
  return pointsOf(mission, flight.deltaV, sim.flightDays());
}

export function titleOf({ mission, flight }: SolarGame): string {
  if (mission === undefined) return '';
  if (flight.phase === 'crashed') return WORDS.hit(WORDS.bodies[BODY_NAMES[flight.hit]][1]);
  const [target] = WORDS.bodies[mission.target];
  return flight.phase === 'arrived' ? WORDS.arrived(target) : WORDS.lost(target);
}

/** What a flight has come to: what it spent, and how near it came. */
export function flightLines(sim: SolarGame, { target, budget }: Mission): string[] {
  const { deltaV, closest } = sim.flight;
  return [
    WORDS.result(WORDS.spent(speedText(deltaV), inLanguage(String(budget))), Math.round(sim.flightDays())),
    WORDS.closest(WORDS.bodies[target][0], distanceText(closest[indexOf(target)])),
  ];
}

/** The state that tests read. */
export function reportState(sim: SolarGame) {
  const { clock, flight } = sim;
  const errors = BODY_NAMES.map((name, i) => [name, sim.errors[i]] as const);
  return {
    date: clock.isTravelling ? '' : dayText(clock.julianDate),
    rate: clock.rate,
    actualRate: clock.actualRate,
    limit: clock.limit,
    errorsKm: Object.fromEntries(errors.filter(([, error]) => !Number.isNaN(error))),
    phase: flight.phase,
    mission: flight.mission,
    deltaV: flight.deltaV,
    days: sim.flightDays(),
    score: scoreOf(sim),
    isReplay: sim.isReplay,
  };
}
