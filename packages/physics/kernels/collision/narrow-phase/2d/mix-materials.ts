// The surface of a contact from those of its bodies: the larger restitution and rolling resistance, the geometric mean of
// the coefficients of friction, the sum of the speeds of the surfaces. Source: Box2D 3 (types.h); the first and the third
// are those of contacts between particles, too. Where a collider asks for another rule, the rule of the larger number
// holds. Source of these rules and of their order: PhysX 5 (PxCombineMode).
import { columns, get } from '../../../memory/columns';
import { COMBINES, KINEMATIC, STATIC, WALL, flagsOf, poseOf, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { wallFriction, wallRestitution } from '../../../solver/2d/walls';
import { RigidContact } from './rigid-contact';

export function mixMaterials(t: RigidTable, contact: RigidContact): void {
  const c = columns();
  const a = contact.a;
  const b = contact.b;
  if (((flagsOf(t, a) | flagsOf(t, b)) & (WALL | COMBINES)) != 0) {
    mixByRules(t, contact);
  } else {
    contact.restitution = max<real>(get(c.restitution, a), get(c.restitution, b));
    contact.friction = sqrt<real>(get(c.friction, a) * get(c.friction, b));
  }
  contact.tangentSpeed = get(t.tangentSpeed, a) + get(t.tangentSpeed, b);
  const rolling = max<real>(get(t.rollingResistance, a), get(t.rollingResistance, b));
  contact.rollingResistance = rolling * rollingRadius(t, a, b);
}

function mixByRules(t: RigidTable, contact: RigidContact): void {
  const a = contact.a;
  const b = contact.b;
  const restitutionRule = max<u32>(<u32>word(t.restitutionCombine, a), <u32>word(t.restitutionCombine, b));
  const restitutionA = restitutionOf(t, a);
  const restitutionB = restitutionOf(t, b);
  contact.restitution =
    restitutionRule == 0 ? max<real>(restitutionA, restitutionB) : combine(restitutionRule, restitutionA, restitutionB);
  const frictionRule = max<u32>(<u32>word(t.frictionCombine, a), <u32>word(t.frictionCombine, b));
  let frictionA = frictionOf(t, a);
  let frictionB = frictionOf(t, b);
  // A wall without a coefficient of its own leaves that to the body.
  if (frictionA < 0) frictionA = frictionB;
  if (frictionB < 0) frictionB = frictionA;
  contact.friction =
    frictionRule == 0 ? sqrt<real>(frictionA * frictionB) : combine(frictionRule, frictionA, frictionB);
}

function restitutionOf(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & WALL) != 0 ? wallRestitution(t, row) : get(columns().restitution, row);
}

function frictionOf(t: RigidTable, row: i32): real {
  return (flagsOf(t, row) & WALL) != 0 ? wallFriction(t, row) : get(columns().friction, row);
}

// Rules beside the standard one, by number: components/collider.ts.
const AVERAGE: u32 = 1;
const SMALLER: u32 = 2;
const PRODUCT: u32 = 3;

function combine(rule: u32, a: real, b: real): real {
  if (rule == AVERAGE) return <real>0.5 * (a + b);
  if (rule == SMALLER) return min<real>(a, b);
  return rule == PRODUCT ? a * b : max<real>(a, b);
}

// The resisting torque is a fraction of the normal force times a radius: that of the body that rolls.
// @ts-ignore: decorator
@inline function rollingRadius(t: RigidTable, a: i32, b: i32): real {
  const extentA = (flagsOf(t, a) & (STATIC | KINEMATIC)) != 0 ? <real>Infinity : poseOf(t, a).extent;
  const extentB = (flagsOf(t, b) & (STATIC | KINEMATIC)) != 0 ? <real>Infinity : poseOf(t, b).extent;
  return min<real>(extentA, extentB);
}
