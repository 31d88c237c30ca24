/** Tells whether a layout of holes lets a ship through whose player holds one key and does nothing else. */
import { BLACK_HOLE, type Hole } from '@principia/scenes';
import { Flight } from './flight.ts';
import { DIRECTIONS, type Push, thrustOf } from './heading.ts';

const DT = 1 / 120;
/** Twice the time that a climb takes without holes, s. */
const MAX_SECONDS = 20;

/** A close approach is chaotic, so ships that start this far to the side, m, must fail too. */
const ASIDE = [0, -0.5, 0.5];

/** @param isSteep uses the Paczyński–Wiita potential @returns whether full thrust in one direction may reach the goal */
export function opensToOneKey(holes: readonly Hole[], isSteep: boolean): boolean {
  const flight = new Flight(isSteep);
  return Object.values(DIRECTIONS).some((push) => ASIDE.some((aside) => mayArrive(flight, holes, push, aside)));
}

function mayArrive(flight: Flight, holes: readonly Hole[], push: Push, aside: number): boolean {
  const thrust = thrustOf(push, { x: 0, y: 0 });
  flight.begin({ x: BLACK_HOLE.start.x + aside, y: BLACK_HOLE.start.y, vx: 0, vy: 0 }, holes, 0);
  for (let time = 0; time < MAX_SECONDS && flight.status === 'flying'; time += DT) flight.step(DT, thrust);
  // A ship that still flies may reach the goal later.
  return flight.status === 'goal' || flight.status === 'flying';
}
