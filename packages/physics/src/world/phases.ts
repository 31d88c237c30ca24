/** The phases of a step, in order. Systems run in the order of their array; there are no other ordering rules. */
export const PHASES = [
  /** Your own systems: controls, scripts. They read anything and write velocities and parameters. */
  'input',
  /** Emitters age, remove and create particles. */
  'emit',
  /** Saves the pose for interpolation, and finds non-finite values before they spread. */
  'begin',
  /** Forces and the integrator: velocities and positions move by one step. */
  'integrate',
  /** Walls: moves bodies that overlap a wall back. */
  'walls',
  /** Contacts between bodies: broad phase, narrow phase, response. */
  'collide',
  /** Finds non-finite and out-of-range values after the step, and quarantines their bodies. */
  'finish',
  /** Your own systems again; they can read the contacts and faults of this step. */
  'events',
] as const;

/** The name of a phase of the step. */
export type Phase = (typeof PHASES)[number];

/** The stages of the phase `integrate` in a step of rigid bodies, in order. */
export const SOLVER_STAGES = [
  /** Columns become the records of the solver. */
  'gather',
  /** All forces, in each sub-step. */
  'forces',
  /** Pairs of bodies whose boxes overlap. */
  'broadPhase',
  /** Joints that act, what wakes, and the points at which shapes touch. */
  'narrowPhase',
  /** Contacts and joints, and how far bodies move, in all sub-steps. */
  'solve',
  /** What bounces. */
  'restitution',
  /** Fast bodies stop at what they would pass through. */
  'continuous',
  /** Columns are written, islands fall asleep, events are listed. */
  'sleep',
] as const;

/** The name of a stage of a step of rigid bodies. */
export type SolverStage = (typeof SOLVER_STAGES)[number];

/** Time spent since the profile was started or reset, in the clock's unit. */
export interface Profile {
  readonly clock: () => number;
  /** Of each phase. */
  readonly times: Record<Phase, number>;
  /** Of the phase `integrate` with `softStep`, by its stages; 0 with other integrators. */
  readonly stages: Record<SolverStage, number>;
}
