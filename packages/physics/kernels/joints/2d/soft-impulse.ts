// Impulses along one direction, from its inverse mass k, 1/kg, its speed and what it has exerted before in this step.
import { RigidTable } from '../../solver/2d/rigid-table';
import { soften, softness } from '../../solver/2d/softness';
import { bounded, finite } from './joint-rows';

// A joint to what joints do not move is softer than rigid by this part, so that what is held from two sides has a solution. A
// straight bridge of a hundred planks needs it: with less, blows of its load make it swing ever more.
export const COMPLIANCE: f64 = 1e-4;

// The frequency of joints is at most this part of the rate of sub-steps. A joint under a load gives way by load/(m ω²); but
// nets of loops, in which each sub-step only improves the impulses, begin to swing from 0.35 on.
const MAX_PART_OF_RATE: f64 = 0.3;

// Sets the softness of locked directions and limits.
export function softenJoint(rigid: RigidTable): void {
  soften(min<f64>(rigid.jointHertz, MAX_PART_OF_RATE / rigid.h), rigid.jointDampingRatio, rigid.h);
  softness.compliance = COMPLIANCE;
}

// What must be added to the impulse of a damped spring; `speed` holds the bias (softness.ts).
// @ts-ignore: decorator
@inline export function softImpulse(k: f64, speed: f64, before: f64): f64 {
  return finite(k > 0 ? (-softness.massScale * speed) / k - softness.impulseScale * before : 0);
}

// What must be added to the impulse of a limit that is `gap` away: it only pushes.
export function limitImpulse(k: f64, speed: f64, gap: f64, before: f64, h: f64, soft: bool): f64 {
  if (!(k > 0)) return 0;
  let impulse = -speed / k;
  if (gap > 0) impulse = -(speed + gap / h) / k;
  else if (soft) impulse = softImpulse(k, speed + softness.biasRate * bounded(gap), before);
  return finite(max<f64>(before + impulse, 0) - before);
}
