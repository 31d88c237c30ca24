/** Three stars of mass 1 that attract each other with G = 1, and their return to where they started. */
import {
  createPhysicsWorld,
  energy,
  gaussRadau,
  type Integrator,
  mutualGravity,
  type PhysicsWorld,
  rgba,
  spawn,
} from '@principia/physics';
import { COLORS, type Picture, type Point } from '../picture.ts';
import { distanceBetween, positionOf } from './read.ts';

/** Where three stars start, and after which time they are there again. */
export interface PeriodicOrbit {
  readonly places: readonly [Point, Point, Point];
  readonly velocities: readonly [Point, Point, Point];
  /** s */
  readonly period: number;
}

export interface ThreeBodyRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly stars: readonly number[];
  /** Distance of a star from where another one started, m. */
  readonly fromStart: (star: number, other: number) => number;
  /** Largest distance of a star from its own start, m. */
  readonly offStart: () => number;
  readonly startEnergy: number;
}

const PAINTS = [rgba(0.43, 0.72, 1), rgba(1, 0.7, 0.28), rgba(0.37, 0.84, 0.64)];
export const STAR_COLORS = [COLORS.blue, COLORS.orange, COLORS.green] as const;
const STEPS_PER_SECOND = 96;

/** @param nudge added to the first star's x, m */
export function threeBodies(
  { places, velocities, period }: PeriodicOrbit,
  nudge: number,
  integrator: Integrator = gaussRadau(),
): ThreeBodyRun {
  const world = createPhysicsWorld({ capacity: 4, forces: [mutualGravity({ G: 1 })], integrator });
  const stars = places.map(({ x, y }, i) =>
    spawn(world, {
      position: { x: i === 0 ? x + nudge : x, y },
      velocity: velocities[i],
      mass: 1,
      appearance: { size: 0.05, color: PAINTS[i] },
    }),
  );
  const fromStart = (star: number, other: number) => distanceBetween(positionOf(world, stars[star]), places[other]);
  return {
    world,
    // A whole number of steps makes a third of a period.
    dt: period / (3 * Math.round((STEPS_PER_SECOND * period) / 3)),
    stars,
    fromStart,
    offStart: () => Math.max(...stars.map((_, i) => fromStart(i, i))),
    startEnergy: energy(world).total,
  };
}

/** The stars with their paths of one period. */
export function threeBodyPicture({ stars }: ThreeBodyRun, width: number, height: number, period: number): Picture {
  const [x, y] = [width / 2, height / 2];
  return {
    view: { minX: -x, maxX: x, minY: -y, maxY: y },
    fills: [{ shape: { minX: -50 * x, maxX: 50 * x, minY: -50 * y, maxY: 50 * y }, color: 0x05070f }],
    trails: stars.map((body, i) => ({
      body,
      interval: 2,
      length: Math.min(1900, Math.ceil((STEPS_PER_SECOND * period) / 2)),
      color: STAR_COLORS[i],
    })),
  };
}
