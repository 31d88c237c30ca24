/**
 * Where the moons of Galilei and Titan are, on circles with their mean motions.
 *
 *   r = a (cos u o + sin u (p × o)),  u = L₀ + n d − Ω        o = (cos Ω, sin Ω, 0) = z × p/|z × p|
 *
 *   a  distance, km    L₀  mean longitude at J2000    n  ° a day    d  days since J2000    p  pole of the orbit    z  of the ecliptic
 *
 * Mean longitudes: E2x3 of Lieske, Astron. Astrophys. 56, 333 (1977), and for Titan Dourneau, Astron. Astrophys. 267, 292 (1993),
 * both as in Meeus, Astronomical Algorithms, chapters 44 and 46, moved by 0.698° from the equinox of 1950 to that of 2000. Poles:
 * Archinal et al., Celest. Mech. Dyn. Astr. 130:22 (2018), since the moons turn about the poles of their orbits to 0.5°. Left out
 * are ellipses and perturbations: 0.5°, 1.1°, 0.2° and 0.9° from Io to Callisto, and 3.4° for Titan. Distances and radii: JPL,
 * Planetary Satellite Mean Elements and Physical Parameters.
 */
import { cross, scaled, sum, unit, type Vector, vector } from './vectors.ts';

const DEGREE = Math.PI / 180;
/** Of the ecliptic of J2000, rad. */
const OBLIQUITY = 23.4392911 * DEGREE;

export interface LargeMoon {
  readonly planet: 'jupiter' | 'saturn';
  readonly color: string;
  /** km */
  readonly distance: number;
  readonly radius: number;
  /** Right ascension and declination of the pole, and mean longitude at J2000, degrees. */
  readonly pole: readonly [rightAscension: number, declination: number];
  readonly longitude: number;
  /** Degrees a day. */
  readonly rate: number;
}

const moon = (
  planet: LargeMoon['planet'],
  color: string,
  distance: number,
  radius: number,
  pole: LargeMoon['pole'],
  longitude: number,
  rate: number,
): LargeMoon => ({ planet, color, distance, radius, pole, longitude, rate });

export const LARGE_MOONS = {
  io: moon('jupiter', '#f2e08a', 421_800, 1821.5, [268.05, 64.5], 18.1583, 203.48895579),
  europa: moon('jupiter', '#e6d9c4', 671_100, 1560.8, [268.08, 64.51], 212.7654, 101.374724735),
  ganymede: moon('jupiter', '#b8ab9c', 1_070_400, 2631.2, [268.2, 64.57], 220.069, 50.317609207),
  callisto: moon('jupiter', '#8f8479', 1_882_700, 2410.3, [268.72, 64.83], 79.1606, 21.571071177),
  titan: moon('saturn', '#e8b765', 1_221_900, 2574.8, [39.4827, 83.4279], 137.1237, 22.57697855),
} as const satisfies Readonly<Record<string, LargeMoon>>;

export type MoonName = keyof typeof LARGE_MOONS;
export const MOON_NAMES = Object.keys(LARGE_MOONS) as MoonName[];

/** From the planet to the moon, km, in the axes of the ecliptic of J2000. @param days since J2000 */
export function moonOffset({ pole, longitude, rate, distance }: LargeMoon, days: number): Vector {
  const [ascension, declination] = [pole[0] * DEGREE, pole[1] * DEGREE];
  const [y, z] = [Math.cos(declination) * Math.sin(ascension), Math.sin(declination)];
  const [cos, sin] = [Math.cos(OBLIQUITY), Math.sin(OBLIQUITY)];
  const north = vector(Math.cos(declination) * Math.cos(ascension), cos * y + sin * z, cos * z - sin * y);
  const node = unit(vector(-north.y, north.x, 0));
  // Whole turns first: the angle has ten digits after a century.
  const along = ((longitude + rate * days) % 360) * DEGREE - Math.atan2(node.y, node.x);
  return sum(scaled(node, distance * Math.cos(along)), cross(north, node), distance * Math.sin(along));
}
