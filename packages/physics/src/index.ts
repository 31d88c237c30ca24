/** Principia: headless game physics over bitECS columns in one WebAssembly memory. */

export type { Many, ManyInput } from './bodies/many';
export { type BodyInput, despawn, spawn } from './bodies/spawn';
export { type Progress, spawnMany } from './bodies/spawn-many';
export { type BoxWallsOptions, boxWalls } from './collision/box-walls';
export { collideBodies, openContacts } from './collision/collide';
export {
  type Contacts,
  contactCapacity,
  contacts,
  tellContacts,
  type WallContacts,
  wallContacts,
} from './collision/contacts';
export { planeWalls } from './collision/plane-walls';
export { segmentWalls } from './collision/segment-walls';
export { type Addresses, COMPONENT_NAMES, COMPONENTS, type ComponentName, type Components } from './components/all';
export { rgba } from './components/appearance';
export type { ColumnsOf, ComponentSpec, FieldSpec, RealColumn } from './components/define';
export { MAX_POSITION } from './components/position';
export { MAX_ANGULAR_SPEED } from './components/rotation';
export { MAX_SPEED } from './components/velocity';
export { angularMomentum, centreOfMass, type Energy, energy, momentum, totalMass } from './diagnostics/energy';
export { stateHash } from './diagnostics/hash';
export {
  aliveCount,
  type BurstOptions,
  burst,
  createEmitter,
  destroyEmitter,
  type Emitter,
  type EmitterCounts,
  type Endings,
  emitterCounts,
  endings,
  moveEmitter,
  setEmitter,
  setRate,
} from './emitters/emitter';
export type { EmitterOptions, EmitterParameters, Range } from './emitters/options';
export { type EventMap, type EventName, type Handler, on } from './events/handlers';
export { clearFaults, type Fault, type FaultLog } from './faults/fault-log';
export { type FaultCode, type FaultDetails, PhysicsError } from './faults/physics-error';
export type { Vector, VectorInput } from './faults/validate';
export { attractors } from './forces/attractors';
export { linearDrag, quadraticDrag } from './forces/drag';
export { type EvaluateForces, evaluateForces } from './forces/evaluate';
export { type CustomForce, defineForce, type Force, type ForceParameter } from './forces/force';
export { replaceForce } from './forces/replace-force';
export { removedSprings, springs } from './forces/springs';
export { STANDARD_GRAVITY, uniformGravity } from './forces/uniform-gravity';
export { type GustOptions, gusts, type Wind } from './forces/wind';
export type { Integrator } from './integrators/integrator';
export { rungeKutta4 } from './integrators/runge-kutta-4';
export { semiImplicitEuler } from './integrators/semi-implicit-euler';
export { velocityVerlet } from './integrators/velocity-verlet';
export type { Precision } from './kernels/instantiate';
export { atan2, cos, exp, log, pow, sin } from './math/elementary';
export { createRandom, type Random } from './math/random';
export { colliding } from './presets/colliding';
export type { Preset } from './presets/preset';
export { standard } from './presets/standard';
export { createRunner, type Runner, type RunnerOptions } from './runner';
export {
  type GlobalSystem,
  type LocalSystem,
  localSystem,
  PHASES,
  type Phase,
  type Phases,
  type System,
} from './schedule/phases';
export { type Profile, resetProfile, startProfile, stopProfile } from './schedule/profile';
export { begin, checkFinite } from './schedule/quarantine';
export { step } from './step';
export { type EntityRef, entityRef, isAlive, isBody, resolve } from './store/references';
export { resource } from './store/resource';
export { type BodyList, bodies, type Spans } from './store/spans';
export { createPhysicsWorld, destroyWorld, type PhysicsWorld, type PhysicsWorldOptions } from './world';
