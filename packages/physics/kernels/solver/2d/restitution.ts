// Bouncing, after the last sub-step: a point that was hit faster than the threshold gets the speed e u away from the surface,
// where u is the speed along the normal before the step. Source: Catto, Solver2D (2024).
import { get, put } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { BodyState, word } from './body';
import * as block from './contact-block';
import { RigidTable } from './rigid-table';

export function applyRestitution(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    for (let l = 0; l < LANES; l++) {
      const restitution = get(at + block.RESTITUTION, l);
      if (restitution == 0) continue;
      for (let p = at + block.POINTS; p < at + block.CONTACT_BLOCK; p += block.POINT) bounce(t, at, p, l, restitution);
    }
  }
}

function bounce(t: RigidTable, at: usize, p: usize, l: i32, restitution: real): void {
  const before = get(p + block.NORMAL_SPEED, l);
  if (before > -(<real>t.restitutionThreshold) || get(p + block.TOTAL_IMPULSE, l) == 0) return;
  const a = changetype<BodyState>(<usize>word(at + block.A, l));
  const b = changetype<BodyState>(<usize>word(at + block.B, l));
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const ax = get(p + block.AX, l);
  const ay = get(p + block.AY, l);
  const bx = get(p + block.BX, l);
  const by = get(p + block.BY, l);
  const vx = b.vx - b.w * by - (a.vx - a.w * ay);
  const vy = b.vy + b.w * bx - (a.vy + a.w * ax);
  const old = get(p + block.NORMAL_IMPULSE, l);
  const wanted = old - get(p + block.NORMAL_MASS, l) * (nx * vx + ny * vy + restitution * before);
  const impulse = wanted > 0 ? min<real>(wanted, block.MAX_IMPULSE) : <real>0;
  put(p + block.NORMAL_IMPULSE, l, impulse);
  const delta = impulse - old;
  put(p + block.TOTAL_IMPULSE, l, get(p + block.TOTAL_IMPULSE, l) + delta);
  a.vx -= get(at + block.MASS_AX, l) * delta * nx;
  a.vy -= get(at + block.MASS_AY, l) * delta * ny;
  a.w -= get(at + block.INERTIA_A, l) * delta * (ax * ny - ay * nx);
  b.vx += get(at + block.MASS_BX, l) * delta * nx;
  b.vy += get(at + block.MASS_BY, l) * delta * ny;
  b.w += get(at + block.INERTIA_B, l) * delta * (bx * ny - by * nx);
}
