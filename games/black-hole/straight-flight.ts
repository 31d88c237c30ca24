/** Tells whether a layout of holes lets a ship through that does nothing but climb. */
import { BLACK_HOLE, type Hole } from '@principia/scenes';
import { Flight } from './flight.ts';
import { DIRECTIONS, thrustOf } from './heading.ts';

const DT = 1 / 120;
/** Twice the time that a climb takes without holes, s. */
const MAX_SECONDS = 20;
const CLIMB = thrustOf(DIRECTIONS.up, { x: 0, y: 0 });

/** A close approach is chaotic, so ships that start this far to the side, m, must fail too. */
const ASIDE = [0, -0.5, 0.5];

/** @param isSteep uses the Paczyński–Wiita potential @returns whether full thrust straight up may reach the goal */
export function opensStraightUp(holes: readonly Hole[], isSteep: boolean): boolean {
  const flight = new Flight(isSteep);
  return ASIDE.some((aside) => {
    flight.begin({ x: BLACK_HOLE.start.x + aside, y: BLACK_HOLE.start.y, vx: 0, vy: 0 }, holes, 0);
    for (let time = 0; time < MAX_SECONDS && flight.status === 'flying'; time += DT) flight.step(DT, CLIMB);
    // A ship that still flies may reach the goal later.
    return flight.status === 'goal' || flight.status === 'flying';
  });
}
