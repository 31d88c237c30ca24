/** Principia: headless game physics over bitECS columns in one WebAssembly memory. */

export type { BodyInput } from './bodies/body-input.ts';
export type { ShapeInput } from './bodies/collider-shape.ts';
export { setCompoundDensity } from './bodies/compound-density.ts';
export { despawnMany } from './bodies/despawn-many.ts';
export { type ExplosionOptions, explode } from './bodies/explode.ts';
export { applyImpulse } from './bodies/impulse.ts';
export { ballInertia, ballMass, boxInertia, cylinderInertia, discInertia, discMass } from './bodies/inertia.ts';
export type { Many, ManyInput } from './bodies/many.ts';
export { bodyOf, partsOf } from './bodies/parts.ts';
export { type PrincipalAxes, principalAxes, type TensorInput } from './bodies/principal-axes.ts';
export { setDensity } from './bodies/set-density.ts';
export { setShape } from './bodies/set-shape.ts';
export { despawn, spawn } from './bodies/spawn.ts';
export { type ChainSurface, type SpawnChainOptions, spawnChain } from './bodies/spawn-chain.ts';
export { type Compound, type CompoundInput, type CompoundShape, spawnCompound } from './bodies/spawn-compound.ts';
export { type Progress, spawnMany } from './bodies/spawn-many.ts';
export { type Solid, type SolidMass, tensorOfParts } from './bodies/tensor-of-parts.ts';
export type { CharacterOptions } from './characters/character.ts';
export { type CharacterContact, type CharacterMotion, moveCharacter } from './characters/move-character.ts';
export { box, type RoundingOptions } from './collision/shapes/2d/box.ts';
export { capsule } from './collision/shapes/2d/capsule.ts';
export { type ChainOptions, chain } from './collision/shapes/2d/chain.ts';
export { circle } from './collision/shapes/2d/circle.ts';
export { type ConvexPiece, decompose } from './collision/shapes/2d/decompose.ts';
export { polygon } from './collision/shapes/2d/polygon.ts';
export { segment } from './collision/shapes/2d/segment.ts';
export type { PointInput, Shape } from './collision/shapes/2d/shape.ts';
export { type ShapeRecord, shapeFrom } from './collision/shapes/2d/shape-from.ts';
export { shapeAt, shapeCount } from './collision/shapes/shape-pool.ts';
export { type Addresses, COMPONENT_NAMES, COMPONENTS, type ComponentName, type Components } from './components/all.ts';
export { rgba } from './components/appearance.ts';
export { COMBINE } from './components/collider.ts';
export {
  type ColumnsOf,
  type ComponentSpec,
  defineCheckedComponent as defineComponent,
  type FieldSpec,
  type RealColumn,
  real as realField,
  u32 as wordField,
} from './components/define.ts';
export { MAX_POSITION } from './components/position.ts';
export { MAX_ANGULAR_SPEED } from './components/rotation.ts';
export { MAX_SPEED } from './components/velocity.ts';
export { type BodyBoxes, bodyBoxes } from './debug/body-boxes.ts';
export { type ContactPoints, contactPoints } from './debug/contact-points.ts';
export { angularMomentum, centreOfMass, type Energy, energy, momentum, totalMass } from './diagnostics/energy.ts';
export { stateHash } from './diagnostics/hash.ts';
export type { BoxSystem } from './dynamics/box-system.ts';
export { defineCheckedLaw as defineLaw, type LawFactory } from './dynamics/define-law.ts';
export { evaluateForces } from './dynamics/evaluate-forces.ts';
export { explain } from './dynamics/explain.ts';
export { lawFromPotential, type PotentialOptions } from './dynamics/law-from-potential.ts';
export type { LawForce } from './dynamics/sum-of-laws.ts';
export { beginStep, validateMotion, validateState } from './dynamics/validate-state.ts';
export { type EntityRef, entityRef, isAlive, isBody, resolve } from './ecs/entity-ref.ts';
export { columnsOf } from './ecs/own-components.ts';
export { type BodyList, bodies } from './ecs/ranges.ts';
export {
  aliveCount,
  type Births,
  type BurstOptions,
  births,
  burst,
  createEmitter,
  destroyEmitter,
  type EmitterCounts,
  type Endings,
  emitterCounts,
  endings,
  endParticle,
  moveEmitter,
  setEmitter,
  setRate,
} from './emitters/emitter.ts';
export type { EmitterOptions, EmitterParameters, Range } from './emitters/options.ts';
export { type BurstPattern, createPattern } from './emitters/pattern.ts';
export type { Emitter } from './emitters/types.ts';
export { clearFaults, type Fault, type FaultLog } from './errors/fault-log.ts';
export { type FaultCode, type FaultDetails, PhysicsError } from './errors/physics-error.ts';
export type { Vector, VectorInput } from './errors/validate.ts';
export { addedMass } from './forces/added-mass.ts';
export { type AttractorsOptions, attractors } from './forces/attractors.ts';
export { buoyancy } from './forces/buoyancy.ts';
export { type CorneringGripOptions, corneringGrip } from './forces/cornering-grip.ts';
export { linearDrag, quadraticDrag } from './forces/drag.ts';
export { electricField } from './forces/electric-field.ts';
export {
  type EnclosedMassOptions,
  enclosedMassGravity,
  GRAVITATIONAL_CONSTANT,
} from './forces/enclosed-mass-gravity.ts';
export { accelerationField, type Field, type FieldOptions, forceField } from './forces/field-force.ts';
export { COULOMB_CONSTANT, fixedCharges } from './forces/fixed-charges.ts';
export { immersedDrag } from './forces/immersed-drag.ts';
export { type LennardJonesOptions, lennardJones } from './forces/lennard-jones.ts';
export { type LiftOptions, lift } from './forces/lift.ts';
export { magneticField } from './forces/magnetic-field.ts';
export { type MagnusOptions, magnus } from './forces/magnus.ts';
export { type MotorOptions, motors } from './forces/motors.ts';
export { type PaczynskiWiitaOptions, paczynskiWiita } from './forces/paczynski-wiita.ts';
export { type PeriodicDriveOptions, periodicDrive } from './forces/periodic-drive.ts';
export { type PlaneSupportOptions, planeSupport } from './forces/plane-support.ts';
export { type PointerPull, type PointerPullOptions, pointerPull } from './forces/pointer-pull.ts';
export { type PolygonHull, polygonBuoyancy } from './forces/polygon-buoyancy.ts';
export { type PostNewtonianOptions, postNewtonian } from './forces/post-newtonian.ts';
export { type PowerLawOptions, powerLaw } from './forces/power-law.ts';
export { type RandomDriveOptions, randomDrive } from './forces/random-drive.ts';
export { restrictForce } from './forces/restrict-force.ts';
export { type RocketOptions, rocketEngines } from './forces/rocket-engines.ts';
export { type FluidOptions, sphereDrag, sphereDragCoefficient } from './forces/sphere-drag.ts';
export { removedSprings, springs } from './forces/springs.ts';
export { type StringOptions, stringTension } from './forces/string-tension.ts';
export type { CentreOptions } from './forces/support/central-force.ts';
export { type CorrelatedGustOptions, correlatedGusts } from './forces/support/correlated-gusts.ts';
export { type FluidVolume, surfaceHeight } from './forces/support/fluid-volume.ts';
export { replaceForce } from './forces/support/replace-force.ts';
export type { Region, Restrictions } from './forces/support/restrictions.ts';
export { STANDARD_GRAVITY } from './forces/support/standard-gravity.ts';
export type { Waves } from './forces/support/waves.ts';
export { type GustOptions, gusts, type Wind } from './forces/support/wind.ts';
export { type ThrustOptions, thrust } from './forces/thrust.ts';
export { angularDrag, type ConstantTorqueOptions, constantTorque } from './forces/torque.ts';
export { type TurbulenceOptions, turbulentDrag } from './forces/turbulent-drag.ts';
export { uniformGravity } from './forces/uniform-gravity.ts';
export { type UniformSphereOptions, uniformSphereGravity } from './forces/uniform-sphere-gravity.ts';
export { type VortexOptions, vortex } from './forces/vortex.ts';
export { type WingDeflection, type WingOptions, wing } from './forces/wing.ts';
export { type YukawaOptions, yukawa } from './forces/yukawa.ts';
export { type BorisOptions, boris } from './integrators/boris.ts';
export {
  type DenseState,
  type DormandPrinceOptions,
  denseInterval,
  denseState,
  dormandPrince,
} from './integrators/dormand-prince.ts';
export { driftKickDrift } from './integrators/drift-kick-drift.ts';
export { explicitEuler } from './integrators/explicit-euler.ts';
export { type GaussRadauOptions, gaussRadau } from './integrators/gauss-radau.ts';
export { heun } from './integrators/heun.ts';
export { type ImplicitEulerOptions, implicitEuler } from './integrators/implicit-euler.ts';
export { leapfrog } from './integrators/leapfrog.ts';
export { midpoint } from './integrators/midpoint.ts';
export { positionFirstEuler } from './integrators/position-first-euler.ts';
export { positionVerlet } from './integrators/position-verlet.ts';
export { rungeKutta4 } from './integrators/runge-kutta-4.ts';
export { semiImplicitEuler } from './integrators/semi-implicit-euler.ts';
export { defineCheckedIntegrator as defineIntegrator } from './integrators/support/define-integrator.ts';
export { INTEGRATORS, type IntegratorName, type IntegratorRecord } from './integrators/support/integrator-list.ts';
export { velocityVerlet } from './integrators/velocity-verlet.ts';
export { type WisdomHolmanOptions, wisdomHolman } from './integrators/wisdom-holman.ts';
export { yoshida4 } from './integrators/yoshida4.ts';
export { yoshida6 } from './integrators/yoshida6.ts';
export { createJoint, endedJoints, jointForce, jointTorque } from './joints/create-joint.ts';
export { type DistanceOptions, distance } from './joints/distance.ts';
export { type FilterJointOptions, filterJoint } from './joints/filter-joint.ts';
export { type GearOptions, gear } from './joints/gear.ts';
export type { JointInput, JointLimits, JointMotor, JointOptions, JointSpring } from './joints/joint-input.ts';
export { jointPosition } from './joints/joint-position.ts';
export type { EndedJoints } from './joints/joint-table.ts';
export { type MotorJointOptions, type MouseJointOptions, motorJoint, mouseJoint } from './joints/motor-joint.ts';
export { type PrismaticOptions, prismatic } from './joints/prismatic.ts';
export { type PulleyOptions, pulley } from './joints/pulley.ts';
export { type RevoluteOptions, revolute } from './joints/revolute.ts';
export { type WeldOptions, weld } from './joints/weld.ts';
export { type WheelOptions, wheel } from './joints/wheel.ts';
export type { KernelExports, Precision } from './kernels/instantiate.ts';
export type { BodySymbols, ReadSymbols, Reads } from './laws/body-symbols.ts';
export {
  axial3,
  type Condition as ConditionSymbol,
  type Scalar as ScalarSymbol,
  type ScalarInput,
  select,
  type Vector as VectorSymbol,
  vec3,
} from './laws/expression.ts';
export { type CustomForce, defineForce } from './laws/force.ts';
export { formulasOf } from './laws/formula.ts';
export type { LawOptions } from './laws/law.ts';
export {
  axialVector,
  axialVectorOverTime,
  type Optional as OptionalParameter,
  type ParameterInput,
  scalar,
  vector,
  vectorOverTime,
} from './laws/parameter.ts';
export { type CurvePoints, piecewiseLinear } from './laws/piecewise-linear.ts';
export type { Kick, SchemeFunction, SchemeResult, SchemeState } from './laws/scheme.ts';
export { type TableLocation, type TableParameter, table } from './laws/table.ts';
export type { VectorOverTime } from './laws/time-vector.ts';
export { atan2, cos, exp, log, pow, sin } from './math/elementary.ts';
export { createRandom, type Random } from './math/random.ts';
export type { Previous } from './memory/previous-pose.ts';
export { markImmutable, resource } from './memory/resource.ts';
export type { Scratch } from './memory/scratch.ts';
export { type Mergers, mergeOnContact, mergers } from './n-body/merge-on-contact.ts';
export { type MutualCoulombOptions, mutualCoulomb } from './n-body/mutual-coulomb.ts';
export type {
  DistanceLaw,
  MutualForce,
  MutualForceReport,
  MutualOptions,
  SumMethod,
} from './n-body/mutual-force.ts';
export { type MutualGravityOptions, mutualGravity } from './n-body/mutual-gravity.ts';
export { type BoxWallsOptions, boxWalls, replaceBoxWalls } from './particle-contacts/box-walls.ts';
export { collideBodies, enableContacts } from './particle-contacts/collide.ts';
export {
  type Contacts,
  contactCapacity,
  contacts,
  dispatchContactEvents,
  type WallContacts,
  wallContacts,
} from './particle-contacts/contacts.ts';
export { planeWalls } from './particle-contacts/plane-walls.ts';
export { segmentWalls } from './particle-contacts/segment-walls.ts';
export { particleContacts } from './presets/particle-contacts.ts';
export { rigidBodies } from './presets/rigid-bodies.ts';
export { standard } from './presets/standard.ts';
export type { Hit, PoseInput, QueryFilter } from './queries/body-query.ts';
export { castShape, castShapeAll } from './queries/cast-shape.ts';
export { type NearestPoint, type NearestPointOptions, nearestPoint } from './queries/nearest-point.ts';
export { overlapShape } from './queries/overlap-shape.ts';
export { type BodyPairs, pairsWithin } from './queries/pairs-within.ts';
export { bodyAt, type PickOptions } from './queries/pick.ts';
export { type Ray, rayCast, rayCastAll, rayCastMany } from './queries/ray-cast.ts';
export type { Snapshot } from './snapshot/content.ts';
export { decodeSnapshot } from './snapshot/decode-snapshot.ts';
export { encodeSnapshot } from './snapshot/encode-snapshot.ts';
export { keepState } from './snapshot/keep-state.ts';
export { restore, snapshot } from './snapshot/snapshot.ts';
export { type Cloth, type ClothOptions, createCloth } from './soft-bodies/cloth.ts';
export { type ClothWindOptions, clothWind } from './soft-bodies/cloth-wind.ts';
export { enclosedGas, type GasOptions } from './soft-bodies/gas.ts';
export type { Network, SpringOptions } from './soft-bodies/network.ts';
export { movePin, pin, unpin } from './soft-bodies/pins.ts';
export { createRope, type RopeOptions } from './soft-bodies/rope.ts';
export { createSoftBody, type SoftBody, type SoftBodyOptions } from './soft-bodies/soft-body.ts';
export type { ShouldCollide } from './solver/ask-user.ts';
export { type ContactEvents, type ContactHits, type ContactPairs, contactEvents } from './solver/contact-events.ts';
export { type BodyIds, type MotionEvents, motionEvents } from './solver/motion-events.ts';
export { type SensorEvents, type SensorPairs, sensorEvents } from './solver/sensor-events.ts';
export { asleepCount, isAsleep, putToSleep, wake } from './solver/sleep.ts';
export { type SoftStepOptions, softStep } from './solver/soft-step.ts';
export { createPhysicsWorld, destroyWorld, type PhysicsWorldOptions } from './world/create-world.ts';
export { type EventMap, type EventName, type Handler, on } from './world/event-handlers.ts';
export {
  PHASES,
  type Phase,
  type Profile,
  SOLVER_STAGES,
  type SolverStage,
} from './world/phases.ts';
export { resetProfile, startProfile, stopProfile } from './world/profile.ts';
export { createRunner, type Runner, type RunnerOptions } from './world/runner.ts';
export { step } from './world/step.ts';
export { localSystem } from './world/systems.ts';
export type {
  EvaluateForces,
  Force,
  ForceParameter,
  GlobalSystem,
  Integrator,
  Law,
  LocalSystem,
  Parameter,
  Phases,
  PhysicsWorld,
  Preset,
  Ranges,
  System,
  Warning,
} from './world/types.ts';
export { type BrokenSprings, breakSprings, brokenSprings } from './xpbd/breaking.ts';
export { maxStrain, rmsStrain } from './xpbd/stretch.ts';
export { type XpbdOptions, xpbd } from './xpbd/xpbd.ts';
