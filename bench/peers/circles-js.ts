// The same collisions as the scene `gas` in plain JavaScript over typed arrays: the same grid, the same order of the
// contacts, the same arithmetic. In f64 it ends in the same bits; in f32 it stores f32 and reckons in f64, as JavaScript
// does. Only what an elastic gas without forces or friction needs is here: it says so when it meets anything else.
import { bodies } from '@principia/physics';
import type { GasRun, SceneRun } from '@principia/scenes';
import { findPairs } from './circles-js/broad-phase';
import { collide } from './circles-js/response';
import { type Gas, gasOf } from './circles-js/state';
import { bounce } from './circles-js/walls';
import type { Peer } from './peer';

export function circlesJs(run: SceneRun): Peer {
  const { ids, count } = bodies(run.world);
  const gas = gasOf(run as GasRun, ids.slice(0, count));
  return {
    name: 'plain JavaScript',
    step() {
      move(gas);
      gas.wall.fill(0);
      bounce(gas, gas.x, gas.vx, gas.startX, 1);
      bounce(gas, gas.y, gas.vy, gas.startY, 3);
      findPairs(gas);
      collide(gas);
    },
    positions: (axis) => gas[axis],
  };
}

/** Velocity Verlet without forces. */
function move({ count, dt, x, y, vx, vy, startX, startY }: Gas): void {
  for (let i = 0; i < count; i++) {
    startX[i] = vx[i];
    startY[i] = vy[i];
    x[i] += vx[i] * dt;
    y[i] += vy[i] * dt;
  }
}
