// The same collisions as the scenes `circles` and `gas` in plain JavaScript over typed arrays: the same grid, the same
// order of the contacts, the same sweeps, the same arithmetic. In f64 it ends in the same bits; in f32 it stores f32 and
// reckons in f64, as JavaScript does. Only what these scenes need is here: bodies that do not spin, and the box.
import { bodies, velocityVerlet } from '@principia/physics';
import type { BoxedRun, SceneRun } from '@principia/scenes';
import { findPairs } from './circles-js/broad-phase.ts';
import { respond } from './circles-js/response.ts';
import { type Balls, ballsOf } from './circles-js/state.ts';
import { meetWalls } from './circles-js/walls.ts';
import type { Peer } from './peer.ts';

/** None for bodies with friction or another integrator. */
export function circlesJs(run: SceneRun): Peer | undefined {
  const boxed = run as BoxedRun;
  if (boxed.friction > 0 || run.world.integrator.name !== velocityVerlet.name) return undefined;
  const { ids, count } = bodies(run.world);
  const balls = ballsOf(boxed, ids.slice(0, count));
  return {
    name: 'plain JavaScript',
    step() {
      move(balls);
      meetWalls(balls);
      findPairs(balls);
      respond(balls);
    },
    positions: (axis) => balls[axis],
  };
}

/** Velocity Verlet under gravity along y. */
function move({ count, flat, dt, x, y, z, vx, vy, vz, startX, startY, startZ, fall }: Balls): void {
  const half = 0.5 * dt;
  for (let i = 0; i < count; i++) {
    const kick = fall[i] * half;
    startX[i] = vx[i];
    startY[i] = vy[i];
    x[i] += vx[i] * dt;
    const kicked = vy[i] + kick;
    y[i] += kicked * dt;
    vy[i] = kicked + kick;
    if (flat) continue;
    startZ[i] = vz[i];
    z[i] += vz[i] * dt;
  }
}
