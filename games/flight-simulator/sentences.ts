/** What the player is told: what to do now, and how the flight ended. */
import { stallSpeed } from './aircraft.ts';
import { RINGS } from './course.ts';
import { BREAKING_SINK, type FlightLog, SOFT_SINK } from './referee.ts';
import type { Flight } from './sim.ts';
import { WORDS } from './words.ts';

/** Sink rate of a landing that is no longer a good one, m/s. */
const FIRM_SINK = 1.5;

/** What to do now, in a sentence; empty where there is nothing. */
export function objective(flight: Flight): string {
  const { log, pilot, attitude, mission } = flight;
  const { tasks } = WORDS;
  const takeOff = 1.15 * stallSpeed();
  if (log.phase !== 'flying') return '';
  if (flight.isStalling) return tasks.stall;
  if (log.onGround && !log.hasFlown) {
    if (pilot.throttle < 0.9) return tasks.throttle;
    return attitude.airspeed < takeOff ? tasks.gather : tasks.rotate;
  }
  if (mission === 'free') return '';
  if (log.ring < RINGS.length) return tasks.ring(log.ring + 1, RINGS.length);
  if (log.onGround) return tasks.brake;
  if (flight.height < 8) return tasks.flare;
  return attitude.airspeed < takeOff ? tasks.slow : tasks.approach;
}

/** Why the aeroplane crashed, or how it landed; empty while it flies. */
export function reasonOf(log: Readonly<FlightLog>): string {
  if (log.phase === 'landed') return landing(log);
  const { cause, part, degrees, sink } = log;
  const [first, within] = WORDS.parts[part];
  if (cause === 'none') return '';
  if (cause === 'offMap') return WORDS.offMap;
  if (cause === 'gearBroke') return WORDS.gearBroke(sink, BREAKING_SINK);
  if (cause === 'stalled') return WORDS.stalled(degrees, sink);
  if (cause === 'dived') return WORDS.dived(sink);
  if (cause === 'hill') return WORDS.hill(within);
  if (part === 'leftWing' || part === 'rightWing') return WORDS.wingStruck(first, degrees);
  if (part === 'tail') return WORDS.tailStruck(degrees);
  return part === 'propeller' ? WORDS.propellerStruck(degrees) : WORDS.struck(first);
}

function landing({ touchSink, touchZ, bounces, isOnRunway, landingScore }: Readonly<FlightLog>): string {
  const where = isOnRunway ? WORDS.fromLine(Math.abs(touchZ)) : WORDS.onGrass;
  const how = touchSink < SOFT_SINK ? WORDS.soft : touchSink < FIRM_SINK ? WORDS.good : WORDS.firm;
  const details = bounces === 0 ? where : `${where}, ${WORDS.bounces(bounces)}`;
  return WORDS.landing(how, touchSink, details, landingScore);
}
