// Motor joints: they drive b to a pose in the frame of a, with a limited force and a limited torque. With a frequency they
// are damped springs, solved implicitly (softness.ts); without one they stop b against a, as friction does on a floor that
// is seen from above, and turn it at the motor's speed. What a pointer drags hangs from a motor joint to the world.
// Source: Box2D 3.2 (motor_joint.c).
import { get } from '../../memory/columns';
import { BodyState } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { soften, softness } from '../../solver/2d/softness';
import { JointImpulses, JointTable } from './joint-table';
import { JointWork, rowOf } from './joint-work';
import { mostAlone } from './spring-softness';
import { applyAlong, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';

// The row of the angle, after those of x and y.
const ANGLE: i32 = 2;

export function solveMotorJoint(t: JointTable, work: JointWork, impulses: JointImpulses, rigid: RigidTable): void {
  const id = work.id;
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const hertz = <f64>get(t.hertz, id);
  if (hertz > 0) soften(min<f64>(hertz, mostAlone(work) / rigid.h), <f64>get(t.dampingRatio, id), rigid.h);
  else stop();
  turnTo(work, a, b, impulses, hertz > 0 ? 0 : <f64>get(t.motorSpeed, id), <f64>get(t.maxMotor, id) * rigid.h);
  pullTo(work, a, b, impulses, <f64>get(t.maxForce, id) * rigid.h);
}

// Without a spring the whole speed is taken away.
function stop(): void {
  softness.biasRate = 0;
  softness.massScale = 1;
  softness.impulseScale = 0;
}

function turnTo(work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, speed: f64, most: f64): void {
  const row = rowOf(work, ANGLE);
  const k = coupling(work, row, row);
  if (!(k > 0)) return;
  const wanted = speedAlong(a, b, row) - speed + softness.biasRate * row.error;
  const sum = to.lock2 - (softness.massScale * wanted) / k - softness.impulseScale * to.lock2;
  const impulse = finite(min<f64>(most, max<f64>(-most, sum)) - to.lock2);
  to.lock2 += impulse;
  applyAlong(work, a, b, row, impulse);
}

// A matrix whose determinant is smaller, in parts of the square of its trace, has rank 1 but for rounding.
const SINGULAR: f64 = 1e-12;

// Both directions at once, so that the force is limited by its length.
function pullTo(work: JointWork, a: BodyState, b: BodyState, to: JointImpulses, most: f64): void {
  const x = rowOf(work, 0);
  const y = rowOf(work, 1);
  const kxx = coupling(work, x, x);
  const kxy = coupling(work, x, y);
  const kyy = coupling(work, y, y);
  const trace = kxx + kyy;
  if (!(trace > 0)) return;
  const vx = speedAlong(a, b, x) + softness.biasRate * x.error;
  const vy = speedAlong(a, b, y) + softness.biasRate * y.error;
  const determinant = kxx * kyy - kxy * kxy;
  // Where the point moves along one line only, as that of a body on a rail, by the pseudo-inverse K/(tr K)² of a matrix of rank 1.
  const isLine = determinant <= SINGULAR * (trace * trace);
  const scale = softness.massScale / (isLine ? trace * trace : determinant);
  const keep = 1 - softness.impulseScale;
  let sumX = keep * to.lock0 - scale * (isLine ? kxx * vx + kxy * vy : kyy * vx - kxy * vy);
  let sumY = keep * to.lock1 - scale * (isLine ? kyy * vy + kxy * vx : kxx * vy - kxy * vx);
  const length = sqrt<f64>(sumX * sumX + sumY * sumY);
  if (length > most) {
    sumX *= most / length;
    sumY *= most / length;
  }
  const jx = finite(sumX - to.lock0);
  const jy = finite(sumY - to.lock1);
  to.lock0 += jx;
  to.lock1 += jy;
  applyAlong(work, a, b, x, jx);
  applyAlong(work, a, b, y, jy);
}
