// All pairs in plain JavaScript, in double loops over typed arrays of f64: the plainest, in which each body looks at all
// others, and one that meets each pair once, with half the roots and divisions.
import type { SceneRun } from '@principia/scenes';
import { kick, kickDrift, type NBodyState, nBodyState } from './n-body-columns.ts';
import type { Peer } from './peer.ts';

export function nBodyJs(run: SceneRun): Peer {
  return stepped(run, 'plain JavaScript, f64, every body all others', lookAtAll2d, lookAtAll3d);
}

export function nBodyPairsJs(run: SceneRun): Peer {
  return stepped(run, 'plain JavaScript, f64, each pair once', pull2d, pull3d);
}

type Pull = (state: NBodyState) => void;

function stepped(run: SceneRun, name: string, inPlane: Pull, inSpace: Pull): Peer {
  const state = nBodyState(run);
  const pull = state.dimensions === 2 ? inPlane : inSpace;
  pull(state);
  return {
    name,
    step() {
      kickDrift(state);
      pull(state);
      kick(state);
    },
    positions: (axis) => state.x[axis],
  };
}

function lookAtAll3d({ count, G, softening, x: { x, y, z }, mass, a }: NBodyState): void {
  const soft = softening * softening;
  for (let i = 0; i < count; i++) {
    const [px, py, pz] = [x[i], y[i], z[i]];
    let sx = 0;
    let sy = 0;
    let sz = 0;
    for (let j = 0; j < count; j++) {
      if (j === i) continue;
      const dx = x[j] - px;
      const dy = y[j] - py;
      const dz = z[j] - pz;
      const u = dx * dx + dy * dy + dz * dz + soft;
      const k = (G * mass[j]) / (u * Math.sqrt(u));
      sx += k * dx;
      sy += k * dy;
      sz += k * dz;
    }
    a.x[i] = sx;
    a.y[i] = sy;
    a.z[i] = sz;
  }
}

function lookAtAll2d({ count, G, softening, x: { x, y }, mass, a }: NBodyState): void {
  const soft = softening * softening;
  for (let i = 0; i < count; i++) {
    const [px, py] = [x[i], y[i]];
    let sx = 0;
    let sy = 0;
    for (let j = 0; j < count; j++) {
      if (j === i) continue;
      const dx = x[j] - px;
      const dy = y[j] - py;
      const u = dx * dx + dy * dy + soft;
      const k = (G * mass[j]) / (u * Math.sqrt(u));
      sx += k * dx;
      sy += k * dy;
    }
    a.x[i] = sx;
    a.y[i] = sy;
  }
}

function pull3d({ count, G, softening, x: { x, y, z }, mass, a }: NBodyState): void {
  const { x: ax, y: ay, z: az } = a;
  const soft = softening * softening;
  ax.fill(0);
  ay.fill(0);
  az.fill(0);
  for (let i = 0; i < count; i++) {
    const [px, py, pz, m] = [x[i], y[i], z[i], G * mass[i]];
    let sx = 0;
    let sy = 0;
    let sz = 0;
    for (let j = i + 1; j < count; j++) {
      const dx = x[j] - px;
      const dy = y[j] - py;
      const dz = z[j] - pz;
      const u = dx * dx + dy * dy + dz * dz + soft;
      const k = 1 / (u * Math.sqrt(u));
      const own = G * mass[j] * k;
      const theirs = m * k;
      sx += own * dx;
      sy += own * dy;
      sz += own * dz;
      ax[j] -= theirs * dx;
      ay[j] -= theirs * dy;
      az[j] -= theirs * dz;
    }
    ax[i] += sx;
    ay[i] += sy;
    az[i] += sz;
  }
}

function pull2d({ count, G, softening, x: { x, y }, mass, a }: NBodyState): void {
  const { x: ax, y: ay } = a;
  const soft = softening * softening;
  ax.fill(0);
  ay.fill(0);
  for (let i = 0; i < count; i++) {
    const [px, py, m] = [x[i], y[i], G * mass[i]];
    let sx = 0;
    let sy = 0;
    for (let j = i + 1; j < count; j++) {
      const dx = x[j] - px;
      const dy = y[j] - py;
      const u = dx * dx + dy * dy + soft;
      const k = 1 / (u * Math.sqrt(u));
      const own = G * mass[j] * k;
      const theirs = m * k;
      sx += own * dx;
      sy += own * dy;
      ax[j] -= theirs * dx;
      ay[j] -= theirs * dy;
    }
    ax[i] += sx;
    ay[i] += sy;
  }
}
