// A contact that an impact reached, apart from the blocks: what the rounds of impacts need of it, in one place.
import { BodyState } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';

@unmanaged
export class Impact {
  // Addresses of the states of both bodies (class BodyState), and their rows, 0 where contacts do not push the body.
  stateA: usize;
  stateB: usize;
  rowA: i32;
  rowB: i32;
  // The trees of joints with which both bodies bounce, -1 for none, and the row of the first body of each, or that of the body.
  treeA: i32;
  treeB: i32;
  groupA: i32;
  groupB: i32;
  // The contact (contact-place.ts), whether it is in the list of those that approach, and its points.
  place: i32;
  listed: i32;
  count: i32;
  // Whether joints and their limits keep its points from moving, and whether these are as they were when it was found out.
  held: i32;
  isWeighed: i32;
  // One more than the index of another impact of the same body that is stopped with this one, 0 for none (paired-impacts.ts).
  partner: i32;
  nx: real;
  ny: real;
  // Inverse masses and moments of inertia.
  massAx: real;
  massAy: real;
  inertiaA: real;
  massBx: real;
  massBy: real;
  inertiaB: real;
  restitution: real;
  friction: real;
  tangentSpeed: real;
  // The speed that an impulse of 1 N s at one of two points gives the other, along the normal, 1/kg.
  coupling: real;
  // The speed at which it approaches, m/s.
  approach: real;
  // Two points, class ImpactPoint: each has this many reals.
  point0: real;
}

// Levers and effective masses as in a block; the impulses of this round and of all rounds, and those of friction of all rounds and
// before this one, N s; what was taken back along the normal; the speed at which it may close, m/s; its effective mass without
// joints; and the speed at which it met, m/s.
@unmanaged
export class ImpactPoint {
  leverA: real;
  leverB: real;
  mass: real;
  tangentLeverA: real;
  tangentLeverB: real;
  tangentMass: real;
  impulse: real;
  given: real;
  tangentImpulse: real;
  tangentBefore: real;
  taken: real;
  room: real;
  ownMass: real;
  met: real;
}

const POINT: usize = 14 * sizeof<real>();

// @ts-ignore: decorator
@inline export const IMPACT_SIZE: usize = (offsetof<Impact>('point0') + 2 * POINT + 7) & ~7;

// @ts-ignore: decorator
@inline export function impactAt(t: RigidTable, i: i32): Impact {
  return changetype<Impact>(t.impacts + <usize>i * IMPACT_SIZE);
}

// @ts-ignore: decorator
@inline export function pointOf(impact: Impact, i: i32): ImpactPoint {
  return changetype<ImpactPoint>(changetype<usize>(impact) + offsetof<Impact>('point0') + <usize>i * POINT);
}

// The speed of b from a along the normal at a point, m/s.
export function normalSpeedAt(impact: Impact, point: ImpactPoint): real {
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  return impact.nx * (b.vx - a.vx) + impact.ny * (b.vy - a.vy) + (b.w * point.leverB - a.w * point.leverA);
}

// How fast a point approaches beyond what it may, m/s.
// @ts-ignore: decorator
@inline export function excessAt(impact: Impact, point: ImpactPoint): real {
  return -(normalSpeedAt(impact, point) + point.room);
}

// Pushes the bodies apart at a point with an impulse along the normal, N s.
export function applyNormalImpulse(impact: Impact, point: ImpactPoint, impulse: real): void {
  applyImpulse(impact, impulse * impact.nx, impulse * impact.ny, impulse * point.leverA, impulse * point.leverB);
}

// The speed of b from a along the tangent (n_y, -n_x) at a point, less that of the surfaces, m/s.
export function tangentSpeedAt(impact: Impact, point: ImpactPoint): real {
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  const turning = b.w * point.tangentLeverB - a.w * point.tangentLeverA;
  return impact.ny * (b.vx - a.vx) - impact.nx * (b.vy - a.vy) + turning - impact.tangentSpeed;
}

// The same along the tangent as `applyNormalImpulse`.
export function applyTangentImpulse(impact: Impact, point: ImpactPoint, impulse: real): void {
  applyImpulse(
    impact,
    impulse * impact.ny,
    -impulse * impact.nx,
    impulse * point.tangentLeverA,
    impulse * point.tangentLeverB,
  );
}

// An impulse (x, y) on b, the opposite one on a, and their moments about the centres of both.
function applyImpulse(impact: Impact, x: real, y: real, turnA: real, turnB: real): void {
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  a.vx -= impact.massAx * x;
  a.vy -= impact.massAy * y;
  a.w -= impact.inertiaA * turnA;
  b.vx += impact.massBx * x;
  b.vy += impact.massBy * y;
  b.w += impact.inertiaB * turnB;
}

// The speed that an impulse of 1 N s at one of two points gives the other, 1/kg.
export function setCoupling(impact: Impact): void {
  const p = pointOf(impact, 0);
  const q = pointOf(impact, 1);
  const x = (impact.massAx + impact.massBx) * impact.nx * impact.nx;
  const y = (impact.massAy + impact.massBy) * impact.ny * impact.ny;
  const turning = impact.inertiaA * p.leverA * q.leverA + impact.inertiaB * p.leverB * q.leverB;
  impact.coupling = impact.count > 1 ? x + y + turning : <real>0;
}
