/** Judges the flight: rings, touchdowns, landings, and the reasons of crashes. */
import type { PhysicsWorld } from '@principia/physics';
import type { Attitude } from './attitude.ts';
import { type Axes, rotated } from './body-frame.ts';
import { type Mission, RING_RADIUS, RINGS } from './course.ts';
import { compression, WHEELS } from './landing-gear.ts';
import { groundHeight, isOnRunway, MAP_RADIUS, RUNWAY } from './terrain.ts';

/** Parts of the aeroplane that must not strike the ground. */
export type Part = 'gear' | 'propeller' | 'belly' | 'tail' | 'leftWing' | 'rightWing' | 'cabin';
export type CrashCause = 'none' | 'offMap' | 'gearBroke' | 'stalled' | 'dived' | 'hill' | 'struck';

/** The course of a flight; plain values, so that rewinding restores them. */
export interface FlightLog {
  phase: 'flying' | 'landed' | 'crashed';
  /** Why the aeroplane crashed; `none` while it has not. */
  cause: CrashCause;
  /** What struck the ground. */
  part: Part;
  /** Angle of attack, bank or pitch that caused a crash, degrees. */
  degrees: number;
  /** Sink rate that caused it, m/s. */
  sink: number;
  /** It has been higher than a few metres. */
  hasFlown: boolean;
  onGround: boolean;
  /** Index of the next ring. */
  ring: number;
  ringsFlown: number;
  /** The touchdown that counts is the hardest. Sink rate, m/s. */
  touchSink: number;
  touchX: number;
  touchZ: number;
  bounces: number;
  /** Points of the landing alone. */
  landingScore: number;
  /** Where it came to rest. */
  isOnRunway: boolean;
  /** Steps at rest after the flight. */
  restSteps: number;
  score: number;
  lastX: number;
  lastZ: number;
  lastSink: number;
}

/** Sink rate that breaks the gear, m/s; and one that passengers do not notice. */
export const BREAKING_SINK = 4.5;
/** Sinking faster, it is no landing at all. */
const DIVE_SINK = 7;
export const SOFT_SINK = 0.6;
const HARD_SINK = 3;
const RING_SCORE = 100;

/** Points of the hull that must not touch the ground, in the body's axes, m. */
const HULL: readonly (readonly [part: Part, at: Readonly<Axes>])[] = [
  ['propeller', { x: 2.3, y: -0.95, z: 0 }],
  ['belly', { x: -0.5, y: -0.75, z: 0 }],
  ['tail', { x: -5.2, y: 0.1, z: 0 }],
  ['leftWing', { x: 0.2, y: 0.8, z: -5.5 }],
  ['rightWing', { x: 0.2, y: 0.8, z: 5.5 }],
  ['cabin', { x: 0.3, y: 1, z: 0 }],
];

export function createLog(mission: Mission, at: Readonly<Axes>): FlightLog {
  return {
    phase: 'flying',
    cause: 'none',
    part: 'gear',
    degrees: 0,
    sink: 0,
    hasFlown: mission === 'landing',
    onGround: mission !== 'landing',
    ring: mission === 'circuit' ? 0 : RINGS.length,
    ringsFlown: 0,
    touchSink: 0,
    touchX: 0,
    touchZ: 0,
    bounces: 0,
    landingScore: 0,
    isOnRunway: true,
    restSteps: 0,
    score: 0,
    lastX: at.x,
    lastZ: at.z,
    lastSink: 0,
  };
}

const arm: Axes = { x: 0, y: 0, z: 0 };

/** Judges the step that has just ended. */
export function judge(
  world: PhysicsWorld,
  plane: number,
  log: FlightLog,
  attitude: Readonly<Attitude>,
  mission: Mission,
): void {
  if (log.phase !== 'flying') return;
  const { Position: p, Velocity: v } = world.components;
  const height = p.y[plane] - groundHeight(p.x[plane], p.z[plane]);
  if (height > 8) log.hasFlown = true;
  passRings(log, p.x[plane], p.y[plane], p.z[plane]);
  const isDive = touchDown(world, plane, log);
  const struck = isDive ? 'gear' : height < 12 ? struckPart(world, plane) : undefined;
  if (struck !== undefined) {
    crash(log, causeOf(struck, attitude, Math.max(log.lastSink, -v.y[plane]), groundHeight(p.x[plane], p.z[plane])));
  }
  if (Math.max(Math.abs(p.x[plane]), Math.abs(p.z[plane])) > MAP_RADIUS) {
    crash(log, { cause: 'offMap' });
  }
  if (log.phase !== 'flying') return;
  const speed = Math.sqrt(v.x[plane] * v.x[plane] + v.z[plane] * v.z[plane]);
  log.restSteps = log.hasFlown && log.onGround && speed < 1 ? log.restSteps + 1 : 0;
  if (log.restSteps > 60 && mission !== 'free') land(log, p.x[plane], p.z[plane]);
  log.lastX = p.x[plane];
  log.lastZ = p.z[plane];
  log.lastSink = -v.y[plane];
}

/** Returns whether the aeroplane dived into the ground. */
function touchDown(world: PhysicsWorld, plane: number, log: FlightLog): boolean {
  const isDown = WHEELS.some((wheel) => compression(world, plane, wheel) > 0);
  if (isDown && !log.onGround && log.hasFlown) {
    const { x, z } = world.components.Position;
    if (log.touchSink > 0) log.bounces++;
    if (log.lastSink > BREAKING_SINK && log.lastSink < DIVE_SINK) {
      crash(log, { cause: 'gearBroke', sink: log.lastSink });
    }
    if (log.touchSink === 0) [log.touchX, log.touchZ] = [x[plane], z[plane]];
    log.touchSink = Math.max(log.touchSink, log.lastSink, 0.01);
  }
  // Taking off again makes the next touchdown count from the beginning.
  const { x, y, z } = world.components.Position;
  if (!isDown && y[plane] - groundHeight(x[plane], z[plane]) > 15) Object.assign(log, AIRBORNE);
  const isDive = isDown && !log.onGround && log.lastSink >= DIVE_SINK;
  log.onGround = isDown;
  return isDive;
}

const AIRBORNE = { touchSink: 0, bounces: 0 };

function struckPart(world: PhysicsWorld, plane: number): Part | undefined {
  const { x, y, z } = world.components.Position;
  for (const [part, at] of HULL) {
    rotated(world, plane, at, arm);
    if (y[plane] + arm.y < groundHeight(x[plane] + arm.x, z[plane] + arm.z)) return part;
  }
  return undefined;
}

const STALL_ATTACK = 0.27;

type Crash = Pick<FlightLog, 'cause'> & Partial<Pick<FlightLog, 'part' | 'degrees' | 'sink'>>;

/** @param ground height of the ground where it struck, m */
function causeOf(part: Part, { attack, bank, pitch }: Readonly<Attitude>, sink: number, ground: number): Crash {
  const degrees = (angle: number) => Math.round((Math.abs(angle) * 180) / Math.PI);
  if (sink > DIVE_SINK && attack > STALL_ATTACK) return { cause: 'stalled', degrees: degrees(attack), sink };
  if (sink > DIVE_SINK) return { cause: 'dived', sink };
  if (ground > 5) return { cause: 'hill', part };
  const isWing = part === 'leftWing' || part === 'rightWing';
  return { cause: 'struck', part, degrees: degrees(isWing ? bank : pitch) };
}

function crash(log: FlightLog, why: Crash): void {
  if (log.phase !== 'flying') return;
  log.phase = 'crashed';
  Object.assign(log, why);
  log.score = RING_SCORE * log.ringsFlown;
}

/** A ring counts if the path crosses its plane within its radius; beside it, it is missed. */
function passRings(log: FlightLog, x: number, y: number, z: number): void {
  const ring = RINGS[log.ring];
  if (ring === undefined) return;
  const { at, direction } = ring;
  const ahead = (px: number, pz: number) => (px - at.x) * direction.x + (pz - at.z) * direction.z;
  if (ahead(log.lastX, log.lastZ) >= 0 || ahead(x, z) < 0) return;
  const distance2 = (x - at.x) * (x - at.x) + (y - at.y) * (y - at.y) + (z - at.z) * (z - at.z);
  // Far away, the plane of the ring means nothing.
  if (distance2 > 400 * 400) return;
  if (distance2 < RING_RADIUS * RING_RADIUS) log.ringsFlown++;
  log.ring++;
}

/** Share of the points for a value: all up to `best`, none from `worst`. */
function share(value: number, best: number, worst: number): number {
  return Math.min(1, Math.max(0, (worst - value) / (worst - best)));
}

/** Points for sinking softly, near the centre line, in the first half of the runway; off it there are none. */
export function landingScore(sink: number, x: number, z: number, bounces: number): number {
  if (!isOnRunway(x, z)) return 0;
  const soft = 250 * share(sink, SOFT_SINK, HARD_SINK);
  const straight = 100 * share(Math.abs(z), 2, RUNWAY.width / 2);
  const early = 100 * share(Math.abs(x + RUNWAY.length / 2 - 250), 120, 700);
  return Math.max(0, Math.round(50 + soft + straight + early - 40 * bounces));
}

function land(log: FlightLog, x: number, z: number): void {
  log.phase = 'landed';
  log.isOnRunway = isOnRunway(x, z);
  log.landingScore = log.isOnRunway ? landingScore(log.touchSink, log.touchX, log.touchZ, log.bounces) : 0;
  log.score = RING_SCORE * log.ringsFlown + log.landingScore;
}
