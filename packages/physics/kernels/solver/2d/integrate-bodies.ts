// The motion of bodies within a sub-step of h seconds, semi-implicit Euler, and its result in the columns.
//
//   v += h F/m      ω += h τ/I      then, when contacts and joints have changed both,      x += h v      θ += h ω
import { columns, get, put } from '../../memory/columns';
import { computeSineCosine, sineCosine } from '../../math/elementary';
import { minus, storeReals, vector } from '../../math/vector-2d';
import { BodyState, DYNAMIC, ROUND, flagsOf, poseOf, stateOf, word } from './body';
import { RigidTable } from './rigid-table';
import { sleeperOf } from './sleeper';

// Applies the forces of the last evaluation.
export function integrateVelocities(table: usize): void {
  const t = changetype<RigidTable>(table);
  const h = <real>t.h;
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const pose = poseOf(t, row);
    const state = stateOf(t, row);
    const k = h * pose.inverseMass;
    state.vx += k * get(t.forceX, row);
    state.vy += k * get(t.forceY, row);
    if (pose.inverseInertia > 0 && t.torqueZ != 0) state.w += h * pose.inverseInertia * get(t.torqueZ, row);
  }
}

// The largest angle in a step of a body that touches another and is no disc, rad: corners that turn further than that meet
// surfaces that the contacts of the step know nothing of. Source: Box2D 3 (B2_MAX_ROTATION), for all bodies there.
const MAX_TURN: f64 = 0.7853981633974483;

// @ts-ignore: decorator
@inline function isBounded(t: RigidTable, row: i32): bool {
  return (flagsOf(t, row) & (DYNAMIC | ROUND)) == DYNAMIC && word(t.usedColors, row) != 0;
}

export function integratePositions(table: usize): void {
  const t = changetype<RigidTable>(table);
  const h = <real>t.h;
  const fastest = <real>(MAX_TURN / t.dt);
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const state = stateOf(t, row);
    if (abs<real>(state.w) > fastest && isBounded(t, row)) state.w = state.w > 0 ? fastest : -fastest;
    state.dx += h * state.vx;
    state.dy += h * state.vy;
    if (state.w == 0 && state.turned == 0) continue;
    state.turned += h * state.w;
    turnState(state);
  }
}

// Sets the cosine and sine of the angle that a body has turned by within a step. Below 1/4 rad, 143 rpm at 60 steps a second, Taylor's
// series are exact to 4e-10.
// @ts-ignore: decorator
@inline export function turnState(state: BodyState): void {
  const angle = <f64>state.turned;
  const isFar = abs<f64>(angle) > 0.25;
  storeReals(changetype<usize>(state) + offsetof<BodyState>('dc'), isFar ? exactly(angle) : bySeries(angle));
}

//   cos a = 1 - z (1/2 - z (1/24 - z/720))        sin a = a (1 - z (1/6 - z (1/120 - z/5040)))        z = a²
// @ts-ignore: decorator
@inline function bySeries(angle: f64): v128 {
  const z = f64x2.splat(angle * angle);
  let series = minus(f64x2(1.0 / 24, 1.0 / 120), f64x2.mul(z, f64x2(1.0 / 720, 1.0 / 5040)));
  series = minus(f64x2(0.5, 1.0 / 6), f64x2.mul(z, series));
  series = minus(f64x2.splat(1), f64x2.mul(z, series));
  return f64x2.mul(vector(1, angle), series);
}

function exactly(angle: f64): v128 {
  computeSineCosine(abs<f64>(angle) < 1e6 ? angle : 0);
  return vector(sineCosine.cosine, sineCosine.sine);
}

// Writes poses and velocities to the columns: for laws that read them in the next sub-step, and at the end.
export function writeBodies(table: usize): void {
  const t = changetype<RigidTable>(table);
  const c = columns();
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const pose = poseOf(t, row);
    const state = stateOf(t, row);
    put(c.positionX, row, pose.x + state.dx);
    put(c.positionY, row, pose.y + state.dy);
    if ((flagsOf(t, row) & DYNAMIC) == 0) continue;
    put(c.velocityX, row, state.vx);
    put(c.velocityY, row, state.vy);
    if (pose.inverseInertia > 0) put(c.angularVelocityZ, row, state.w);
  }
}

// The same for angles.
export function writeAngles(table: usize): void {
  const t = changetype<RigidTable>(table);
  const c = columns();
  for (let i = 0; i < t.awakeCount; i++) {
    const row = word(t.awake, i);
    const mayTurn = (<u32>word(c.members, row) & t.turningBits) == t.turningBits;
    if (mayTurn) put(t.angle, row, sleeperOf(t, row).angle + stateOf(t, row).turned);
  }
}
