// Stops the approach of one contact: impulses x >= 0 in all, so that w = K x + b >= 0 and x w = 0, where b are the speeds without
// them. Both points of a contact at once: one after the other would be unequal although they are alike, and a box that
// falls flat would bounce askew. Source: Catto, Iterative Dynamics with Temporal Coherence (GDC 2005); b2SolveContact of Box2D 2.4.
import * as block from '../../solver/2d/contact-block';
import { Impact, ImpactPoint, applyNormalImpulse, excessAt, pointOf } from './impact';

// Two points so close that the determinant of K is less than this part of the product of its diagonal are taken one by one.
const LEAST_DETERMINANT: real = 1e-3;

// Returns by how much it changed the speed of a point, m/s.
export function stop(impact: Impact): real {
  if (impact.held != 0) return 0;
  const p = pointOf(impact, 0);
  if (impact.count < 2) return setImpulse(impact, p, p.impulse + p.mass * excessAt(impact, p));
  const q = pointOf(impact, 1);
  const pp = <real>1 / p.mass;
  const qq = <real>1 / q.mass;
  const pq = impact.coupling;
  const speedP = -excessAt(impact, p) - (pp * p.impulse + pq * q.impulse);
  const speedQ = -excessAt(impact, q) - (pq * p.impulse + qq * q.impulse);
  const determinant = pp * qq - pq * pq;
  if (determinant > LEAST_DETERMINANT * pp * qq) {
    const impulseP = (pq * speedQ - qq * speedP) / determinant;
    const impulseQ = (pq * speedP - pp * speedQ) / determinant;
    if (impulseP >= 0 && impulseQ >= 0) return setImpulses(impact, impulseP, impulseQ);
  }
  const alone = -speedP * p.mass;
  if (alone >= 0 && pq * alone + speedQ >= 0) return setImpulses(impact, alone, 0);
  return setImpulses(impact, 0, -speedQ * q.mass);
}

function setImpulses(impact: Impact, p: real, q: real): real {
  return max<real>(setImpulse(impact, pointOf(impact, 0), p), setImpulse(impact, pointOf(impact, 1), q));
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
