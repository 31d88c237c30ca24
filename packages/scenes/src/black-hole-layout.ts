// Where the holes of a black-hole game lie. Stage units are metres, and y points up from the foot of the stage.
//
//   μ = c² r / 2        so that the escape speed √(2 μ / r) at the rim of every disc is c
//
// A layout is only used if it has a corridor: a way from the start to the goal that keeps clear of every hole and that
// a ship can travel on its own thrust. Layouts without one are drawn again.
import { cos, type Random, sin } from '@principia/physics';
import { findCorridor } from './black-hole-corridor.ts';
import type { Hole } from './black-hole-types.ts';

/** The stage and its laws. */
export const BLACK_HOLE = {
  width: 800,
  height: 600,
  /** Where the ship starts, at rest. */
  start: { x: 400, y: 50 },
  /** Height of the line to cross. */
  goal: 550,
  /** Heights between which the centres of holes lie. */
  zone: { min: 200, max: 550 },
  /** The make-believe speed of light, m/s. */
  lightSpeed: 200,
  /** Acceleration of the ship at full thrust, m/s². */
  thrust: 10,
  radius: { min: 10, max: 30 },
  /** Most holes of a layout. */
  most: 40,
} as const;

/** Gravitational parameter of a hole whose horizon has this radius, m³/s². */
export function holeMu(radius: number): number {
  return (BLACK_HOLE.lightSpeed * BLACK_HOLE.lightSpeed * radius) / 2;
}

/** Where a hole is, `time` seconds after its layout was drawn; written into `out`, which is also returned. */
export function holePlace(hole: Hole, time: number, out: { x: number; y: number }): { x: number; y: number } {
  const angle = hole.phase + hole.rate * time;
  out.x = hole.orbit === 0 ? hole.x : hole.x + hole.orbit * cos(angle);
  out.y = hole.orbit === 0 ? hole.y : hole.y + hole.orbit * sin(angle);
  return out;
}

/** Layouts drawn at full size before holes are made smaller. */
const FULL_SIZE_TRIES = 200;

/**
 * Draws holes until they leave a corridor.
 * @param moving how many of them run on circles
 * @param isSteep the holes pull after Paczyński and Wiita
 */
export function drawHoles(random: Random, count: number, moving: number, isSteep = false): Hole[] {
  let scale = 1;
  for (let tries = 0; ; tries++) {
    const holes = Array.from({ length: count }, (_, i) => drawHole(random, i < moving, scale));
    if (findCorridor(holes, BLACK_HOLE, isSteep) !== undefined) return holes;
    // A crowd that leaves no room in so many tries shrinks, a little at a time: points would always leave room.
    if (tries >= FULL_SIZE_TRIES) scale *= 0.95;
  }
}

function drawHole(random: Random, isMoving: boolean, scale: number): Hole {
  const { width, zone, radius } = BLACK_HOLE;
  const place = { x: random.uniform(0, width), y: random.uniform(zone.min, zone.max) };
  const hole = { ...place, radius: scale * random.uniform(radius.min, radius.max) };
  if (!isMoving) return { ...hole, orbit: 0, rate: 0, phase: 0 };
  const orbit = scale * random.uniform(20, 45);
  const rate = random.sign() * random.uniform(0.25, 0.6);
  return { ...hole, orbit, rate, phase: random.uniform(0, 2 * Math.PI) };
}
