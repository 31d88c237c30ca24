// Stops the approach of one contact: impulses x >= 0 in all, so that w = K x + b >= 0 and x w = 0, where b are the speeds without
// them. Both points of a contact at once: one after the other would be unequal although they are alike, and a box that
// falls flat would bounce askew. The points of a pair of contacts likewise. Source: Catto, Iterative Dynamics with Temporal
// Coherence (GDC 2005); b2SolveContact of Box2D 2.4.
import * as block from '../../solver/2d/contact-block';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, ImpactPoint, applyNormalImpulse, excessAt, impactAt, pointOf } from './impact';
import { couplingBetween } from './paired-impacts';

// Two points so close that the determinant of K is less than this part of the product of its diagonal are taken one by one.
const LEAST_DETERMINANT: real = 1e-3;

// What `solvePair` found last.
export let pairP: real = 0;
export let pairQ: real = 0;

// Finds the impulses at two points that change their speeds by `changeP` and `changeQ` together, where K has the numbers pp, pq and qq.
// Returns whether neither has to pull, and the points are far enough from each other.
export function solvePair(pp: real, pq: real, qq: real, changeP: real, changeQ: real): bool {
  const determinant = pp * qq - pq * pq;
  if (!(determinant > LEAST_DETERMINANT * pp * qq)) return false;
  pairP = (qq * changeP - pq * changeQ) / determinant;
  pairQ = (pp * changeQ - pq * changeP) / determinant;
  return pairP >= 0 && pairQ >= 0;
}

// Returns by how much it changed the speed of a point, m/s.
export function stop(t: RigidTable, impact: Impact): real {
  if (impact.held != 0) return 0;
  const p = pointOf(impact, 0);
  if (impact.count > 1) return stopBoth(impact, p, impact, pointOf(impact, 1), impact.coupling);
  if (impact.partner == 0) return setImpulse(impact, p, p.impulse + p.mass * excessAt(impact, p));
  const other = impactAt(t, impact.partner - 1);
  return stopBoth(impact, p, other, pointOf(other, 0), couplingBetween(impact, other));
}

// Two points, whose impulses give each other `pq` as much speed.
function stopBoth(impact: Impact, p: ImpactPoint, other: Impact, q: ImpactPoint, pq: real): real {
  const pp = <real>1 / p.mass;
  const qq = <real>1 / q.mass;
  const speedP = -excessAt(impact, p) - (pp * p.impulse + pq * q.impulse);
  const speedQ = -excessAt(other, q) - (pq * p.impulse + qq * q.impulse);
  let impulseP = -speedP * p.mass;
  let impulseQ: real = 0;
  if (!(impulseP >= 0 && pq * impulseP + speedQ >= 0)) {
    impulseP = 0;
    impulseQ = -speedQ * q.mass;
  }
  if (solvePair(pp, pq, qq, -speedP, -speedQ)) {
    impulseP = pairP;
    impulseQ = pairQ;
  }
  return max<real>(setImpulse(impact, p, impulseP), setImpulse(other, q, impulseQ));
}

// What is not a number becomes 0.
function setImpulse(impact: Impact, point: ImpactPoint, wanted: real): real {
  const impulse = wanted > 0 ? min<real>(wanted, block.MAX_IMPULSE) : <real>0;
  const delta = impulse - point.impulse;
  point.impulse = impulse;
  point.given += delta;
  applyNormalImpulse(impact, point, delta);
  return abs<real>(delta) / point.mass;
}
