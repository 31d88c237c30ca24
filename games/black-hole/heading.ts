import { BLACK_HOLE } from '@principia/scenes';

/** One of the four directions of the screen. */
export type Heading = 'up' | 'left' | 'down' | 'right';

/** Thrust as a fraction of full thrust, x and y, y up: at most 1 long. */
export interface Push {
  readonly x: number;
  readonly y: number;
}

/** Full thrust in the four directions. */
export const DIRECTIONS: Readonly<Record<Heading, Push>> = {
  up: { x: 0, y: 1 },
  left: { x: -1, y: 0 },
  down: { x: 0, y: -1 },
  right: { x: 1, y: 0 },
};

/** Steps per unit of an analogue push: fine enough to aim, and coarse enough that a resting pointer logs few inputs. */
const STEPS = 20;

/** The push of a stick or pointer, rounded so that a log reproduces it; undefined where it is zero. */
export function pushOf(x: number, y: number): Push | undefined {
  const shrink = 1 / Math.max(1, Math.hypot(x, y));
  // `|| 0` turns −0 into 0.
  const round = (value: number) => (Math.sign(value) * Math.round(Math.abs(value) * shrink * STEPS)) / STEPS || 0;
  const push = { x: round(x), y: round(y) };
  return push.x === 0 && push.y === 0 ? undefined : push;
}

/** The direction of the screen that is nearest to a push; empty without one. */
export function headingOf(push: Push | undefined): Heading | '' {
  if (push === undefined) return '';
  if (Math.abs(push.x) > Math.abs(push.y)) return push.x > 0 ? 'right' : 'left';
  return push.y > 0 ? 'up' : 'down';
}

/** Acceleration of a push or heading, m/s², written into `out`, which is returned; zero for undefined. */
export function thrustOf(push: Push | undefined, out: { x: number; y: number }): { x: number; y: number } {
  out.x = push === undefined ? 0 : BLACK_HOLE.thrust * push.x;
  out.y = push === undefined ? 0 : BLACK_HOLE.thrust * push.y;
  return out;
}
