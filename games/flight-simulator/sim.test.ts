// The physics of the flight, without its picture. Figures are those of the curves in aircraft.ts.
import { restore, snapshot, stateHash, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { AIR_DENSITY, AIRCRAFT, INCIDENCE, MAX_LIFT, stallSpeed } from './aircraft.ts';
import { RING_RADIUS, RINGS } from './course.ts';
import { landingScore } from './referee.ts';
import { objective, reasonOf } from './sentences.ts';
import { createFlight, type Flight, type FlightValues } from './sim.ts';
import { groundHeight, isOnRunway, RUNWAY } from './terrain.ts';

const GRAVITY = 9.80665;
const VALUES: FlightValues = { mission: 'circuit', assist: true, inverted: false, crosswind: 0, turbulence: 0 };

const flightOf = (values: Partial<FlightValues> = {}) => createFlight({ values: { ...VALUES, ...values }, seed: 1 });

function fly(flight: Flight, seconds: number, each?: (time: number) => void): Flight {
  for (let t = 0; t < seconds; t += flight.dt) {
    each?.(t);
    step(flight.world, flight.dt);
  }
  return flight;
}

/** A flight high above the runway, without the assistant. */
function aloft(speed: number, throttle: number): Flight {
  const flight = flightOf({ mission: 'landing', assist: false });
  flight.world.components.Position.y[flight.plane] = 3000;
  flight.world.components.Velocity.x[flight.plane] = speed;
  flight.pilot.throttle = throttle;
  return flight;
}

/** The mean of a value over some seconds, which the slow exchange of height and speed leaves out. */
function mean(flight: Flight, seconds: number, read: () => number): number {
  let [sum, count] = [0, 0];
  fly(flight, seconds, () => {
    sum += read();
    count++;
  });
  return sum / count;
}

describe('the aeroplane', () => {
  it('rests on its wheels: the springs carry the weight, and nothing creeps', () => {
    const flight = flightOf();
    fly(flight, 5);
    const { Position, Velocity } = flight.world.components;
    const before = Position.x[flight.plane];
    expect(flight.log.onGround).toBe(true);
    fly(flight, 10);
    expect(Math.abs(Position.x[flight.plane] - before)).toBeLessThan(0.01);
    expect(Math.abs(Velocity.y[flight.plane])).toBeLessThan(1e-3);
    expect(flight.attitude.bank).toBeCloseTo(0, 6);
  });

  it('glides at the ratio of lift to drag, at the speed at which the wing carries the weight', () => {
    const flight = aloft(43, 0);
    fly(flight, 120);
    const [down, speed, attack] = [
      mean(flight, 36, () => -flight.climb),
      mean(flight, 36, () => flight.attitude.airspeed),
      mean(flight, 36, () => flight.attitude.attack),
    ];
    // Lift of the wing and of the tail, which adds some percent; the drag of both and of the hull.
    const pressure = (AIR_DENSITY * speed * speed) / 2;
    const wingLift = 4.8 * attack;
    expect((AIRCRAFT.mass * GRAVITY) / (pressure * AIRCRAFT.wingArea * wingLift)).toBeGreaterThan(0.95);
    expect((AIRCRAFT.mass * GRAVITY) / (pressure * AIRCRAFT.wingArea * wingLift)).toBeLessThan(1.1);
    const aspect = AIRCRAFT.span ** 2 / AIRCRAFT.wingArea;
    const drag =
      0.012 + wingLift ** 2 / (Math.PI * 0.8 * aspect) + (2 * AIRCRAFT.parasite) / (AIR_DENSITY * AIRCRAFT.wingArea);
    const glide = wingLift / drag;
    // Tail and fin add their profile drag, (3.4 + 1.8)/16.2 of 0.012: a tenth of the whole at most.
    expect(speed / down / glide).toBeGreaterThan(0.85);
    expect(speed / down / glide).toBeLessThan(1.03);
  });

  it('flies level without hands, and exchanges height and speed with the period of Lanchester, π√2 v/g', () => {
    const flight = aloft(48, 0.7);
    const times: number[] = [];
    let before = flight.climb;
    fly(flight, 120, (t) => {
      if (before < 0 && flight.climb >= 0) times.push(t);
      before = flight.climb;
    });
    const speed = mean(flight, 30, () => flight.attitude.airspeed);
    const period = (times[3] - times[1]) / 2;
    // Lanchester leaves out drag and the inertia in pitch, which lengthen it by up to a third.
    const lanchester = (Math.PI * Math.SQRT2 * speed) / GRAVITY;
    expect(period / lanchester).toBeGreaterThan(0.95);
    expect(period / lanchester).toBeLessThan(1.35);
    expect(flight.attitude.bank).toBeCloseTo(0, 2);
  });

  it('stalls at √(2 m g/(ρ A C_Lmax)): slower, it sinks whatever the elevator', () => {
    expect(stallSpeed()).toBeCloseTo(
      Math.sqrt((2 * 1040 * GRAVITY) / (AIR_DENSITY * AIRCRAFT.wingArea * MAX_LIFT)),
      10,
    );
    const flight = aloft(40, 0);
    let slowest = Number.POSITIVE_INFINITY;
    // The stick comes back slowly, so that the aeroplane is in balance until the wing gives way.
    fly(flight, 60, (t) => {
      if (flight.climb > -4) slowest = Math.min(slowest, flight.attitude.airspeed);
      flight.stick(0, -Math.min(1, t / 40));
    });
    expect(slowest / stallSpeed()).toBeGreaterThan(0.85);
    expect(slowest / stallSpeed()).toBeLessThan(1.1);
  });

  it('spins with full elevator and rudder, by autorotation, and recovers when both are let go', () => {
    const flight = aloft(32, 0);
    flight.press('down', true);
    fly(flight, 3);
    flight.press('rudderRight', true);
    let turned = 0;
    fly(flight, 12, () => {
      turned += Math.abs(flight.attitude.rollRate) * flight.dt;
    });
    expect(turned).toBeGreaterThan(2 * Math.PI);
    expect(flight.climb).toBeLessThan(-15);
    flight.press('down', false);
    flight.press('rudderRight', false);
    fly(flight, 12);
    expect(Math.abs(flight.attitude.rollRate)).toBeLessThan(0.1);
    expect(flight.attitude.attack).toBeLessThan(0.2);
  });

  it('turns to where it banks', () => {
    const flight = flightOf({ mission: 'landing' });
    const before = flight.attitude.heading;
    flight.stick(-1, 0);
    fly(flight, 6);
    expect(flight.attitude.bank).toBeLessThan(-0.4);
    expect(flight.attitude.heading).toBeLessThan(before - 0.5);
  });
});

describe('a flight', () => {
  /** Full throttle, and the stick back when it is fast enough. */
  function takeOff(flight: Flight): Flight {
    flight.press('more', true);
    return fly(flight, 45, () => {
      flight.stick(0, flight.attitude.airspeed > 1.1 * stallSpeed() && flight.attitude.pitch < 0.1 ? -0.6 : 0);
    });
  }

  it('takes off within the runway and climbs', () => {
    const flight = takeOff(flightOf());
    expect(flight.log.phase).toBe('flying');
    expect(flight.log.hasFlown).toBe(true);
    expect(flight.height).toBeGreaterThan(40);
    expect(objective(flight)).toContain('ring');
  });

  it('does not creep or leave its course on the ground with a crosswind', () => {
    const flight = takeOff(flightOf({ crosswind: 4 }));
    expect(flight.log.phase).toBe('flying');
    expect(flight.log.hasFlown).toBe(true);
  });

  it('lands by itself when somebody holds the path, and gets points for it', () => {
    const flight = flightOf({ mission: 'landing' });
    const { Position: p } = flight.world.components;
    fly(flight, 150, () => {
      if (flight.log.phase !== 'flying') return;
      const { x, z } = { x: p.x[flight.plane], z: p.z[flight.plane] };
      const height = flight.height;
      // A path of four degrees to the first third of the runway, and a flare.
      const wanted =
        height > 6 ? -Math.min(4, Math.max(0, (height / Math.max(50, -150 - x)) * 36)) : -0.35 - height * 0.25;
      const pull = Math.max(-0.5, Math.min(0.7, 0.5 * (wanted - flight.climb)));
      const bank = Math.max(-0.5, Math.min(0.5, -0.02 * z - 2.2 * (flight.attitude.heading - Math.PI / 2)));
      flight.stick(flight.log.onGround ? 0 : bank, -pull);
      const speed = height > 6 ? 36 : 20;
      flight.press('more', flight.attitude.airspeed < speed - 1);
      flight.press('less', flight.attitude.airspeed > speed || flight.log.onGround);
      flight.press('brake', flight.log.onGround);
    });
    expect(reasonOf(flight.log)).toContain('points');
    expect(flight.log.phase).toBe('landed');
    expect(isOnRunway(p.x[flight.plane], p.z[flight.plane])).toBe(true);
    expect(flight.log.score).toBeGreaterThan(200);
  });

  it.each(['less', 'brake'] as const)('gives nothing to who only holds one key: %s', (key) => {
    const flight = flightOf({ mission: 'landing' });
    fly(flight, 150, () => flight.press(key, true));
    expect(flight.log).toMatchObject({ phase: 'landed', isOnRunway: false, score: 0 });
  });

  it('ends with a reason in words', () => {
    const flight = flightOf({ mission: 'landing' });
    flight.stick(0, 1);
    fly(flight, 30);
    expect(flight.log.phase).toBe('crashed');
    expect(reasonOf(flight.log)).toMatch(/^You dived into the ground at \d+ m\/s/);
  });

  it('comes back by a snapshot to the same bits, pilot and judge included', () => {
    const flight = takeOff(flightOf({ turbulence: 2 }));
    const saved = snapshot(flight.world);
    const after = () => {
      flight.stick(0.3, 0);
      fly(flight, 10);
      return [stateHash(flight.world), { ...flight.log }, { ...flight.pilot }];
    };
    const first = after();
    restore(flight.world, saved);
    expect(after()).toEqual(first);
  });
});

describe('the course', () => {
  it('has rings well above the ground', () => {
    for (const { at } of RINGS) expect(at.y - groundHeight(at.x, at.z)).toBeGreaterThan(RING_RADIUS + 20);
  });

  it('lies in level ground at the runway', () => {
    for (let x = -RUNWAY.length / 2; x <= RUNWAY.length / 2; x += 50) expect(groundHeight(x, 0)).toBe(0);
  });

  it('gives most points to a soft landing on the centre line', () => {
    const x = 250 - RUNWAY.length / 2;
    expect(landingScore(0.4, x, 0, 0)).toBe(500);
    expect(landingScore(2, x, 0, 0)).toBeLessThan(400);
    expect(landingScore(0.4, x, 12, 0)).toBeLessThan(480);
    expect(landingScore(0.4, x, 0, 2)).toBe(420);
    expect(landingScore(0.4, x, 200, 0)).toBe(0);
    expect(INCIDENCE).toBeGreaterThan(0);
  });
});
