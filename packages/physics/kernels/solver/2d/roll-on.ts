// A disc that rolls or slides along something that does not move and meets what follows there, in the same step: the segments of a
// curved rail are shorter than the way of a fast ball. It is deflected where it meets each, as by an impact, and goes on for the rest
// of the step.
//
//   v += J n / m      J = -(1 + e) m v·n      e = 0 for slow impacts; friction: at most μ J, until the surface is at rest
//
// Without that it would be stopped at each segment, and the rest of the step would be lost.
import { AFTER, BEFORE, END, START, isChainSegment, turnAt } from '../../collision/narrow-phase/2d/chain-segment';
import { RigidContact } from '../../collision/narrow-phase/2d/rigid-contact';
import { mixMaterials } from '../../collision/narrow-phase/2d/mix-materials';
import { BodyState, poseOf, stateOf } from './body';
import { findImpact, impact, spareA } from './first-impact';
import { turnState } from './integrate-bodies';
import { RigidTable } from './rigid-table';
import { startLeg } from './sweep-shapes';
import { shapeAt } from './walls';

// Deflections of a body in a step, at most.
const MOST_LEGS: i32 = 32;

const contact = changetype<RigidContact>(memory.data(offsetof<RigidContact>(), 16));

// Goes on from an impact at a fraction of the step. Returns the fraction at which the body is stopped, 1 if it never is.
export function rollOn(t: RigidTable, row: i32, first: real): real {
  const state = stateOf(t, row);
  const turned = state.turned;
  let time: real = first;
  let part: real = first;
  let x: real = 0;
  let y: real = 0;
  for (let leg = 0; time < 1; leg++) {
    x += part * (state.dx - x);
    y += part * (state.dy - y);
    state.dx = x;
    state.dy = y;
    if (leg == MOST_LEGS || !deflect(t, row, state)) break;
    const left = (<real>1 - time) * <real>t.dt;
    state.dx += left * state.vx;
    state.dy += left * state.vy;
    startLeg(x, y);
    part = findImpact(t, row, -1);
    time += part * (<real>1 - time);
    if (part == 1) time = 1;
  }
  startLeg(0, 0);
  state.turned = time * turned;
  turnState(state);
  return time;
}

// A disc that meets only every few segments of a chain is deflected by several of their angles at once. It loses speed as if it had
// met each: not by the cosine of the whole angle α, but by that of the angle β between two segments, α/β times. Returns the factor
// between both, by their series; `sine` is that of α.
//
//   cos(β)^(α/β) / cos α = (1 - α β / 2 + ...) / cos α
function keptOf(t: RigidTable, sine: real): real {
  const shape = shapeAt(t, impact.other, spareA);
  if (!isChainSegment(shape)) return 1;
  const bend = max<real>(abs<real>(turnAt(shape, BEFORE, START, END)), abs<real>(turnAt(shape, START, END, AFTER)));
  if (sine <= bend) return 1;
  return (<real>1 - <real>0.5 * sine * bend) / sqrt<real>(<real>1 - sine * sine);
}

// Whether the body goes on: what meets a surface at more than 45 degrees is left to the contact of the next step.
function deflect(t: RigidTable, row: i32, state: BodyState): bool {
  const nx = impact.nx;
  const ny = impact.ny;
  const into = state.vx * nx + state.vy * ny;
  if (into >= 0) return true;
  if (<real>2 * into * into > state.vx * state.vx + state.vy * state.vy) return false;
  contact.a = row;
  contact.b = impact.other;
  mixMaterials(t, contact);
  const bounce = -into > <real>t.restitutionThreshold ? contact.restitution : <real>0;
  const pose = poseOf(t, row);
  const change = -(<real>1 + bounce) * into;
  const kept = bounce == 0 ? keptOf(t, -into / sqrt<real>(state.vx * state.vx + state.vy * state.vy)) : <real>1;
  state.vx = kept * (state.vx + change * nx);
  state.vy = kept * (state.vy + change * ny);
  if (contact.friction == 0 || contact.tangentSpeed != 0) return true;
  // Along (-ny, nx), at the surface; by how much an impulse that changes the velocity of the body by 1 changes that.
  const along = state.vy * nx - state.vx * ny - state.w * pose.extent;
  const yields = <real>1 + (pose.extent * pose.extent * pose.inverseInertia) / pose.inverseMass;
  const limit = contact.friction * change;
  const friction = max<real>(-limit, min<real>(limit, -along / yields));
  state.vx -= friction * ny;
  state.vy += friction * nx;
  state.w -= (friction * pose.extent * pose.inverseInertia) / pose.inverseMass;
  return true;
}
