/** Joints that the player makes: at a point, between the two nearest bodies there, or between one and the world. */
import { circle, createJoint, nearestPoint, overlapShape, type PhysicsWorld, revolute, weld } from '@principia/physics';

export type JointName = 'hinge' | 'motor' | 'weld';

/** Distance within which bodies are joined, m. */
const REACH = 0.12;
/** Layer of bodies that can be joined: the ground counts as the world. */
const JOIN_MASK = 1;
/** Speed of a motor, rad/s, and its largest torque, N m for each kg m² of what it turns. */
const MOTOR = { speed: -5, torque: 400 } as const;

/** @returns the joint; 0 where no body is near */
export function join(world: PhysicsWorld, name: JointName, point: { readonly x: number; readonly y: number }): number {
  const [b, a] = bodiesNear(world, point);
  if (b === undefined) return 0;
  const options = { b, anchor: { x: point.x, y: point.y }, ...(a === undefined ? {} : { a }) };
  if (name === 'weld') return createJoint(world, weld(options));
  if (name === 'hinge') return createJoint(world, revolute(options));
  const { Inertia, Mass } = world.components;
  const max = MOTOR.torque * (Inertia.value[b] + Mass.value[b]);
  return createJoint(world, revolute({ ...options, motor: { speed: MOTOR.speed, max } }));
}

/** Bodies that can move first, and of those the nearest. */
function bodiesNear(world: PhysicsWorld, { x, y }: { readonly x: number; readonly y: number }): number[] {
  const { Mass } = world.components;
  const nearest = nearestPoint(world, { x, y }, { mask: JOIN_MASK, walls: false, maxDistance: REACH })?.body;
  const ids = overlapShape(world, circle(REACH), { x, y, angle: 0 }, { mask: JOIN_MASK, walls: false });
  const rank = (id: number) => (Mass.value[id] > 0 ? 0 : 2) + (id === nearest ? 0 : 1);
  const found = ids.sort((a, b) => rank(a) - rank(b)).slice(0, 2);
  // A joint needs a body that can move.
  return found.length > 0 && Mass.value[found[0]] > 0 ? found : [];
}
