// A motor of no speed is the friction of a hinge: what hangs on it comes to rest, and sleeps.
import { capsule, createJoint, isAsleep, revolute, spawn } from '@principia/physics';
import { expect, it } from 'vitest';
import { G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

/** Distance of the centre of the arm from the hinge, m, and its mass, kg. */
const [REACH, MASS] = [0.3, 2];

/** Whether an arm that is let go level sleeps after so many seconds. */
function sleeps(torque: number, seconds: number): boolean {
  const world = rigidWorld();
  const arm = spawn(world, { position: { x: REACH }, mass: MASS, collider: { shape: capsule(0.5, 0.05), mask: 0 } });
  const motor = torque > 0 ? { motor: { speed: 0, max: torque } } : {};
  createJoint(world, revolute({ b: arm, anchor: {}, ...motor }));
  run(world, seconds);
  return isAsleep(world, arm);
}

it('brings an arm to rest that would swing on', () => {
  const friction = 0.1 * MASS * G * REACH;
  // Let go level it has m g l above its lowest point, and each radian costs a tenth of that: ten radians, which take a few seconds.
  expect(sleeps(friction, 12)).toBe(true);
  expect(sleeps(0, 12)).toBe(false);
});
