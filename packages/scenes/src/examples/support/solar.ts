/**
 * The solar system for examples: lengths in 10⁹ m and ten days for each second of the picture, so that numbers are handy and
 * a year takes 36.5 s. Masses are G times the mass in these units.
 */
import {
  attractors,
  createPhysicsWorld,
  type Force,
  type Integrator,
  mutualGravity,
  type PhysicsWorld,
  postNewtonian,
  rgba,
  rungeKutta4,
  spawn,
} from '@principia/physics';
import { solarState } from '../../solar-system/build.ts';
import { positions2012 } from '../../solar-system/positions-2012.ts';
import { BODY_NAMES, type BodyName, SPEED_OF_LIGHT } from '../../solar-system/states.ts';
import type { Fill, Label } from '../picture.ts';
import { lengthOf, positionOf, velocityOf } from './read.ts';
import { cross, dot, type Point3, plus, times } from './space.ts';

/** Days for each second of the picture. */
export const DAYS = 10;
/** An hour, the step of the book. */
export const HOUR = 1 / (24 * DAYS);

const SECONDS = 86400 * DAYS;
/** km³/s² in the units of the picture. */
export const gmInPicture = (gm: number): number => (gm * SECONDS * SECONDS) / 1e18;
/** km/s in the units of the picture. */
export const speedInPicture = (speed: number): number => (speed * SECONDS) / 1e6;

/** The constants of the book: G, m³/(kg s²), and masses, kg. */
export const BOOK = { G: 6.67384e-11, sun: 1.9891e30, earth: 5.9736e24 } as const;

/** The inner planets in the book: mass, kg, mean distance, 10⁹ m, and mean speed, km/s. */
export const BOOK_PLANETS = {
  mercury: { mass: 3.302e23, distance: 57.91, speed: 47.87 },
  venus: { mass: 4.8685e24, distance: 108.21, speed: 35.02 },
  earth: { mass: 5.9736e24, distance: 149.6, speed: 29.78 },
  mars: { mass: 6.4185e23, distance: 227.92, speed: 24.13 },
} as const;

export type InnerPlanet = keyof typeof BOOK_PLANETS;
export const INNER_PLANETS = Object.keys(BOOK_PLANETS) as InnerPlanet[];

/** Drawn radius, 10⁹ m, and colour. */
const LOOKS: Partial<Record<BodyName, readonly [number, number]>> = {
  sun: [16, rgba(1, 0.8, 0.35)],
  mercury: [4, rgba(0.72, 0.68, 0.63)],
  venus: [6, rgba(0.95, 0.84, 0.6)],
  earth: [6, rgba(0.42, 0.7, 1)],
  mars: [5, rgba(1, 0.5, 0.35)],
};

export function appearanceOf(name: BodyName): { size: number; color: number } {
  const [size, color] = LOOKS[name] ?? [0.001, rgba(0.8, 0.8, 0.8)];
  return { size, color };
}

/** A run with a Sun that may be fixed, and bodies by name. */
export interface SolarRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly ids: Readonly<Partial<Record<BodyName, number>>>;
  /** G times the mass of the Sun. */
  readonly mu: number;
}

/** Position and velocity relative to the Sun. */
export function aboutSun({ world, ids }: SolarRun, name: BodyName): { r: Point3; v: Point3 } {
  const [id, sun] = [ids[name] as number, ids.sun as number];
  return {
    r: plus(positionOf(world, id), times(positionOf(world, sun), -1)),
    v: plus(velocityOf(world, id), times(velocityOf(world, sun), -1)),
  };
}

export const distanceFromSun = (run: SolarRun, name: BodyName): number => lengthOf(aboutSun(run, name).r);

/** Semi-major axis and eccentricity of the ellipse on which a body would stay alone with the Sun. */
export function ellipseOf(run: SolarRun, name: BodyName): { axis: number; eccentricity: number; tilt: number } {
  const { r, v } = aboutSun(run, name);
  const axis = 1 / (2 / lengthOf(r) - dot(v, v) / run.mu);
  const h = cross(r, v);
  const e = plus(times(cross(v, h), 1 / run.mu), times(r, -1 / lengthOf(r)));
  // Sine of the inclination to the ecliptic, which for these planets is nearly the angle itself.
  const tilt = Math.sqrt(h.x * h.x + h.y * h.y) / lengthOf(h);
  return { axis, eccentricity: lengthOf(e), tilt };
}

/** Period of such an ellipse, days. */
export function periodOf(run: SolarRun, name: BodyName): number {
  const { axis } = ellipseOf(run, name);
  return 2 * Math.PI * axis * Math.sqrt(axis / run.mu) * DAYS;
}

interface Start {
  readonly position: Point3;
  readonly velocity: Point3;
}

/** The planets of the book about a Sun that does not move. @param startOf position and velocity relative to the Sun */
export function fixedSun(startOf: (name: InnerPlanet) => Start, mu: number, integrator: Integrator): SolarRun {
  const forces: Force[] = [attractors(), mutualGravity({ G: 1 })];
  const world = createPhysicsWorld({ dimensions: 3, capacity: 8, forces, integrator });
  const ids: Partial<Record<BodyName, number>> = {};
  ids.sun = spawn(world, { position: {}, attractor: mu, appearance: appearanceOf('sun') });
  for (const name of INNER_PLANETS) {
    const mass = (mu * BOOK_PLANETS[name].mass) / BOOK.sun;
    ids[name] = spawn(world, { ...startOf(name), mass, appearance: appearanceOf(name) });
  }
  return { world, dt: HOUR, ids, mu };
}

/** JPL's state at the beginning of 2012, relative to the Sun. */
export function start2012(name: BodyName): Start {
  const [{ position, velocity }, sun] = [solarState(name, 2012), solarState('sun', 2012)];
  return {
    position: times(plus(position, times(sun.position, -1)), 1e-6),
    velocity: times(plus(velocity, times(sun.velocity, -1)), speedInPicture(1)),
  };
}

/** What is simulated besides Newton's gravity of Sun and planets. */
export interface System2012 {
  readonly moon?: boolean;
  readonly relativity?: boolean;
  readonly integrator?: Integrator;
}

/** Sun, planets and Pluto from JPL's states of 2012, all of which attract each other. */
export function system2012({ moon = true, relativity = true, integrator = rungeKutta4 }: System2012 = {}): SolarRun {
  const forces = [mutualGravity({ G: 1 })];
  const world = createPhysicsWorld({ dimensions: 3, capacity: 16, forces, integrator });
  const ids: Partial<Record<BodyName, number>> = {};
  for (const name of BODY_NAMES) {
    if (name === 'moon' && !moon) continue;
    const { gm, position, velocity } = solarState(name, 2012);
    ids[name] = spawn(world, {
      position: times(position, 1e-6),
      velocity: times(velocity, speedInPicture(1)),
      mass: gmInPicture(gm),
      appearance: appearanceOf(name),
    });
  }
  const mu = gmInPicture(solarState('sun', 2012).gm);
  const central = ids.sun as number;
  if (relativity) world.forces.push(postNewtonian({ central, G: 1, speedOfLight: speedInPicture(SPEED_OF_LIGHT) }));
  return { world, dt: HOUR, ids, mu };
}

/** JPL's position relative to the Sun. @param days after the beginning of 2012, a multiple of 6 up to 366 */
export function jplPlace(name: InnerPlanet, days: number): Point3 {
  const [x, y, z] = positions2012()[days / 6].positions[name];
  return { x: 1e-6 * x, y: 1e-6 * y, z: 1e-6 * z };
}

/** Distance from JPL's position, km. */
export function errorKm(run: SolarRun, name: InnerPlanet, days: number): number {
  return 1e6 * lengthOf(plus(aboutSun(run, name).r, times(jplPlace(name, days), -1)));
}

/** The region that shows the inner planets. */
const INNER_VIEW = { minX: -250, maxX: 250, minY: -250, maxY: 250, minZ: -30, maxZ: 30 } as const;
/** From the north of the ecliptic, a little from the side. */
export const INNER_CAMERA = { eye: { x: 0, y: -600, z: 800 }, target: { x: 0, y: 0, z: 0 } } as const;

/** The trails of the inner planets. */
const innerTrails = ({ ids }: SolarRun) =>
  INNER_PLANETS.map((name) => ({ body: ids[name] as number, length: 700, interval: 24 }));

/** The Sun as it shines by itself. */
const innerSun = (run: SolarRun): Fill => ({
  shape: { centre: () => positionOf(run.world, run.ids.sun as number), radius: 17 },
  color: 0xffd873,
});

/** The names of the inner planets, beside them. */
const innerLabels = ({ world, ids }: SolarRun): Label[] =>
  INNER_PLANETS.map((name) => ({ at: () => positionOf(world, ids[name] as number), text: INNER_NAMES[name] }));

/** The Sun and the inner planets with their names, and where they have been. */
export const innerPicture = (run: SolarRun) => ({
  view: INNER_VIEW,
  camera: INNER_CAMERA,
  fills: [innerSun(run)],
  trails: innerTrails(run),
  labels: innerLabels(run),
});

/** What the inner planets are called. */
export const INNER_NAMES = { mercury: 'Mercury', venus: 'Venus', earth: 'Earth', mars: 'Mars' } as const;

/** The distances of the inner planets from the Sun against the days. */
export const INNER_DISTANCES = {
  title: 'Distances from the Sun',
  x: { label: 't, days', value: ({ world }: SolarRun) => DAYS * world.time },
  y: { label: 'r, 10⁹ m' },
  series: INNER_PLANETS.map((name) => ({
    label: INNER_NAMES[name],
    value: (run: SolarRun) => distanceFromSun(run, name),
  })),
} as const;
