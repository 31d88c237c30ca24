/** Principia: headless game physics over bitECS columns in one WebAssembly memory. */

export { ballInertia, ballMass, discInertia, discMass } from './bodies/inertia';
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
export {
  type ColumnsOf,
  type ComponentSpec,
  defineComponent,
  type FieldSpec,
  type RealColumn,
  real as realField,
  u32 as wordField,
} from './components/define';
export { MAX_POSITION } from './components/position';
export { MAX_ANGULAR_SPEED } from './components/rotation';
export { MAX_SPEED } from './components/velocity';
export { type BrokenSprings, breakSprings, brokenSprings } from './constraints/breaking';
export { largestStretch, rmsStretch } from './constraints/stretch';
export { type XpbdOptions, xpbd } from './constraints/xpbd';
export { angularMomentum, centreOfMass, type Energy, energy, momentum, totalMass } from './diagnostics/energy';
export { stateHash } from './diagnostics/hash';
export { defineCheckedLaw as defineLaw, type LawFactory } from './dynamics/define-law';
export { type EvaluateForces, evaluateForces } from './dynamics/evaluate-forces';
export { explain } from './dynamics/explain';
export { lawFromPotential, type PotentialOptions } from './dynamics/law-from-potential';
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
export { type BurstPattern, createPattern } from './emitters/pattern';
export { type EventMap, type EventName, type Handler, on } from './events/handlers';
export { clearFaults, type Fault, type FaultLog } from './faults/fault-log';
export { type FaultCode, type FaultDetails, PhysicsError } from './faults/physics-error';
export type { Vector, VectorInput } from './faults/validate';
export { addedMass } from './forces/added-mass';
export { type AttractorsOptions, attractors } from './forces/attractors';
export { type BendOptions, bendGrip } from './forces/bend-grip';
export type { CentreOptions } from './forces/central';
export { type CorrelatedGustOptions, correlatedGusts } from './forces/correlated-gusts';
export { linearDrag, quadraticDrag } from './forces/drag';
export { electricField } from './forces/electric-field';
export {
  type EnclosedMassOptions,
  enclosedMassGravity,
  GRAVITATIONAL_CONSTANT,
} from './forces/enclosed-mass-gravity';
export { accelerationField, type Field, type FieldOptions, forceField } from './forces/field-force';
export { COULOMB_CONSTANT, fixedCharges } from './forces/fixed-charges';
export { immersedDrag } from './forces/immersed-drag';
export { applyImpulse, type ExplosionOptions, explode } from './forces/impulse';
export { type LennardJonesOptions, lennardJones } from './forces/lennard-jones';
export { type LiftOptions, lift } from './forces/lift';
export { limited } from './forces/limited';
export type { Limits, Region } from './forces/limits';
export { magneticField } from './forces/magnetic-field';
export { type MagnusOptions, magnus } from './forces/magnus';
export { type MotorOptions, motors } from './forces/motors';
export { type PaczynskiWiitaOptions, paczynskiWiita } from './forces/paczynski-wiita';
export { type PeriodicDriveOptions, periodicDrive } from './forces/periodic-drive';
export { type PlaneSupportOptions, planeSupport } from './forces/plane-support';
export { type PointerPull, type PointerPullOptions, pointerPull } from './forces/pointer-pull';
export { type PolygonHull, polygonUpthrust } from './forces/polygon-upthrust';
export type { Pool } from './forces/pool';
export { type PostNewtonianOptions, postNewtonian } from './forces/post-newtonian';
export { type PowerLawOptions, powerLaw } from './forces/power-law';
export { type RandomDriveOptions, randomDrive } from './forces/random-drive';
export { replaceForce } from './forces/replace-force';
export { type RocketOptions, rocketEngines } from './forces/rocket-engines';
export { type FluidOptions, sphereDrag, sphereDragCoefficient } from './forces/sphere-drag';
export { removedSprings, springs } from './forces/springs';
export { type StringOptions, stringTension } from './forces/string-tension';
export { type ThrustOptions, thrust } from './forces/thrust';
export { angularDrag, constantTorque } from './forces/torque';
export { type TurbulenceOptions, turbulentDrag } from './forces/turbulent-drag';
export { STANDARD_GRAVITY, uniformGravity } from './forces/uniform-gravity';
export { type UniformSphereOptions, uniformSphereGravity } from './forces/uniform-sphere-gravity';
export { upthrust } from './forces/upthrust';
export { type VortexOptions, vortex } from './forces/vortex';
export { type GustOptions, gusts, type Wind } from './forces/wind';
export { type YukawaOptions, yukawa } from './forces/yukawa';
export { INTEGRATORS, type IntegratorName, type IntegratorRecord } from './integrators/all';
export { type BorisOptions, boris } from './integrators/boris';
export { defineCheckedIntegrator as defineIntegrator } from './integrators/define-integrator';
export {
  type DenseState,
  type DormandPrinceOptions,
  denseInterval,
  denseState,
  dormandPrince,
} from './integrators/dormand-prince';
export { driftKickDrift } from './integrators/drift-kick-drift';
export { explicitEuler } from './integrators/explicit-euler';
export { type GaussRadauOptions, gaussRadau } from './integrators/gauss-radau';
export { heun } from './integrators/heun';
export { type ImplicitEulerOptions, implicitEuler } from './integrators/implicit-euler';
export type { Integrator } from './integrators/integrator';
export { leapfrog } from './integrators/leapfrog';
export { midpoint } from './integrators/midpoint';
export { positionFirstEuler } from './integrators/position-first-euler';
export { positionVerlet } from './integrators/position-verlet';
export { rungeKutta4 } from './integrators/runge-kutta-4';
export { semiImplicitEuler } from './integrators/semi-implicit-euler';
export { velocityVerlet } from './integrators/velocity-verlet';
export { type WisdomHolmanOptions, wisdomHolman } from './integrators/wisdom-holman';
export { yoshida4 } from './integrators/yoshida4';
export { yoshida6 } from './integrators/yoshida6';
export type { Precision } from './kernels/instantiate';
export type { BodySymbols, ReadSymbols, Reads } from './laws/body-symbols';
export {
  axial3,
  type Condition as ConditionSymbol,
  type Scalar as ScalarSymbol,
  type ScalarInput,
  select,
  type Vector as VectorSymbol,
  vec3,
} from './laws/expression';
export { type CustomForce, defineForce, type Force, type ForceParameter } from './laws/force';
export { formulasOf } from './laws/formula';
export type { Law, LawOptions } from './laws/law';
export { axialVector, axialVectorOverTime, scalar, vector, vectorOverTime } from './laws/parameter';
export type { Kick, SchemeFunction, SchemeResult, SchemeState } from './laws/scheme';
export { type TablePlace, table } from './laws/table';
export type { VectorOverTime } from './laws/time-vector';
export { atan2, cos, exp, log, pow, sin } from './math/elementary';
export { createRandom, type Random } from './math/random';
export { type Mergers, mergeOnContact, mergers } from './n-body/merge-on-contact';
export { type MutualCoulombOptions, mutualCoulomb } from './n-body/mutual-coulomb';
export type {
  DistanceLaw,
  MutualForce,
  MutualForceReport,
  MutualOptions,
  SumMethod,
} from './n-body/mutual-force';
export { type MutualGravityOptions, mutualGravity } from './n-body/mutual-gravity';
export { type Cloth, type ClothOptions, createCloth } from './networks/cloth';
export { type ClothWindOptions, clothWind } from './networks/cloth-wind';
export { enclosedGas, type GasOptions } from './networks/gas';
export type { Network, SpringOptions } from './networks/network';
export { movePin, pin, unpin } from './networks/pins';
export { createRope, type RopeOptions } from './networks/rope';
export { createSoftBody, type SoftBody, type SoftBodyOptions } from './networks/soft-body';
export { colliding } from './presets/colliding';
export type { Preset } from './presets/preset';
export { standard } from './presets/standard';
export { bodyAt, type PickOptions } from './queries/pick';
export { keepState } from './record/keep-state';
export { restore, type Snapshot, snapshot } from './record/snapshot';
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
export { columnsOf } from './store/own-components';
export { type EntityRef, entityRef, isAlive, isBody, resolve } from './store/references';
export { constant, resource } from './store/resource';
export { type BodyList, bodies, type Spans } from './store/spans';
export { createPhysicsWorld, destroyWorld, type PhysicsWorld, type PhysicsWorldOptions } from './world';
