/** What the shell and the tests learn about a game. */
import { BODY_NAMES } from '@principia/scenes';
import type { Outcome } from '@principia/shell';
import { LOOKS } from './bodies.ts';
import { dayText } from './dates.ts';
import { indexOf } from './flight.ts';
import { pointsOf } from './missions.ts';
import type { SolarGame } from './sim.ts';
import { flightLines, OUTCOMES, shareLine } from './words.ts';

/** The result of a flight that ended, unless it was repeated from a link. */
export function outcomeOf(sim: SolarGame): Outcome | undefined {
  const { flight, mission } = sim;
  if (mission === undefined || sim.isReplay || !isOver(sim)) return undefined;
  const days = sim.flightDays();
  const points = scoreOf(sim);
  return {
    title: titleOf(sim),
    score: points,
    lines: [...flightLines(mission, flight.deltaV, days, flight.closest[indexOf(mission.target)]), `${points} points`],
    ...(flight.phase === 'arrived' ? { share: shareLine(mission, flight.deltaV, days, points) } : {}),
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
  if (flight.phase === 'crashed') return OUTCOMES.crashed(LOOKS[BODY_NAMES[flight.hit]].label);
  return flight.phase === 'arrived' ? OUTCOMES.arrived(mission) : OUTCOMES.lost(mission);
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
