// The memory of the flow, and the wash of the propeller, against their formulas.
import { columnsOf, createPhysicsWorld, spawn, step } from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, it } from 'vitest';
import {
  AIR_DENSITY,
  AIRCRAFT,
  Deflections,
  Flow,
  INCIDENCE,
  STALL,
  steadyAttachment,
  WING_DRAG,
  WING_LIFT,
} from './aircraft.ts';
import { inducedVelocity, relaxed, washRadius } from './airflow.ts';
import { aircraftForces } from './wing-laws.ts';

const DEGREE = Math.PI / 180;
const SPEED = 40;

type FlowValues = Partial<Record<'panel0' | 'panel1' | 'panel2' | 'panel3' | 'wash' | 'washRadius' | 'roll', number>>;

/** The force on the aeroplane, N, and the torque, N m, at an attitude in a wind from ahead, without weight and hull. */
function loadsAt(attack: number, flow: FlowValues, { speed = SPEED, elevator = 0, rolling = 0 } = {}) {
  const forces = aircraftForces({}).slice(3);
  const world = createPhysicsWorld({ dimensions: 3, capacity: 2, components: [Deflections, Flow], forces });
  // As heavy as a ship, and turning as slowly: within one short step nothing changes.
  const mass = 1e9;
  const body = spawn(world, {
    position: {},
    velocity: { x: speed * Math.cos(attack), y: -speed * Math.sin(attack) },
    mass,
    inertiaTensor: { x: mass, y: mass, z: mass },
    orientation: {},
    angularVelocity: { x: rolling },
  });
  addComponent(world, body, set(columnsOf(world, Deflections), { elevator }));
  addComponent(world, body, set(columnsOf(world, Flow), flow));
  const { Velocity, AngularVelocity } = world.components;
  const [x, y] = [Velocity.x[body], Velocity.y[body]];
  step(world, 1);
  return {
    x: mass * (Velocity.x[body] - x),
    y: mass * (Velocity.y[body] - y),
    pitching: mass * AngularVelocity.z[body],
    rolling: mass * (AngularVelocity.x[body] - rolling),
  };
}

/** Lift and drag coefficients of the wing alone: what panels that are attached as given add to a separated one. */
function coefficients(alpha: number, attached: number) {
  const attack = alpha - INCIDENCE;
  const flow = { panel0: attached, panel1: attached, panel2: attached, panel3: attached, wash: 0, washRadius: 0 };
  const loads = loadsAt(attack, flow);
  const scale = 0.5 * AIR_DENSITY * SPEED * SPEED * AIRCRAFT.wingArea;
  return {
    lift: (loads.y * Math.cos(attack) + loads.x * Math.sin(attack)) / scale,
    drag: (loads.y * Math.sin(attack) - loads.x * Math.cos(attack)) / scale,
  };
}

const curveAt = (curve: [number, number][], x: number) => {
  const i = curve.findIndex((point) => point[0] >= x);
  const [[a, b], [c, d]] = [curve[i - 1], curve[i]];
  return b + ((d - b) * (x - a)) / (c - a);
};

describe('separation of the flow', () => {
  it('gives the steady curves where it is steady', () => {
    // The tail adds its own, which does not depend on the wing: differences are the wing's.
    const zero = coefficients(2 * DEGREE, 1);
    for (const degrees of [8, 16]) {
      const alpha = degrees * DEGREE;
      const attached = steadyAttachment(alpha);
      const { lift } = coefficients(alpha, attached);
      const grown = curveAt(WING_LIFT, alpha) - curveAt(WING_LIFT, 2 * DEGREE);
      // The tail of 3.4 m² has a slope of 2.6 against 4.8: an eighth of the wing's lift at most; dihedral costs 0.1 %.
      expect((lift - zero.lift) / grown).toBeGreaterThan(0.99);
      expect((lift - zero.lift) / grown).toBeLessThan(1.13);
    }
    expect(steadyAttachment(STALL)).toBe(1);
    expect(steadyAttachment(-40 * DEGREE)).toBe(0);
    // Between attached and separated at one angle only the wing differs, by Kirchhoff's share.
    for (const degrees of [22, 35]) {
      const alpha = degrees * DEGREE;
      const steady = coefficients(alpha, steadyAttachment(alpha));
      const apart = coefficients(alpha, 0);
      const whole = coefficients(alpha, 1);
      const share = ((1 + Math.sqrt(steadyAttachment(alpha))) ** 2 - 1) / 3;
      // Within the step of 1 s the body gains 1e-5 of its speed and of a radian a second.
      expect(steady.lift).toBeCloseTo(apart.lift + share * (whole.lift - apart.lift), 5);
      expect(steady.drag).toBeCloseTo(apart.drag + share * (whole.drag - apart.drag), 5);
    }
    const partly = 22 * DEGREE;
    const tailAndFin = (alpha: number) => coefficients(alpha, 1).lift - 4.8 * Math.min(alpha, 30 * DEGREE);
    const atStall = coefficients(partly, steadyAttachment(partly));
    // The two outer panels are tilted by 2.5°, which the rest of the lift shows as 0.1 % of 1.8.
    expect(Math.abs(atStall.lift - tailAndFin(partly) - curveAt(WING_LIFT, partly))).toBeLessThan(0.004);
    expect(curveAt(WING_DRAG, partly)).toBeCloseTo(0.28, 12);
  });

  it('relaxes within half a chord, whatever the step, and waits four and a half chords', () => {
    const chordTime = 0.04;
    const after = (steps: number) => {
      let x = 1;
      for (let i = 0; i < steps; i++) x = relaxed(x, 40 * DEGREE, 0, chordTime, (0.5 * chordTime) / steps);
      return x;
    };
    for (const steps of [1, 7, 100]) expect(after(steps)).toBeCloseTo(Math.exp(-1), 12);
    // A nose that rises at a steady rate: steady flow would separate from the stall's angle on.
    const rate = 0.4;
    expect(relaxed(1, STALL + 0.99 * 4.5 * chordTime * rate, rate, chordTime, 1e-3)).toBe(1);
    expect(relaxed(1, STALL + 1.01 * 4.5 * chordTime * rate, rate, chordTime, 1e-3)).toBeLessThan(1);
    // And on the way down the flow comes back later than it went.
    expect(relaxed(1, STALL - 0.99 * 4.5 * chordTime * rate, -rate, chordTime, 1e-3)).toBeLessThan(1);
  });

  it('runs through a loop when the angle swings, which closes as the swing slows down', () => {
    const loop = (period: number) => {
      const [chordTime, dt] = [0.04, period / 4000];
      let [x, area] = [1, 0];
      for (let i = 0; i < 8000; i++) {
        const phase = (2 * Math.PI * i) / 4000;
        const alpha = (18 + 8 * Math.sin(phase)) * DEGREE;
        const rate = ((2 * Math.PI) / period) * 8 * DEGREE * Math.cos(phase);
        x = relaxed(x, alpha, rate, chordTime, dt);
        if (i >= 4000) area += x * rate * dt;
      }
      return area;
    };
    // More is attached on the way up; the delay of both branches is that of the rate, so the area goes as 1/period.
    expect(loop(4)).toBeGreaterThan(0);
    expect(loop(4) / loop(40)).toBeGreaterThan(7);
    expect(loop(40) / loop(400)).toBeGreaterThan(9);
    expect(loop(40) / loop(400)).toBeLessThan(11);
  });
});

describe('air that rolls', () => {
  const attached = { panel0: 1, panel1: 1, panel2: 1, panel3: 1 };

  it('turns the wing as the aeroplane’s own roll damps it: only their difference counts', () => {
    const [rate, attack] = [0.2, 2 * DEGREE];
    const pushed = loadsAt(attack, { ...attached, roll: rate }).rolling;
    // The tail is damped by the aeroplane's own roll too, but the air rolls over the span of the wing alone.
    const damped = loadsAt(attack, attached, { rolling: rate }).rolling;
    const together = loadsAt(attack, { ...attached, roll: rate }, { rolling: rate }).rolling;
    expect(pushed).toBeGreaterThan(1000);
    expect(Math.abs(pushed + damped)).toBeLessThan(0.05 * pushed);
    expect(Math.abs(together)).toBeLessThan(0.05 * pushed);
    // Strips: L = ½ ρ V (dC_L/dα) A/4 Σ z² p.
    const { wingArea } = AIRCRAFT;
    const strips = 0.5 * AIR_DENSITY * SPEED * 4.8 * (wingArea / 4) * 2 * (4.1 ** 2 + 1.4 ** 2) * rate;
    expect(pushed / strips).toBeGreaterThan(0.95);
    expect(pushed / strips).toBeLessThan(1.05);
  });
});

describe('the wash of the propeller', () => {
  it('satisfies momentum theory: T = 2 ρ A v (V + v), and lets the same air through disc and wash', () => {
    const disc = Math.PI * AIRCRAFT.propellerRadius ** 2;
    for (const [thrust, speed] of [
      [3800, 0],
      [2500, 25],
      [900, 60],
    ]) {
      const v = inducedVelocity(thrust, speed);
      expect((2 * AIR_DENSITY * disc * v * (speed + v)) / thrust).toBeCloseTo(1, 12);
      const radius = washRadius(v, speed);
      expect((Math.PI * radius * radius * (speed + 2 * v)) / (disc * (speed + v))).toBeCloseTo(1, 12);
    }
    // At rest the wash shrinks to R/√2; without thrust there is none.
    expect(washRadius(inducedVelocity(3800, 0), 0)).toBeCloseTo(AIRCRAFT.propellerRadius / Math.SQRT2, 12);
    expect(inducedVelocity(0, 30)).toBe(0);
    expect(washRadius(0, 0)).toBe(AIRCRAFT.propellerRadius);
  });

  it('lets the elevator of an aeroplane at rest feel 2 v over its share of the tail', () => {
    const v = inducedVelocity(3800, 0);
    const radius = washRadius(v, 0);
    const flow = { panel0: 1, panel1: 1, panel2: 1, panel3: 1, wash: 2 * v, washRadius: radius };
    const still = loadsAt(0, flow, { speed: 0 });
    const pulled = loadsAt(0, flow, { speed: 0, elevator: 0.1 });
    // Half of the deflection turns the tail's flow, with a slope of 2.6, 4.6 m behind the centre of mass.
    const share = (2 * radius) / AIRCRAFT.tailSpan;
    const lift = 0.5 * AIR_DENSITY * 3.4 * share * (2 * v) ** 2 * 2.6 * 0.05;
    expect(still.y - pulled.y).toBeCloseTo(lift, 4);
    // The drag that lift induces acts 0.1 m above the centre: less than a hundredth.
    expect((pulled.pitching - still.pitching) / (4.6 * lift)).toBeGreaterThan(0.99);
    expect((pulled.pitching - still.pitching) / (4.6 * lift)).toBeLessThan(1.01);
    expect(loadsAt(0, { ...flow, wash: 0 }, { speed: 0, elevator: 0.1 })).toEqual({
      x: 0,
      y: 0,
      pitching: 0,
      rolling: 0,
    });
  });
});
