/** From stick, pedals and levers to the control surfaces: directly, or by an assistant that holds the attitude. */
import { AIRCRAFT } from './aircraft.ts';
import { type AltitudeHold, createAltitudeHold, pitchToHold } from './altitude-hold.ts';
import type { Attitude } from './attitude.ts';

/** What the player holds: fractions, positive to the right, nose up, nose right. */
export interface Inputs {
  roll: number;
  pull: number;
  rudder: number;
  /** −1 less, 1 more. */
  throttle: number;
  brake: number;
}

/** The state of controls, kept between steps. */
export interface PilotState {
  /** Smoothed positions of the stick. */
  roll: number;
  pull: number;
  pedal: number;
  /** 0 to 1. */
  throttle: number;
  brake: number;
  /** The attitude that the assistant holds, rad. */
  targetPitch: number;
  readonly hold: AltitudeHold;
}

/** Where the ground is, and the altitude. */
export interface GroundState {
  readonly onGround: boolean;
  /** Above the ground below, m. */
  readonly height: number;
  /** Above the airfield, m, and its rate, m/s. */
  readonly altitude: number;
  readonly climb: number;
}

/** Deflections, rad. */
export interface Surfaces {
  aileron: number;
  elevator: number;
  rudder: number;
}

/** Full travel of the stick takes this time, s; that of the throttle longer. */
const STICK_TIME = 0.25;
const THROTTLE_TIME = 2;
const MAX_BANK = 0.7;
const MAX_PITCH = 0.35;
/** Below this height, m, the nose is raised to this pitch at most, rad. */
const LOW = 8;
const LOW_PITCH = 0.18;
/** Change of the held pitch with the stick fully pulled, rad/s. */
const PITCH_RATE = 0.2;
/** Angle of attack beyond which the assistant lowers the nose, rad: the stall is at 0.28. */
const SAFE_ATTACK = 0.21;

export function createPilotState(throttle: number): PilotState {
  return { roll: 0, pull: 0, pedal: 0, throttle, brake: 0, targetPitch: 0, hold: createAltitudeHold() };
}

/** Moves levers and control surfaces by one step. */
export function movePilot(
  state: PilotState,
  inputs: Readonly<Inputs>,
  attitude: Readonly<Attitude>,
  assist: boolean,
  ground: Readonly<GroundState>,
  dt: number,
  out: Surfaces,
): void {
  state.roll = towards(state.roll, inputs.roll, dt / STICK_TIME);
  state.pull = towards(state.pull, inputs.pull, dt / STICK_TIME);
  state.pedal = towards(state.pedal, inputs.rudder, dt / STICK_TIME);
  state.brake = towards(state.brake, inputs.brake, dt / STICK_TIME);
  state.throttle = clamp(state.throttle + (inputs.throttle * dt) / THROTTLE_TIME, 0, 1);
  if (assist || state.hold.isOn) holdAttitude(state, attitude, ground, dt, out);
  else {
    out.aileron = AIRCRAFT.aileron * state.roll;
    out.elevator = AIRCRAFT.elevator * state.pull;
    out.rudder = AIRCRAFT.rudder * state.pedal;
  }
}

/** The stick sets the bank and changes the pitch that is held; the rudder keeps the nose in the air that comes. */
function holdAttitude(
  state: PilotState,
  { pitch, bank, rollRate, pitchRate, yawRate, airspeed, sideslip, attack }: Readonly<Attitude>,
  { onGround, height, altitude, climb }: Readonly<GroundState>,
  dt: number,
  out: Surfaces,
): void {
  // Near the ground the tail must not strike it.
  const highest = height < LOW ? LOW_PITCH : MAX_PITCH;
  const isHolding = state.hold.isOn && !onGround;
  if (isHolding) state.targetPitch = pitchToHold(state.hold, state.pull, altitude, climb, dt);
  else if (onGround && state.pull <= 0.05) state.targetPitch = pitch;
  else state.targetPitch = clamp(state.targetPitch + PITCH_RATE * state.pull * dt, -MAX_PITCH, highest);
  // Control surfaces push with the square of the speed.
  const gain = clamp((35 / Math.max(airspeed, 10)) * (35 / Math.max(airspeed, 10)), 0.3, 3);
  const roll = 1.1 * (MAX_BANK * state.roll - bank) - 0.5 * rollRate;
  out.aileron = AIRCRAFT.aileron * clamp(onGround ? state.roll : gain * roll, -1, 1);
  // In a turn the nose has to be pulled round: more lift carries the weight of a banked aeroplane.
  const turn = 0.25 * Math.min(1, bank * bank);
  const protect = -5 * Math.max(0, attack - SAFE_ATTACK);
  const stick = isHolding ? 0 : 0.35 * state.pull;
  const hold = gain * (2.6 * (state.targetPitch - pitch) - 1.1 * pitchRate) + turn + stick + protect;
  const rotate = Math.min(state.pull, gain * (4 * (LOW_PITCH - pitch) - 2 * pitchRate));
  out.elevator = AIRCRAFT.elevator * clamp(onGround ? rotate : hold, -1, 1);
  const follow = onGround ? -0.6 * yawRate : 0.8 * sideslip - 0.3 * yawRate;
  out.rudder = AIRCRAFT.rudder * clamp(state.pedal + (onGround ? state.roll * 0.4 : 0) + follow, -1, 1);
}

export function clamp(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, value));
}

function towards(value: number, target: number, by: number): number {
  return value + clamp(target - value, -by, by);
}
