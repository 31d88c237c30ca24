// What the springs of joints store. A spring of frequency f along the coordinate s of a joint has the stiffness m (2π f)², where m is
// the reduced mass of the two bodies, or their reduced inertia if s is an angle (kernels/joints/2d/solve-axes.ts).
import { isOpen } from '../ecs/rows.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { coordinateOf, positionAlong } from './joint-position.ts';

/** Energy of the springs of all joints, J, in ascending order of ids. */
export function jointSpringEnergy(world: PhysicsWorld): number {
  if (world.internal.counts.Joint === 0) return 0;
  const { hertz } = world.components.Joint;
  let sum = 0;
  for (let joint = 1; joint <= world.lastId; joint++) {
    if (hertz[joint] > 0 && isOpen(world, joint, 'Joint') && isWhole(world, joint)) sum += energyOf(world, joint);
  }
  return sum;
}

/** Whether the bodies are still there: the joints of those that are gone go at the next step. */
function isWhole({ components, internal }: PhysicsWorld, joint: number): boolean {
  const { a, b, aGeneration, bGeneration } = components.Joint;
  const { generations } = internal;
  return (
    generations[b[joint]] === bGeneration[joint] && (a[joint] === 0 || generations[a[joint]] === aGeneration[joint])
  );
}

function energyOf(world: PhysicsWorld, joint: number): number {
  const coordinate = coordinateOf(world, joint);
  if (coordinate === undefined) return 0;
  const { a, b, hertz, length, maxForce, maxCompression } = world.components.Joint;
  const inverse = coordinate === 'angle' ? inverseInertia : inverseMass;
  const yields = inverse(world, a[joint]) + inverse(world, b[joint]);
  if (yields === 0) return 0;
  const rest = coordinate === 'distance' ? length[joint] : 0;
  const signed = positionAlong(world, joint, coordinate) - rest;
  const stretch = Math.abs(signed);
  const rate = 2 * Math.PI * hertz[joint];
  const most = signed < 0 ? Math.min(maxForce[joint], maxCompression[joint]) : maxForce[joint];
  const force = Math.min((rate * rate * stretch) / yields, most);
  // Beyond its largest force it pulls with that.
  return force * (stretch - (0.5 * force * yields) / (rate * rate));
}

/** 1/kg; 0 for the world, and for bodies that forces do not move. */
function inverseMass(world: PhysicsWorld, body: number): number {
  const mass = world.components.Mass.value[body];
  return mass > 0 && !isOpen(world, body, 'Kinematic') ? 1 / mass : 0;
}

/** 1/(kg m²); 0 for the world, and for bodies that torques do not turn. */
function inverseInertia(world: PhysicsWorld, body: number): number {
  const { Inertia, MotionLocks } = world.components;
  const isLocked = isOpen(world, body, 'MotionLocks') && MotionLocks.angle[body] !== 0;
  const turns = inverseMass(world, body) > 0 && !isLocked && isOpen(world, body, 'AngularVelocity');
  return turns && Inertia.value[body] > 0 ? 1 / Inertia.value[body] : 0;
}
