/**
 * What typical games import of the physics, and what it may weigh; docs/bench.md has the table. Limits in KB, of both
 * precisions and of one, keep what was reached: lower them when you make something smaller.
 */

const particles = `createPhysicsWorld destroyWorld spawn spawnMany despawn step createRunner entityRef isAlive resolve
  bodies rgba PhysicsError on startProfile energy momentum angularMomentum centreOfMass stateHash uniformGravity linearDrag
  quadraticDrag attractors springs replaceForce defineForce semiImplicitEuler velocityVerlet rungeKutta4 boxWalls standard`;
const emitters = 'createEmitter setEmitter setRate moveEmitter burst aliveCount destroyEmitter createRandom';
const contacts = 'particleContacts contacts segmentWalls planeWalls collideBodies';
const rigid = `createPhysicsWorld destroyWorld spawn despawn step createRunner bodies on uniformGravity linearDrag
  rigidBodies softStep box capsule chain circle decompose polygon segment setShape spawnChain spawnCompound createJoint
  distance filterJoint gear motorJoint mouseJoint prismatic pulley revolute weld wheel jointForce jointPosition jointTorque endedJoints
  contactEvents sensorEvents motionEvents isAsleep putToSleep wake rayCast rayCastAll castShape castShapeAll overlapShape nearestPoint
  bodyAt contactPoints bodyBoxes boxWalls snapshot restore stateHash`;

/** `title` is the row of the documentation; what has none is not in its table. */
export const bundles = [
  { name: 'discInertia', imports: 'discInertia', limits: [0.7, 0.7] },
  {
    name: 'particles',
    title: 'particles with forces, integrators, walls and diagnostics',
    imports: particles,
    limits: [65.6, 62.2],
  },
  { name: 'with emitters', title: 'with emitters', imports: `${particles} ${emitters}`, limits: [78.3, 73.9] },
  {
    name: 'with contacts',
    title: 'with contacts',
    imports: `${particles} ${emitters} ${contacts}`,
    limits: [112.2, 93.7],
  },
  {
    name: 'rigid bodies in 2D',
    title: 'rigid bodies in 2D: shapes, joints, events, queries, walls',
    imports: rigid,
    limits: [238.4, 160.4],
  },
  { name: 'everything', title: 'everything', imports: '*', limits: [400.1, 283.3] },
];
