/** A pilot that lands, or dives, and what it does with stick, throttle and brake, found without a page. */
import { step } from '@principia/physics';
import { createFlight, type Flight } from '../../games/flight-simulator/sim.ts';

/** Steps between two decisions: an eighth of a second. */
const REACTION = 30;

/** How the throttle is moved: buttons are held, a lever stays where it was put. */
export type Throttle = 'buttons' | 'lever';

/** What is held for some steps: the stick to one side or none, the throttle towards idle, the brake. */
export interface Move {
  readonly x: number;
  readonly y: number;
  readonly isIdle: boolean;
  readonly isBraking: boolean;
  readonly steps: number;
}

type Held = Omit<Move, 'steps'>;

/** Fractions as full deflections of the same mean, for one axis and then the other, as a hand of keys does. */
class Pulses {
  readonly #owed = [0, 0];
  #axis = 0;

  take(x: number, y: number): readonly [x: number, y: number] {
    const owed = this.#owed;
    owed[0] = within(owed[0] + x, 1);
    owed[1] = within(owed[1] + y, 1);
    this.#axis = 1 - this.#axis;
    const pulse = Math.round(owed[this.#axis]);
    owed[this.#axis] -= pulse;
    return this.#axis === 0 ? [pulse, 0] : [0, pulse];
  }
}

const within = (value: number, limit: number) => Math.min(limit, Math.max(-limit, value));

/** What leads down a path of four degrees to the first third of the runway, flares and stops. */
function decide(flight: Flight, pulses: Pulses): Held {
  const { attitude, height, log, plane, world } = flight;
  const { x, z } = world.components.Position;
  if (log.onGround) return { x: 0, y: 0, isIdle: true, isBraking: true };
  const path = -Math.min(4, Math.max(0, (height / Math.max(50, -150 - x[plane])) * 36));
  const wanted = height > 6 ? path : -0.35 - 0.25 * height;
  const pull = within(0.5 * (wanted - flight.climb), 0.7);
  const bank = within(-0.006 * z[plane] - 2 * (attitude.heading - Math.PI / 2), 0.5);
  const [right, up] = pulses.take(bank, -pull);
  return { x: right, y: up, isIdle: height < 6, isBraking: false };
}

function hold(flight: Flight, now: Held, before: Held | undefined, throttle: Throttle): void {
  flight.stick(now.x, now.y);
  if (throttle === 'buttons') {
    flight.press('less', now.isIdle);
    flight.press('brake', now.isBraking);
    return;
  }
  // Each pull goes to the end of the lever's way: to idle, and then to the brake.
  if (now.isIdle && before?.isIdle !== true) flight.moveLever(-1);
  if (now.isBraking && before?.isBraking !== true) flight.moveLever(-1);
}

const isSame = (a: Held, b: Held) => a.x === b.x && a.y === b.y && a.isIdle === b.isIdle && a.isBraking === b.isBraking;

/** What lands the mission of that name. */
export function landingMoves(seed: number, throttle: Throttle): Move[] {
  const values = { mission: 'landing', assist: true, inverted: false, crosswind: 0, turbulence: 0 };
  const flight = createFlight({ values, seed });
  const pulses = new Pulses();
  const moves: Move[] = [];
  for (let tick = 0; flight.log.phase === 'flying'; tick++) {
    if (tick > 240 * 240) throw new Error('The pilot does not come down.');
    if (tick % REACTION === 0) {
      const last = moves[moves.length - 1];
      const now = decide(flight, pulses);
      hold(flight, now, last, throttle);
      if (last !== undefined && isSame(last, now)) moves[moves.length - 1] = { ...last, steps: last.steps + REACTION };
      else moves.push({ ...now, steps: REACTION });
    }
    step(flight.world, flight.dt);
  }
  if (flight.log.phase !== 'landed') throw new Error('The pilot does not land.');
  return moves;
}
