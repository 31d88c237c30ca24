/**
 * Air that has a memory: how far the flow is attached to each panel of the wing, and the wash of the propeller.
 *
 *   τ₁ dx/dt + x = x₀(α − τ₂ dα/dt)        τ₁ = 0.5 c/V, τ₂ = 4.5 c/V
 *   v_i = −V/2 + √(V²/4 + T/(2 ρ A))        wash 2 v_i, radius R √((V + v_i)/(V + 2 v_i))
 *
 *   x  attached part of the chord, 1 without and 0 with full separation    x₀  that of steady flow    c  chord, m
 *   V  speed, m/s    v_i  velocity induced in the disc of the propeller, m/s    T  thrust, N    A  area of the disc, m²
 *
 * Separation: Goman and Khrabrov, J. Aircraft 31, 1109 (1994); the lags are of the order that fits of the model find. The
 * wing stalls later when the nose goes up quickly, and its flow comes back later when the nose goes down: hysteresis. The
 * wash is that of momentum theory, far behind the disc, without swirl: Glauert, in Durand, Aerodynamic Theory IV (1935).
 */
import { atan2, columnsOf, exp, keepState, type PhysicsWorld } from '@principia/physics';
import { AIR_DENSITY, AIRCRAFT, Deflections, Flow, INCIDENCE, PANELS, STALL, steadyAttachment } from './aircraft.ts';
import { type Axes, rotated } from './body-frame.ts';

const CHORD = AIRCRAFT.wingArea / AIRCRAFT.span;
const [RELAXATION, DELAY] = [0.5, 4.5];
/** The model is one of small changes: a delay is no larger than this, rad. */
const MAX_DELAY = STALL;
/** Below this speed, m/s, the chord's time is so long that the wing would remember the last landing. */
const SLOWEST = 8;
const DISC = Math.PI * AIRCRAFT.propellerRadius * AIRCRAFT.propellerRadius;

/** The attached part after a step. @param rate dα/dt, rad/s @param chordTime c/V, s */
export function relaxed(attached: number, attack: number, rate: number, chordTime: number, dt: number): number {
  const delay = Math.min(MAX_DELAY, Math.max(-MAX_DELAY, DELAY * chordTime * rate));
  const steady = steadyAttachment(attack - delay);
  // Exact for an x₀ that is constant within the step.
  return steady + (attached - steady) * exp(-dt / (RELAXATION * chordTime));
}

/** Velocity that a propeller induces in its disc, m/s. */
export function inducedVelocity(thrust: number, speed: number): number {
  const half = Math.max(0, speed) / 2;
  return Math.sqrt(half * half + Math.max(0, thrust) / (2 * AIR_DENSITY * DISC)) - half;
}

/** Radius of the wash far behind the disc, m: the same air passes both. */
export function washRadius(induced: number, speed: number): number {
  const through = Math.max(0, speed) + induced;
  return through <= 0 ? AIRCRAFT.propellerRadius : AIRCRAFT.propellerRadius * Math.sqrt(through / (through + induced));
}

export interface FlowOptions {
  /** Whether separation lags; else the flow is always steady. */
  readonly isUnsteady: boolean;
  readonly hasWash: boolean;
}

const ATTACHED = ['panel0', 'panel1', 'panel2', 'panel3'] as const;

/** The state of the air about one aeroplane. */
export class Airflow {
  readonly #world: PhysicsWorld;
  readonly #plane: number;
  /** Attached part and last angle of attack of each panel; NaN before the first step. */
  readonly #state = new Float64Array(2 * PANELS.length).fill(Number.NaN);
  readonly #air = { x: 0, y: 0, z: 0 };
  readonly #spin = { x: 0, y: 0, z: 0 };

  constructor(world: PhysicsWorld, plane: number) {
    this.#world = world;
    this.#plane = plane;
    keepState(world, this.#state);
  }

  /** Attached part of the wing, its mean. */
  get attached(): number {
    const state = this.#state;
    let sum = 0;
    for (let i = 0; i < PANELS.length; i++) sum += state[2 * i];
    return sum / PANELS.length;
  }

  /** Moves the state by one step and writes it to the component. @param roll rate at which the air rolls, rad/s */
  update(wind: Readonly<Axes>, roll: number, thrust: number, { isUnsteady, hasWash }: FlowOptions, dt: number): void {
    this.#look(wind);
    this.#spin.x -= roll;
    const flow = columnsOf(this.#world, Flow);
    const [plane, state] = [this.#plane, this.#state];
    flow.roll[plane] = roll;
    for (let i = 0; i < PANELS.length; i++) {
      this.#updatePanel(i, isUnsteady, dt);
      flow[ATTACHED[i]][plane] = state[2 * i];
    }
    const forwards = this.#air.x;
    const induced = hasWash ? inducedVelocity(thrust, forwards) : 0;
    flow.wash[plane] = 2 * induced;
    flow.washRadius[plane] = washRadius(induced, forwards);
  }

  /** Velocity through the air and rate of rotation in the body's axes. */
  #look(wind: Readonly<Axes>): void {
    const { Velocity: v, AngularVelocity: w } = this.#world.components;
    const plane = this.#plane;
    for (const name of ['x', 'y', 'z'] as const) {
      rotated(this.#world, plane, UNITS[name], axis);
      this.#air[name] =
        (v.x[plane] - wind.x) * axis.x + (v.y[plane] - wind.y) * axis.y + (v.z[plane] - wind.z) * axis.z;
      this.#spin[name] = w.x[plane] * axis.x + w.y[plane] * axis.y + w.z[plane] * axis.z;
    }
  }

  #updatePanel(i: number, isUnsteady: boolean, dt: number): void {
    const { position: p, span, aileron } = PANELS[i];
    const [air, spin, state] = [this.#air, this.#spin, this.#state];
    const forwards = air.x + spin.y * p.z - spin.z * p.y;
    const up = air.y + spin.z * p.x - spin.x * p.z;
    const right = air.z + spin.x * p.y - spin.y * p.x;
    // The chord's normal is s × f, and what flows along the span makes no force.
    const across = up * span.z - right * span.y;
    const attack =
      atan2(-across, forwards) + INCIDENCE + aileron * columnsOf(this.#world, Deflections).aileron[this.#plane];
    const speed = Math.sqrt(forwards * forwards + across * across);
    const before = state[2 * i + 1];
    const isKnown = isUnsteady && speed > SLOWEST && !Number.isNaN(before);
    state[2 * i] = isKnown
      ? relaxed(state[2 * i], attack, turned(attack - before) / dt, CHORD / speed, dt)
      : steadyAttachment(speed > SLOWEST ? attack : 0);
    state[2 * i + 1] = attack;
  }
}

/** A difference of angles across the cut at ±π. */
function turned(angle: number): number {
  if (angle > Math.PI) return angle - 2 * Math.PI;
  return angle < -Math.PI ? angle + 2 * Math.PI : angle;
}

const UNITS = { x: { x: 1, y: 0, z: 0 }, y: { x: 0, y: 1, z: 0 }, z: { x: 0, y: 0, z: 1 } };
const axis = { x: 0, y: 0, z: 0 };
