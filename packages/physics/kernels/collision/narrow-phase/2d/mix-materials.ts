// The surface of a contact from those of its bodies: the larger restitution and rolling resistance, the geometric mean of
// the coefficients of friction, the sum of the speeds of the surfaces. Source: Box2D 3 (types.h); the first and the third
// are those of contacts between particles, too.
import { columns, get } from '../../../memory/columns';
import { KINEMATIC, STATIC, flagsOf, poseOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { RigidContact } from './rigid-contact';

export function mixMaterials(t: RigidTable, contact: RigidContact): void {
  const c = columns();
  const a = contact.a;
  const b = contact.b;
  contact.restitution = max<real>(get(c.restitution, a), get(c.restitution, b));
  contact.friction = sqrt<real>(get(c.friction, a) * get(c.friction, b));
  contact.tangentSpeed = get(t.tangentSpeed, a) + get(t.tangentSpeed, b);
  const rolling = max<real>(get(t.rollingResistance, a), get(t.rollingResistance, b));
  contact.rollingResistance = rolling * rollingRadius(t, a, b);
}

// The resisting torque is a fraction of the normal force times a radius: that of the body that rolls.
// @ts-ignore: decorator
@inline function rollingRadius(t: RigidTable, a: i32, b: i32): real {
  const extentA = (flagsOf(t, a) & (STATIC | KINEMATIC)) != 0 ? <real>Infinity : poseOf(t, a).extent;
  const extentB = (flagsOf(t, b) & (STATIC | KINEMATIC)) != 0 ? <real>Infinity : poseOf(t, b).extent;
  return min<real>(extentA, extentB);
}
