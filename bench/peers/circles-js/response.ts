import { resolveImpacts } from './impacts.ts';
import { holdResting } from './rest.ts';
import { separate } from './separate.ts';
import type { Balls } from './state.ts';
import { linkWalls } from './walls.ts';

/** Answers the contacts of a step, and keeps those that touched for the next. */
export function respond(balls: Balls): void {
  joinPrevious(balls);
  if (balls.contacts > 0) {
    readAccelerations(balls);
    linkWalls(balls);
    resolveImpacts(balls);
    holdResting(balls);
    separate(balls);
  }
  keepTouching(balls);
}

/** What held a contact in the last step; both lists ascend. Notes which bodies have contacts. */
function joinPrevious(balls: Balls): void {
  const { contacts, a, b, holding, impulse, previous, previousA, previousB, previousHolding, met } = balls;
  met.fill(0);
  let p = 0;
  for (let i = 0; i < contacts; i++) {
    met[a[i]] = 1;
    met[b[i]] = 1;
    while (p < previous && (previousA[p] < a[i] || (previousA[p] === a[i] && previousB[p] < b[i]))) p++;
    const same = p < previous && previousA[p] === a[i] && previousB[p] === b[i];
    holding[i] = same ? previousHolding[p] : 0;
    impulse[i] = 0;
  }
}

/** Walls move the start velocity along; what is left of the difference is the acceleration. */
function readAccelerations(balls: Balls): void {
  const { count, flat, dt, vx, vy, vz, startX, startY, startZ, ax, ay, az } = balls;
  const rate = 1 / dt;
  for (let i = 0; i < count; i++) {
    ax[i] = (vx[i] - startX[i]) * rate;
    ay[i] = (vy[i] - startY[i]) * rate;
    if (!flat) az[i] = (vz[i] - startZ[i]) * rate;
  }
}

function keepTouching(balls: Balls): void {
  const { contacts, flat, a, b, x, y, z, radius, impulse, holding, previousA, previousB, previousHolding } = balls;
  let kept = 0;
  for (let i = 0; i < contacts; i++) {
    const [p, q] = [a[i], b[i]];
    const dx = x[q] - x[p];
    const dy = y[q] - y[p];
    const dz = flat ? 0 : z[q] - z[p];
    const overlap = radius[p] + radius[q] - Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (!(impulse[i] > 0 || overlap > 0)) continue;
    previousA[kept] = p;
    previousB[kept] = q;
    previousHolding[kept++] = holding[i];
  }
  balls.previous = kept;
}
