// The large moons against their periods, Kepler's third law, another theory, and what Hubble saw.
import { SOLAR_STATES } from '@principia/scenes';
import { describe, expect, it } from 'vitest';
import { LARGE_MOONS, MOON_NAMES, moonOffset } from './large-moons.ts';
import { cross, dot, lengthOf, unit } from './vectors.ts';

const DEGREE = 180 / Math.PI;
const DAY = 86_400;
/** The difference of two angles, degrees, from −180 to 180. */
const apart = (a: number, b: number) => ((((a - b) % 360) + 540) % 360) - 180;

/** Days, as published by JPL. */
const PERIODS = { io: 1.769, europa: 3.551, ganymede: 7.155, callisto: 16.689, titan: 15.945 };

describe.each(MOON_NAMES)('%s', (name) => {
  const moon = LARGE_MOONS[name];

  it('comes back to its place after its period, and is opposite after half of it', () => {
    const period = 360 / moon.rate;
    expect(Math.abs(period - PERIODS[name])).toBeLessThan(0.001);
    const [start, half, whole] = [0, 0.5, 1].map((part) => moonOffset(moon, 4000 + part * period));
    expect(dot(unit(start), unit(whole))).toBeCloseTo(1, 9);
    expect(dot(unit(start), unit(half))).toBeCloseTo(-1, 9);
    expect(lengthOf(start)).toBeCloseTo(moon.distance, 3);
  });

  it('obeys Kepler’s third law about its planet', () => {
    // The flattening of Jupiter changes the motion of Io by (3/4) J₂ (R/a)² = 0.03 %; the planet's GM holds its moons', 0.02 %.
    const motion = moon.rate / DEGREE / DAY;
    const law = motion ** 2 * moon.distance ** 3;
    expect(law / SOLAR_STATES[moon.planet].gm).toBeCloseTo(1, 2);
  });

  it('turns eastwards, as its planet does about the Sun', () => {
    const [now, later] = [moonOffset(moon, 10), moonOffset(moon, 10.1)];
    expect(cross(now, later).z).toBeGreaterThan(0);
  });
});

describe('directions', () => {
  it('are opposite to the prime meridians, which face the planets', () => {
    // W at J2000 of the report on rotational elements 2015. Meridians are fixed to craters, whose longitudes count from the
    // mean planet to 2.5°.
    const meridians = { io: 200.39, europa: 36.022, ganymede: 44.064, callisto: 259.51, titan: 186.5855 };
    for (const name of MOON_NAMES) {
      const [ascension, declination] = LARGE_MOONS[name].pole.map((angle) => angle / DEGREE);
      const turned = meridians[name] / DEGREE;
      const [c, s] = [Math.cos(turned), Math.sin(turned)];
      const x = -c * Math.sin(ascension) - s * Math.sin(declination) * Math.cos(ascension);
      const y = c * Math.cos(ascension) - s * Math.sin(declination) * Math.sin(ascension);
      const z = s * Math.cos(declination);
      const [cos, sin] = [Math.cos(23.4392911 / DEGREE), Math.sin(23.4392911 / DEGREE)];
      const facing = { x, y: cos * y + sin * z, z: cos * z - sin * y };
      const angle = Math.acos(-dot(unit(moonOffset(LARGE_MOONS[name], 0)), facing)) * DEGREE;
      expect(angle, name).toBeLessThan(2.5);
    }
  });

  it('of the inner three librate about Laplace’s relation, L₁ − 3 L₂ + 2 L₃ = 180°', () => {
    const { io, europa, ganymede } = LARGE_MOONS;
    for (const days of [-10_000, 0, 20_000]) {
      const [first, second, third] = [io, europa, ganymede].map(({ longitude, rate }) => longitude + rate * days);
      // Four digits of the longitudes, and the rates' ten.
      expect(Math.abs(apart(first - 3 * second + 2 * third, 180))).toBeLessThan(0.001);
    }
  });

  it('of Titan is before Saturn when it crossed its disc under the eyes of Hubble', () => {
    // 24 February 2009, about 14:00: Saturn stood at right ascension 11 h 24 min, declination 6°, two weeks before opposition.
    // Titan is on the line to the Earth, that is opposite to Saturn; its eccentricity moves it by up to 3.3°, an hour by 0.9°.
    const days = 2_454_887.08 - 2_451_545;
    const { x, y } = moonOffset(LARGE_MOONS.titan, days);
    const [ascension, declination, tilt] = [171, 6, 23.44].map((angle) => angle / DEGREE);
    const saturn = {
      x: Math.cos(declination) * Math.cos(ascension),
      y: Math.cos(tilt) * Math.cos(declination) * Math.sin(ascension) + Math.sin(tilt) * Math.sin(declination),
    };
    expect(Math.abs(apart(Math.atan2(y, x) * DEGREE, Math.atan2(-saturn.y, -saturn.x) * DEGREE))).toBeLessThan(6);
  });
});
