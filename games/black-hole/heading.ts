import { BLACK_HOLE } from '@principia/scenes';

/** The direction of thrust: one of the four directions of the screen. */
export type Heading = 'up' | 'left' | 'down' | 'right';

/** Unit vectors, y up. */
export const DIRECTIONS: Readonly<Record<Heading, { readonly x: number; readonly y: number }>> = {
  up: { x: 0, y: 1 },
  left: { x: -1, y: 0 },
  down: { x: 0, y: -1 },
  right: { x: 1, y: 0 },
};

/** Acceleration for a heading, m/s²; zero for undefined. */
export function thrustOf(heading: Heading | undefined): { readonly x: number; readonly y: number } {
  return heading === undefined ? REST : THRUST[heading];
}

const REST = { x: 0, y: 0 };
const THRUST = Object.fromEntries(
  Object.entries(DIRECTIONS).map(([name, { x, y }]) => [name, { x: BLACK_HOLE.thrust * x, y: BLACK_HOLE.thrust * y }]),
) as Record<Heading, { x: number; y: number }>;
