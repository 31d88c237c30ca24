/** The submarine of the book: its numbers, its ballast tank and its picture, in pixels with y down. */
import { cos, keepState, type PhysicsWorld, sin } from '@principia/physics';
import { COLORS, type Fill, type Line, type Picture, type Point, pointsOf } from '../picture.ts';
import { positionOf, velocityOf } from './read.ts';

export const SEA = { gravity: 10, density: 1, level: 200 } as const;
/** Volume; empty mass, kg; quadratic drag of the whole hull, kg/px; force of the propeller, N; sizes, px. */
export const SUBMARINE = { volume: 1, emptyMass: 0.5, drag: 0.05, thrust: 20, width: 160, halfHeight: 30 } as const;
/** Change of the water in the tank while a key is held, 1/s: 0.01 a frame. */
export const FILL_RATE = 0.6;
const TANK = { width: 80, height: 30 } as const;

/** Mass with a fraction of the tank filled; full, the water weighs 1 kg. */
export const massOf = (fill: number): number => SUBMARINE.emptyMass + fill;

/** Height of the water in the tank, px. */
export const waterHeight = (fill: number): number => TANK.height * fill;

/** The hull: two straight sides and round ends. */
const HULL: readonly Point[] = [-1, 1].flatMap((side) =>
  pointsOf(
    (angle) => ({
      x: side * (SUBMARINE.width / 2 - SUBMARINE.halfHeight + SUBMARINE.halfHeight * cos(angle)),
      y: side * SUBMARINE.halfHeight * sin(angle),
    }),
    -Math.PI / 2,
    Math.PI / 2,
    12,
  ),
);

export interface SubmarineRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly sub: number;
  readonly bob: number;
  readonly dive: number;
  readonly rise: number;
  readonly run: number;
  /** Fraction of the tank that is filled, and its change, 1/s. */
  readonly state: { fill: number; change: number };
}

/** Fills or empties the tank of a submarine before each step. */
export function tank(world: PhysicsWorld, sub: number, state: SubmarineRun['state']): void {
  keepState(world, state);
  world.phases.input.push((_, dt) => {
    if (state.change === 0) return;
    state.fill = Math.min(1, Math.max(0, state.fill + state.change * dt));
    world.components.Mass.value[sub] = massOf(state.fill);
  });
}

/** Sky, sea, and the submarine with its tower, portholes and the water in its tank. */
export function subPicture({ world, sub, state }: SubmarineRun): Picture {
  const at = (x: number, y: number | (() => number)) => () => {
    const place = positionOf(world, sub);
    return { x: place.x + x, y: place.y + (typeof y === 'number' ? y : y()) };
  };
  const line = (
    x: number,
    y: number | (() => number),
    toX: number,
    toY: number | (() => number),
    color: number,
  ): Line => ({
    from: at(x, y),
    to: at(toX, toY),
    width: 3,
    color,
  });
  const { width, height } = TANK;
  const [right, top] = [width / 2, -height / 2 + 6];
  const bottom = top + height;
  const surface = () => bottom - waterHeight(state.fill);
  const portholes: Fill[] = [-60, -36, -12, 12, 36, 60].map((x) => ({
    shape: { centre: at(x, -18), radius: 5 },
    color: COLORS.white,
  }));
  return {
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
    fills: [
      ...portholes,
      {
        shape: { minX: -2e4, maxX: 2e4, minY: SEA.level, maxY: 2e4 },
        color: COLORS.water,
        opacity: 0.4,
        inFront: true,
      },
    ],
    lines: [
      ...HULL.map((from, i) => {
        const to = HULL[(i + 1) % HULL.length];
        return line(from.x, from.y, to.x, to.y, COLORS.blue);
      }),
      line(-14, -SUBMARINE.halfHeight, -14, -52, COLORS.blue),
      line(-14, -52, 14, -52, COLORS.blue),
      line(14, -52, 14, -SUBMARINE.halfHeight, COLORS.blue),
      line(-right, top, right, top, COLORS.white),
      line(right, top, right, bottom, COLORS.white),
      line(right, bottom, -right, bottom, COLORS.white),
      line(-right, bottom, -right, top, COLORS.white),
      line(-right + 2, surface, right - 2, surface, COLORS.yellow),
    ],
    arrows: [{ label: 'v', from: at(0, 0), vector: () => velocityOf(world, sub), scale: 1.5, color: COLORS.green }],
    labels: [
      { at: at(96, -8), text: () => `density ${massOf(state.fill).toFixed(2)} × that of water` },
      { at: at(96, 12), text: () => `tank ${(100 * state.fill).toFixed(0)} %` },
    ],
    trails: [{ body: sub, length: 400, interval: 4 }],
  };
}
