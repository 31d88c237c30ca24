/** Tells whether a layout of holes lets a ship through whose player holds one key and does nothing else. */
import { BLACK_HOLE, type Hole } from '@principia/scenes';
import { Flight } from './flight.ts';
import { DIRECTIONS, type Push, thrustOf } from './heading.ts';

const DT = 1 / 120;
/** Twice the time that a climb takes without holes, s. */
const MAX_SECONDS = 20;

/** A close approach is chaotic, so ships that start this far to the side, m, must fail too. */
const ASIDE = [0, -0.5, 0.5];

/**
 * Who waits below moving holes climbs past another layout. Waits that are tried, s: a hole moves by 14 m at most between two, less
 * than its disc is wide, and the slowest goes round nearly once in the longest. Longer steps are enough to find the gaps.
 */
const WAITS = { between: 0.5, longest: 24, dt: 1 / 60 } as const;

/** @param isSteep uses the Paczyński–Wiita potential @returns whether full thrust in one direction may reach the goal */
export function opensToOneKey(holes: readonly Hole[], isSteep: boolean): boolean {
  const flight = new Flight(isSteep);
  const isOpenAtOnce = Object.values(DIRECTIONS).some((push) =>
    ASIDE.some((aside) => mayArrive(flight, holes, push, { aside, start: 0, dt: DT })),
  );
  return isOpenAtOnce || (holes.some(({ orbit }) => orbit > 0) && opensLater(flight, holes));
}

/** Whether a wait and a climb may reach the goal. */
function opensLater(flight: Flight, holes: readonly Hole[]): boolean {
  const { between, longest, dt } = WAITS;
  for (let start = between; start <= longest; start += between) {
    if (mayArrive(flight, holes, DIRECTIONS.up, { aside: 0, start, dt })) return true;
  }
  return false;
}

interface Try {
  readonly aside: number;
  /** Time of the moving holes on their orbits at the launch, s. */
  readonly start: number;
  readonly dt: number;
}

function mayArrive(flight: Flight, holes: readonly Hole[], push: Push, { aside, start, dt }: Try): boolean {
  const thrust = thrustOf(push, { x: 0, y: 0 });
  flight.begin({ x: BLACK_HOLE.start.x + aside, y: BLACK_HOLE.start.y, vx: 0, vy: 0 }, holes, start);
  for (let time = 0; time < MAX_SECONDS && flight.status === 'flying'; time += dt) flight.step(dt, thrust);
  // A ship that still flies may reach the goal later.
  return flight.status === 'goal' || flight.status === 'flying';
}
