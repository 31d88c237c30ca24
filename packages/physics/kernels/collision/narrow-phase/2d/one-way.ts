// One-way platforms: solid only for what comes down on their upper side, the direction of y in the frame of the shape. What
// began to touch one in any other way passes until the two are apart.
import { ONE_WAY, flagsOf, poseOf, stateOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { RigidContact, pointOf } from './rigid-contact';

// Cosine of the largest angle of a normal from the upper side: 60 degrees.
const MIN_COSINE: real = 0.5;
// Bodies that rise from the platform faster than this pass, m/s.
const RISING_SPEED: real = 0.1;

// Whether a normal that points away from a platform is one of its upper side.
export function isUpperSide(t: RigidTable, platform: i32, nx: real, ny: real): bool {
  const pose = poseOf(t, platform);
  return ny * pose.c - nx * pose.s > MIN_COSINE;
}

// Whether a contact that begins in this step is to pass.
export function passesThrough(t: RigidTable, contact: RigidContact): bool {
  if ((flagsOf(t, contact.a) & ONE_WAY) != 0 && !isLanding(t, contact, contact.a, 1)) return true;
  return (flagsOf(t, contact.b) & ONE_WAY) != 0 && !isLanding(t, contact, contact.b, -1);
}

function isLanding(t: RigidTable, contact: RigidContact, platform: i32, sign: real): bool {
  if (!isUpperSide(t, platform, sign * contact.nx, sign * contact.ny)) return false;
  const p = pointOf(contact, 0);
  const a = stateOf(t, contact.bodyA);
  const b = stateOf(t, contact.bodyB);
  const vx = b.vx - b.w * p.foundBy - (a.vx - a.w * p.foundAy);
  const vy = b.vy + b.w * p.foundBx - (a.vy + a.w * p.foundAx);
  return contact.nx * vx + contact.ny * vy <= RISING_SPEED;
}
