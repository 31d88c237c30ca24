// Rigid bodies in soft steps: contacts and joints are damped springs, solved implicitly in sub-steps.
//
//   once a step      broad phase, narrow phase, prepare                   kernels/collision, kernels/solver/2d
//   in a sub-step    forces that change; velocities; warm start; solve; positions; relax; crowds are kept from bursting (crowds.ts)
//   once a step      restitution, impulses kept for the next step
//
// Forces are those of the world, evaluated in every sub-step if they depend on motion or time, so that drag, wind and springs act
// on rigid bodies, with their torque. Momentum is conserved to rounding. Contacts are rigid when relaxed, and soft only where
// they push overlap out, so that stacks stand without jitter; the residual overlap is a fraction of the slop of 5 mm.
//
// First order. Sources: Catto, Solver2D (2024), box2d.org/posts/2024/02/solver2d, and Box2D 3, whose defaults these are;
// Macklin et al.: Small Steps in Physics Simulation (SCA 2019).

import { rigidKernels } from '../collision/kernels.ts';
import { anyForceAppliesTorque } from '../dynamics/evaluate-forces.ts';
import { areForcesSteady } from '../dynamics/steady-forces.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, checkKeys, checkNumber } from '../errors/validate.ts';
import { springTable } from '../forces/support/spring-table.ts';
import { breakJoints } from '../joints/create-joint.ts';
import { jointTable, refreshJoints } from '../joints/joint-table.ts';
import {
  SpringTableWord as SpringWord,
  RigidTableNumber as Value,
  RigidTableWord as Word,
} from '../memory/layouts.gen.ts';
import { markSoftStep } from '../world/is-soft-step.ts';
import type { EvaluateForces, Integrator, PhysicsWorld, Ranges } from '../world/types.ts';
import { askAboutPairs, type ShouldCollide } from './ask-user.ts';
import { refreshBoxes } from './box-planes.ts';
import { contentVersion, poolVersion } from './content-version.ts';
import { refreshParts } from './refresh-parts.ts';
import { refreshWalls } from './refresh-walls.ts';
import { refuseUnsupported } from './refuse-unsupported.ts';
import { rigidTable } from './rigid-table.ts';
import { markBodiesToSleep } from './sleep.ts';
import { beginSubsteps } from './step-lengths.ts';
import { endStage, startStages } from './time-stages.ts';

/** How rigid bodies are solved. Lengths are for bodies from 0.1 m to 10 m. */
export interface SoftStepOptions {
  /** Sub-steps of a step; default 4. */
  readonly substeps?: number;
  /** Frequency of contacts as springs, Hz; default 30, at most an eighth of the rate of sub-steps. */
  readonly contactHertz?: number;
  /** Damping ratio of contacts; default 10. */
  readonly contactDampingRatio?: number;
  /** Largest speed at which overlap is pushed out, m/s; default 3. */
  readonly contactSpeed?: number;
  /** Frequency of joints as springs, Hz; default 72, at most three tenths of the rate of sub-steps. */
  readonly jointHertz?: number;
  /** Damping ratio of joints; default 2. */
  readonly jointDampingRatio?: number;
  /** Slower impacts do not bounce, m/s; default 1. */
  readonly restitutionThreshold?: number;
  /** Impacts faster than this are listed in `contactEvents(world).hit`, m/s; default 1. */
  readonly hitSpeed?: number;
  /**
   * A body none of whose points is faster, or gains a tenth of it, is still, m/s; default 0.05. What goes at a steady speed is
   * still below 0.69 of it, or 0.116 where nothing of its island touches; what nothing holds below a thousandth of it.
   */
  readonly sleepSpeed?: number;
  /** Bodies that touch each other sleep when all were still for so long, s; default 0.5. With 0 none sleeps. */
  readonly sleepTime?: number;
  /**
   * Called once when the boxes around two shapes begin to overlap, with their entities, a < b, in ascending order of
   * (a, b): bodies, or parts of compound bodies. With `false` they do not collide until their boxes part. It must
   * depend on nothing but the world, or steps cannot be repeated; edits take effect when the step ends. Default all do.
   */
  readonly shouldCollide?: ShouldCollide;
}

const OPTIONS = [
  'substeps',
  'contactHertz',
  'contactDampingRatio',
  'contactSpeed',
  'jointHertz',
  'jointDampingRatio',
  'restitutionThreshold',
  'hitSpeed',
  'sleepSpeed',
  'sleepTime',
  'shouldCollide',
] as const;

/** Contacts are springs of at most this part of the rate of sub-steps; kernels/solver/2d/prepare-contacts.ts has the same. */
const MAX_PART_OF_RATE = 0.125;

/**
 * The integrator of the preset `rigidBodies`, with other settings than its own.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function softStep(options: SoftStepOptions = {}): Integrator {
  checkKeys(options, 'softStep', OPTIONS);
  const number = (
    name: Exclude<keyof SoftStepOptions, 'shouldCollide'>,
    standard: number,
    min: number,
    max: number,
    integer = false,
  ) => checkNumber(options[name] ?? standard, `softStep.${name}`, { min, max, integer });
  const { shouldCollide } = options;
  if (shouldCollide !== undefined) checkFunction(shouldCollide, 'softStep.shouldCollide');
  const substeps = number('substeps', 4, 1, 1000, true);
  const contactHertz = number('contactHertz', 30, 0.1, 1e6);
  const values: readonly (readonly [Value, number])[] = [
    [Value.contactHertz, contactHertz],
    [Value.contactDampingRatio, number('contactDampingRatio', 10, 0, 1000)],
    [Value.contactSpeed, number('contactSpeed', 3, 0, 1e6)],
    [Value.sleepSpeed, number('sleepSpeed', 0.05, 0, 1e6)],
    [Value.sleepTime, number('sleepTime', 0.5, 0, 1e6)],
    [Value.hitSpeed, number('hitSpeed', 1, 0, 1e6)],
    [Value.jointHertz, number('jointHertz', 72, 0.1, 1e6)],
    [Value.jointDampingRatio, number('jointDampingRatio', 2, 0, 1000)],
    [Value.restitutionThreshold, number('restitutionThreshold', 1, 0, 1e6)],
  ];
  return markSoftStep({
    name: 'soft step',
    order: 1,
    symplectic: false,
    evaluations: substeps,
    velocityLag: 0.5 / substeps,
    wholeWorld: true,
    solvesWalls: true,
    // As of semi-implicit Euler with the length of a sub-step.
    isStable: (stiffness, damping) => stiffness / (substeps * substeps) + (2 * damping) / substeps <= 4,
    contactAngularFrequency: (dt) => 2 * Math.PI * Math.min(contactHertz, (MAX_PART_OF_RATE * substeps) / dt),
    prepare(world) {
      assertPreset(world);
      refuseUnsupported(world);
      const { numbers } = rigidTable(world);
      for (const [value, number] of values) numbers[value] = number;
      refreshBoxes(world);
      refreshWalls(world);
      refreshParts(world);
      refreshJoints(world);
    },
    advance: (world, ranges, dt, evaluateForces) =>
      advance(world, ranges, dt, evaluateForces, { substeps, shouldCollide }),
  });
}

/** Other systems of the preset end what the integrator begins. @throws PhysicsError E_RANGE */
function assertPreset({ phases }: PhysicsWorld): void {
  if (phases.finish.includes(breakJoints)) return;
  throw new PhysicsError('E_RANGE', 'softStep() solves rigid bodies, and this world was not made for them.', {
    field: 'integrator',
    hint: 'Create the world with `preset: rigidBodies`.',
  });
}

/** What all parts of a step need to know. */
interface Solving {
  readonly kernels: Kernels;
  /** Addresses of the tables of bodies and of joints; 0 where there are no joints. */
  readonly at: number;
  readonly joints: number;
}

function advance(
  world: PhysicsWorld,
  ranges: Ranges,
  dt: number,
  evaluateForces: EvaluateForces,
  { substeps, shouldCollide }: { readonly substeps: number; readonly shouldCollide: ShouldCollide | undefined },
): void {
  const h = dt / substeps;
  beginSubsteps(world, h);
  startStages(world);
  const solving = beginStep(world, dt);
  const { kernels, at } = solving;
  kernels.gatherBodies(at);
  endStage(world, 'gather');
  // Before anything else, because other forces wake what sleeps.
  evaluateForces(world, ranges, world.time);
  endStage(world, 'forces');
  findContacts(world, solving, shouldCollide);
  const isCrowded = kernels.findCrowds(at) > 0;
  const isSteady = areForcesSteady(world);
  endStage(world, 'narrowPhase');
  for (let s = 0; s < substeps; s++) {
    if (s > 0 && !isSteady) {
      evaluateForces(world, ranges, world.time + s * h);
      endStage(world, 'forces');
    }
    solveVelocities(solving, isCrowded, s === 0);
    kernels.integratePositions(at);
    relaxVelocities(solving, isCrowded);
    if (s < substeps - 1 && !isSteady) writePoses(kernels, at);
    endStage(world, 'solve');
  }
  bounce(solving, isCrowded);
  endStage(world, 'restitution');
  endStep(world, solving);
  endStage(world, 'sleep');
}

function beginStep(world: PhysicsWorld, dt: number): Solving {
  const { at, words, numbers } = rigidTable(world);
  numbers[Value.dt] = dt;
  words[Word.rows] = world.lastId + 1;
  words[Word.torqueZ] = anyForceAppliesTorque(world) ? world.scratch.at.torque.z : 0;
  const joints = world.internal.counts.Joint > 0 ? jointTable(world).at : 0;
  words[Word.joints] = joints;
  words[Word.linkCount] = 0;
  words[Word.loopCount] = 0;
  return { kernels: rigidKernels(world), at, joints };
}

/** The broad and the narrow phase; what sleeps and is met or pulled wakes before manifolds are found. */
function findContacts(
  world: PhysicsWorld,
  { kernels, at, joints }: Solving,
  shouldCollide: ShouldCollide | undefined,
): void {
  const { words } = rigidTable(world);
  listSprings(world, words);
  words[Word.asksUser] = shouldCollide === undefined ? 0 : 1;
  kernels.findRigidPairs(at);
  if (shouldCollide !== undefined) askAboutPairs(world, shouldCollide);
  endStage(world, 'broadPhase');
  kernels.wakeIslands(at);
  if (joints !== 0) kernels.prepareJoints(joints);
  kernels.updateContacts(at);
  kernels.colorContacts(at);
  kernels.prepareContacts(at);
}

/** Begins a sub-step: velocities as forces, joints and contacts want them, with the pull on gaps and the push on overlap. */
function solveVelocities({ kernels, at, joints }: Solving, isCrowded: boolean, isFirst: boolean): void {
  kernels.integrateVelocities(at);
  if (isCrowded) kernels.measureCrowds(at);
  if (joints !== 0 && isFirst) kernels.slowLandings(at);
  if (joints !== 0) kernels.startJoints(joints);
  kernels.warmStartContacts(at);
  kernels.holdLocked(at);
  if (joints !== 0) solveJoints(kernels, joints);
  kernels.solveContacts(at);
  kernels.holdLocked(at);
  if (isCrowded) kernels.limitCrowdSpeeds(at);
}

/** Ends a sub-step: takes back the speed that pulls and pushes gave. */
function relaxVelocities({ kernels, at, joints }: Solving, isCrowded: boolean): void {
  if (joints !== 0) relaxJoints(kernels, joints);
  kernels.relaxContacts(at);
  kernels.holdLocked(at);
  if (isCrowded) kernels.limitCrowdEnergies(at);
}

function bounce({ kernels, at, joints }: Solving, isCrowded: boolean): void {
  // Where joints close a loop or hold many bodies, what bounces is no longer as they want it.
  const bounced = kernels.applyRestitution(at) > 0;
  if (joints !== 0 && (kernels.endLandings(at) > 0 || bounced)) kernels.relaxLocks(joints);
  if (isCrowded) kernels.endCrowds(at);
  kernels.holdLocked(at);
}

/** Keeps impulses for the next step, stops what would pass through something, and writes columns and events. */
function endStep(world: PhysicsWorld, { kernels, at, joints }: Solving): void {
  if (joints !== 0) kernels.closeTorn(joints);
  kernels.storeImpulses(at);
  kernels.stopFastBodies(at);
  endStage(world, 'continuous');
  writePoses(kernels, at);
  if (rigidTable(world).words[Word.partCount] > 0) kernels.writeParts(at, 0);
  if (joints !== 0) kernels.listBroken(joints);
  markBodiesToSleep(world);
  kernels.updateSleep(at);
  if (joints !== 0) kernels.noteSettings(joints);
  kernels.listContactEvents(at);
  kernels.rememberPoses(at, contentVersion(world), poolVersion(world));
}

/** Tells the islands which bodies springs connect. */
function listSprings(world: PhysicsWorld, words: Uint32Array): void {
  words[Word.springCount] = 0;
  if (world.internal.counts.Spring === 0 || world.internal.springTable === undefined) return;
  const springs = springTable(world).words;
  words[Word.springs] = springs[SpringWord.links];
  words[Word.springCount] = springs[SpringWord.active];
}

type Kernels = ReturnType<typeof rigidKernels>;

/** For forces that read them in the next sub-step, and at the end. */
function writePoses(kernels: Kernels, at: number): void {
  kernels.writeBodies(at);
  kernels.writeAngles(at);
}

/** Joints pull together what is apart. */
function solveJoints(kernels: Kernels, joints: number): void {
  kernels.solveAxes(joints, 1);
  kernels.solveLocks(joints);
}

function relaxJoints(kernels: Kernels, joints: number): void {
  kernels.solveAxes(joints, 0);
  kernels.relaxLocks(joints);
}
