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
