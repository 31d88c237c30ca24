/** Bodies among discs that are launched anew, at random, when a flight ends; and how well each flight keeps its energy. */
import { type BodyInput, createRandom, keepState, type PhysicsWorld, type Random, spawn } from '@principia/physics';
import type { ViewBox } from '../picture.ts';
import { distanceBetween, positionOf, speedOf } from './read.ts';

/** A fixed disc whose potential is strength/r, J/kg. */
export interface Disc {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly strength: number;
}

/** Discs at random places of a stage. */
export function drawDiscs(
  random: Random,
  count: number,
  stage: ViewBox,
  radii: readonly [number, number],
  strengthOf: (radius: number) => number,
): Disc[] {
  return Array.from({ length: count }, () => {
    const radius = random.uniform(...radii);
    const x = random.uniform(stage.minX, stage.maxX);
    const y = random.uniform(stage.minY, stage.maxY);
    return { x, y, radius, strength: strengthOf(radius) };
  });
}

export interface FlightOptions {
  readonly seed: number;
  readonly stage: ViewBox;
  readonly discs: readonly Disc[];
  /** Velocities are drawn within this range along each axis, px/s. */
  readonly speed: number;
  /** What every flying body has besides its place and velocity. */
  readonly bodies: readonly BodyInput[];
  /** Bodies fly through the discs, in which no force acts, instead of ending there. */
  readonly passes?: boolean;
  /** A flight is judged until it comes within this many radii of a disc; default 1. */
  readonly clearance?: number;
}

export interface Flights {
  readonly ids: readonly number[];
  /** Largest error of the energy of a flight so far, as a fraction of it or of the kinetic energy. */
  worst(): number;
  /** Number of launches so far. */
  launches(): number;
}

/** Spawns the bodies, and launches each again before the step in which it would start outside or in a disc. */
export function createFlights(world: PhysicsWorld, options: FlightOptions): Flights {
  const { stage, discs, bodies, passes = false, clearance = 1 } = options;
  const random = createRandom(options.seed, 7);
  const ids = bodies.map((body) => spawn(world, { position: {}, velocity: {}, mass: 1, ...body }));
  const starts = new Float64Array(ids.length);
  const isJudged = new Uint8Array(ids.length);
  const total = { worst: 0, launches: 0 };
  keepState(world, random.state, starts, isJudged, total);
  const { Position: p, Velocity: v } = world.components;
  const nearest = (id: number) =>
    discs.reduce((least, disc) => Math.min(least, distanceBetween(positionOf(world, id), disc) / disc.radius), 1e9);
  const isInside = (id: number) =>
    p.x[id] > stage.minX && p.x[id] < stage.maxX && p.y[id] > stage.minY && p.y[id] < stage.maxY;
  const kinetic = (id: number) => (speedOf(world, id) * speedOf(world, id)) / 2;
  const energyOf = (id: number) =>
    discs.reduce(
      (sum, disc) => sum + disc.strength / Math.max(disc.radius, distanceBetween(positionOf(world, id), disc)),
      kinetic(id),
    );
  const launch = (k: number) => {
    const id = ids[k];
    do {
      [p.x[id], p.y[id]] = [random.uniform(stage.minX, stage.maxX), random.uniform(stage.minY, stage.maxY)];
    } while (nearest(id) <= clearance + 0.2);
    [v.x[id], v.y[id]] = [random.uniform(-1, 1) * options.speed, random.uniform(-1, 1) * options.speed];
    starts[k] = energyOf(id);
    isJudged[k] = 1;
    total.launches++;
    world.versions.pose++;
  };
  const watch = (k: number) => {
    const id = ids[k];
    const distance = nearest(id);
    if (!isInside(id) || (distance <= 1 && !passes)) {
      launch(k);
    } else if (distance <= clearance) {
      isJudged[k] = 0;
    } else if (isJudged[k] === 1) {
      const scale = Math.max(Math.abs(starts[k]), kinetic(id));
      // What rests without a force has no energy, and no error of it.
      if (scale > 0) total.worst = Math.max(total.worst, Math.abs(energyOf(id) - starts[k]) / scale);
    }
  };
  for (let k = 0; k < ids.length; k++) launch(k);
  world.phases.input.push(() => {
    for (let k = 0; k < ids.length; k++) watch(k);
  });
  return { ids, worst: () => total.worst, launches: () => total.launches };
}
