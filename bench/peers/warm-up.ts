import type { ParticleColumns } from './particles-columns.ts';

const ROUNDS = 20;
const CALLS = 100;
const MOST_MILLISECONDS = 1000;

/** Bodies on which a step in JavaScript is warmed up. */
const COUNT = 1000;

/**
 * Copies the first bodies of columns, or all of them. A single place creates these objects, so that V8 sees one hidden
 * class.
 */
export function firstBodies(columns: ParticleColumns, most = columns.count): ParticleColumns {
  const { dt, gravity, side, wall, x, y, z, vx, vy, vz, mass, drag, radius } = columns;
  return {
    count: Math.min(most, columns.count),
    dt,
    gravity,
    side,
    wall,
    x: x.slice(0, most),
    y: y.slice(0, most),
    z: z.slice(0, most),
    vx: vx.slice(0, most),
    vy: vy.slice(0, most),
    vz: vz.slice(0, most),
    mass: mass.slice(0, most),
    drag: drag.slice(0, most),
    radius: radius.slice(0, most),
  };
}

/**
 * Lets V8 compile what `step` runs as well as it can: calls it many times, or for a second, with pauses in which the results are
 * taken over.
 */
export async function warmUp(step: () => void, beforeRound: () => void = () => {}): Promise<void> {
  const end = performance.now() + MOST_MILLISECONDS;
  for (let round = 0; round < ROUNDS && performance.now() < end; round++) {
    beforeRound();
    for (let call = 0; call < CALLS && performance.now() < end; call++) step();
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
}

/**
 * Makes a step in plain JavaScript of columns that `firstBodies` made, which V8 has compiled as well as it can. A function whose first calls are
 * long is compiled in the middle of its loop, and often stays with that code, which takes twice as long or more. So it is
 * called for few bodies first.
 */
export async function warmStep(
  columns: ParticleColumns,
  makeStep: (columns: ParticleColumns) => () => void,
): Promise<() => void> {
  const few = firstBodies(columns, COUNT);
  // Every wall is hit from the first call on, because V8 omits code that has not run yet.
  await warmUp(makeStep(few), () => {
    for (const axis of ['x', 'y', 'z'] as const) few[axis].set([-1, columns.side + 1].slice(0, few.count));
  });
  return makeStep(columns);
}
