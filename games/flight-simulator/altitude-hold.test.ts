// The autopilot against the roots of its loop, and in the whole simulator.
import { step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { createAltitudeHold, engage, GAINS, pitchToHold } from './altitude-hold.ts';
import { createFlight, type FlightValues } from './sim.ts';

const VALUES: FlightValues = { mission: 'landing', assist: true, inverted: false, crosswind: 0, turbulence: 0 };

describe('the loop on paper', () => {
  const [speed, lag] = [45, 0.485];

  /** Altitudes of dh/dt = w, lag dw/dt = V θ − w, once a hundredth of a second. */
  function respond(target: number, seconds: number): number[] {
    const hold = createAltitudeHold();
    engage(hold, target, 0, 0);
    let [height, climb] = [0, 0];
    const dt = 1e-3;
    return Array.from({ length: Math.round(seconds / dt) }, () => {
      const pitch = pitchToHold(hold, 0, height, climb, dt);
      climb += (dt * (speed * pitch - climb)) / lag;
      height += dt * climb;
      return height;
    });
  }

  it('has roots that decay, the slowest by 0.19 a second', () => {
    const { p, i, d } = GAINS;
    const [a, b, c, e] = [lag, 1 + speed * d, speed * p, speed * i];
    // Routh: all roots of a s³ + b s² + c s + e decay where b c > a e.
    expect(b * c).toBeGreaterThan(10 * a * e);
    // Newton's third root, and the pair that is left.
    let s = -b / a;
    for (let n = 0; n < 50; n++) s -= (((a * s + b) * s + c) * s + e) / ((3 * a * s + 2 * b) * s + c);
    expect(s).toBeCloseTo(-3.5, 1);
    const [sum, product] = [-(b / a + s), -e / (a * s)];
    expect(sum / 2).toBeCloseTo(-0.19, 1);
    expect(Math.sqrt(product - (sum * sum) / 4)).toBeCloseTo(0.12, 1);
  });

  it('comes to the altitude without an error, and overshoots by less than a quarter', () => {
    const heights = respond(10, 60);
    expect(Math.max(...heights)).toBeLessThan(12.5);
    // Ten metres decay by e^(−0.19 × 60) to 0.1 mm; the pair's phase at most multiplies that by some ten.
    expect(Math.abs(heights[heights.length - 1] - 10)).toBeLessThan(0.01);
  });
});

describe('in the simulator', () => {
  function level(values: Partial<FlightValues>, seconds: number) {
    const flight = createFlight({ values: { ...VALUES, ...values }, seed: 1 });
    flight.pilot.throttle = 0.7;
    flight.world.components.Velocity.x[flight.plane] = 45;
    const errors: number[] = [];
    for (let t = 0; t < seconds; t += flight.dt) {
      step(flight.world, flight.dt);
      errors.push(flight.altitude - flight.pilot.hold.altitude);
    }
    return { flight, errors: errors.slice(errors.length / 2) };
  }

  it('holds the altitude at which it was switched on, in still air to half a metre', () => {
    const { flight, errors } = level({ altitudeHold: true }, 120);
    expect(flight.log.phase).toBe('flying');
    expect(flight.pilot.hold.altitude).toBeCloseTo(190 - 1.2, 1);
    // The speed goes on settling over minutes, and the integral follows it.
    expect(Math.max(...errors.map(Math.abs))).toBeLessThan(0.5);
    // Without the autopilot the assistant holds the pitch, and the altitude drifts.
    expect(Math.max(...level({}, 120).errors.map(Math.abs))).toBeGreaterThan(20);
  });

  it('holds it in gusts to a few metres', () => {
    const { flight, errors } = level({ altitudeHold: true, turbulence: 1.5 }, 120);
    expect(flight.log.phase).toBe('flying');
    const deviation = Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length);
    // A vertical gust of 1.5 m/s that lasts L/V = 4 s moves the aeroplane by 6 m where nothing answers.
    expect(deviation).toBeLessThan(6);
  });

  it('climbs to where the stick moves the altitude, and lets go when switched off', () => {
    const { flight } = level({ altitudeHold: true }, 20);
    const before = flight.pilot.hold.altitude;
    flight.stick(0, -1);
    for (let t = 0; t < 10; t += flight.dt) step(flight.world, flight.dt);
    flight.stick(0, 0);
    expect(flight.pilot.hold.altitude - before).toBeGreaterThan(35);
    for (let t = 0; t < 60; t += flight.dt) step(flight.world, flight.dt);
    expect(Math.abs(flight.altitude - flight.pilot.hold.altitude)).toBeLessThan(2);
    flight.set({ ...VALUES, altitudeHold: false });
    step(flight.world, flight.dt);
    expect(flight.pilot.hold.isOn).toBe(false);
  });
});
