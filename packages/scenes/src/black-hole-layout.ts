// The layout of holes in the black-hole game. Units are metres; y points up from the bottom of the stage.
// |
// | μ = c² r / 2 so the escape speed √(2 μ / r) at the horizon of every hole is c
// |
// A layout is used only if it has a corridor: a path from the start to the goal that keeps clear of every hole and that
// a ship can fly on its own thrust. Other layouts are drawn again.
import { cos, type Random, sin } from '@principia/physics';
import { findCorridor } from './black-hole-corridor.ts';
import type { Hole } from './black-hole-types.ts';

/** The dimensions and constants of the stage. */
export const BLACK_HOLE = {
  width: 800,
  height: 600,
  /** Initial position of the ship, at rest. */
  start: { x: 400, y: 50 },
  /** Height of the goal line. */
  goal: 550,
  /** Range of heights of the holes' centres. */
  zone: { min: 200, max: 550 },
  /** Fictitious speed of light, m/s. */
  lightSpeed: 200,
  /** Acceleration of the ship at full thrust, m/s². */
  thrust: 10,
  radius: { min: 10, max: 30 },
  /** Largest number of holes of a layout. */
  most: 40,
} as const;

/** Gravitational parameter of a hole with this horizon radius, m³/s². */
export function holeMu(radius: number): number {
  return (BLACK_HOLE.lightSpeed * BLACK_HOLE.lightSpeed * radius) / 2;
}

/** Position of a hole `time` seconds after its layout was drawn; written into `out`, which is returned. */
export function holePosition(hole: Hole, time: number, out: { x: number; y: number }): { x: number; y: number } {
  const angle = hole.phase + hole.rate * time;
  out.x = hole.orbit === 0 ? hole.x : hole.x + hole.orbit * cos(angle);
  out.y = hole.orbit === 0 ? hole.y : hole.y + hole.orbit * sin(angle);
  return out;
}

/** Layouts drawn at full size before holes shrink. */
const FULL_SIZE_ATTEMPTS = 200;

/**
 * Draws layouts until one has a corridor.
 * @param moving number of holes that move on circles
 * @param isSteep uses the Paczyński–Wiita potential
 * @param suits the layout must satisfy this too, as long as holes have their full size
 */
export function drawHoles(
  random: Random,
  count: number,
  moving: number,
  isSteep = false,
  suits: (holes: readonly Hole[]) => boolean = () => true,
): Hole[] {
  let scale = 1;
  for (let tries = 0; ; tries++) {
    const holes = Array.from({ length: count }, (_, i) => drawHole(random, i < moving, scale));
    const isDone = tries >= FULL_SIZE_ATTEMPTS || suits(holes);
    if (isDone && findCorridor(holes, BLACK_HOLE, isSteep) !== undefined) return holes;
    // Holes shrink gradually if many layouts failed, which guarantees termination, since points leave room.
    if (tries >= FULL_SIZE_ATTEMPTS) scale *= 0.95;
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
