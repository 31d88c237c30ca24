/**
 * The autopilot that holds an altitude: a PID of the altitude, whose output is the pitch that the assistant holds.
 *
 *   θ = θ₀ + K_p e + K_i ∫ e dt − K_d dh/dt        e = h₀ − h, within ±20 m
 *
 * The climb follows the pitch as dh/dt = V θ/(1 + T s), T = 2 m/(ρ V A C_Lα) = 0.5 s at V = 45 m/s, so that the closed loop is
 *   T s³ + (1 + V K_d) s² + V K_p s + V K_i = 0
 * whose slow roots, −0.19 ± 0.10 i per second, damp it well; the third is at −3.5. It knows no throttle: with too little of it
 * the speed falls, and the assistant lowers the nose before the wing stalls. Stevens and Lewis, Aircraft Control and
 * Simulation, section 4.6.
 */

/** What the autopilot keeps between steps. */
export interface AltitudeHold {
  /** Whether it flies. */
  isOn: boolean;
  /** h₀, m. */
  altitude: number;
  /** θ₀ + K_i ∫ e dt, rad. */
  trim: number;
}

export const GAINS = { p: 0.016, i: 0.002, d: 0.02 } as const;
/** A larger error than this, m, asks for no more climb, and is not summed up. */
const MOST_ERROR = 20;
const MOST_PITCH = 0.22;
/** A stick that is held moves the altitude, m/s. */
const SELECT_RATE = 4;

export function createAltitudeHold(): AltitudeHold {
  return { isOn: false, altitude: 0, trim: 0 };
}

/** Begins to hold the present altitude, m, from the present pitch, rad. */
export function engage(hold: AltitudeHold, altitude: number, pitch: number, climb: number): void {
  hold.isOn = true;
  hold.altitude = altitude;
  // Without a jerk: the first output is the present pitch.
  hold.trim = pitch + GAINS.d * climb;
}

/** The pitch to hold, rad. @param select from −1 down to 1 up @param altitude and climb m, m/s */
export function pitchToHold(hold: AltitudeHold, select: number, altitude: number, climb: number, dt: number): number {
  hold.altitude += SELECT_RATE * select * dt;
  const error = Math.min(MOST_ERROR, Math.max(-MOST_ERROR, hold.altitude - altitude));
  const pitch = hold.trim + GAINS.p * error - GAINS.d * climb;
  const isFree = Math.abs(pitch) < MOST_PITCH && Math.abs(error) < MOST_ERROR;
  // Nothing is summed up that the pitch cannot follow.
  if (isFree) hold.trim += GAINS.i * error * dt;
  return Math.min(MOST_PITCH, Math.max(-MOST_PITCH, pitch));
}
