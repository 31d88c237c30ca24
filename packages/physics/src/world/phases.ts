/**
 * The chapters of a step, in order. Systems run in the order of their array; nothing says "before" or "after".
 */
export const PHASES = [
  /** Your own systems: controls, scripts. Reads anything, writes velocities and parameters. */
  'input',
  /** Emitters age, end and bear particles. */
  'emit',
  /** Saves the pose for interpolation and finds values that are not finite before they can spread. */
  'begin',
  /** Forces and the integrator: velocities and positions move by one step. */
  'integrate',
  /** Walls: bodies that ended inside one are brought back. */
  'walls',
  /** Contacts between bodies: broad phase, narrow phase, response. */
  'collide',
  /** Finds values that are not finite or out of range after the step, and quarantines their bodies. */
  'finish',
  /** Your own systems again, with this step's contacts and faults to read. */
  'events',
] as const;

export type Phase = (typeof PHASES)[number];
