/** The three-dimensional picture of one game: lengths are millions of km from the followed body. */
import { BODY_NAMES, type BodyName, EPOCH, SOLAR_STATES } from '@principia/scenes';
import { AmbientLight, Group, PointLight, SphereGeometry, Sprite, SpriteMaterial } from 'three';
import { LOOKS, PROBE_COLOR } from './bodies.ts';
import type { FlightPlan } from './flight-plan.ts';
import { createGlobe, type Globe } from './globes.ts';
import { MOON_NAMES, type MoonName } from './large-moons.ts';
import { createMoonBalls } from './moon-balls.ts';
import { createOrbitLine, type OrbitLine, osculatingEllipse } from './orbit-line.ts';
import { createPathLine } from './path-line.ts';
import type { Values } from './settings.ts';
import type { SolarGame } from './sim.ts';
import { createSky, paintGlow } from './sky.ts';
import { DAY } from './solar-clock.ts';
import { TRACKED } from './track.ts';
import { createTrails } from './trails.ts';
import { difference, lengthOf, scaled, sum, type Vector, vector } from './vectors.ts';

/** Millions of km. */
export const UNIT = 1e-6;
const SKY_DISTANCE = 4e5;
/** Poses between two steps are only drawn where these are close, s. */
const MAX_INTERPOLATED = 2 * DAY;

/** Smallest drawn radius of a body in its true size, and that of the probe, CSS pixels. */
const MIN_PIXELS = 0.8;
const PROBE_PIXELS = 5;
/** That of a large moon in the enlarged scale. */
const MOON_PIXELS = 2.6;

/** A body or the probe in the picture. */
export interface Spot {
  readonly name: BodyName | 'probe' | 'meeting' | MoonName;
  /** Millions of km from the followed body. */
  readonly place: Vector;
  /** Drawn radius, millions of km. */
  radius: number;
  isShown: boolean;
}

export type FollowName = BodyName | 'probe';

export interface SolarPicture {
  readonly object: Group;
  readonly spots: readonly Spot[];
  /** Where the followed body is, km. */
  readonly focus: Vector;
  /** Called once a frame. @param alpha position of the picture between the last two steps */
  update(alpha: number, options: PictureOptions): void;
  clearTrails(): void;
  destroy(): void;
}

export interface PictureOptions {
  readonly follow: FollowName;
  readonly values: Readonly<Values>;
  /** Size of a CSS pixel at the distance of a place from the camera. */
  pixelAt(place: Vector): number;
  /** Distance of the camera from its target. */
  readonly distance: number;
}

export function createPicture(game: () => SolarGame, plan: FlightPlan): SolarPicture {
  const parts = createParts();
  const { object, path, trails } = parts;
  const spots: Spot[] = [...BODY_NAMES, 'probe' as const, 'meeting' as const, ...MOON_NAMES].map((name) => ({
    name,
    place: vector(),
    radius: 0,
    isShown: false,
  }));
  const spotOf = (name: Spot['name']) => spots.find((spot) => spot.name === name) as Spot;
  const focus = vector();
  let shownPath = -1;
  return {
    object,
    spots,
    focus,
    update(alpha, options) {
      const sim = game();
      const places = placesOf(sim, alpha);
      const sun = places.get('sun') as Vector;
      Object.assign(focus, places.get(options.follow) ?? sun);
      const toPicture = (place: Vector) => scaled(difference(place, focus), UNIT);
      for (const spot of spots) {
        const place = places.get(spot.name as FollowName);
        spot.isShown = place !== undefined;
        if (place !== undefined) Object.assign(spot.place, toPicture(place));
      }
      const origin = toPicture(sun);
      for (const { position } of [parts.light, path.object, trails.object]) position.copy(origin);
      showGlobes(sim, spots, parts, options);
      parts.moons.update(spotOf, {
        days: sim.clock.julianDate - EPOCH,
        daysAPicture: (sim.clock.actualRate * sim.dt) / DAY,
        unit: UNIT,
        minPixels: options.values.enlarged ? MOON_PIXELS : MIN_PIXELS,
        pixelAt: options.pixelAt,
      });
      for (const [name, line] of parts.lines) {
        const centre = places.get(name === 'moon' ? 'earth' : 'sun') as Vector;
        line.object.visible = options.values.orbits;
        if (options.values.orbits) showOrbit(sim, name, line, toPicture(centre));
      }
      path.object.visible = sim.flight.phase === 'ready' || sim.flight.phase === 'flying';
      if (shownPath !== plan.version) path.set(plan.prediction.path, plan.prediction.count, UNIT);
      shownPath = plan.version;
      path.setScale(options.distance);
      showMeeting(sim, plan, spots[BODY_NAMES.length + 1], origin, parts.numbers);
      trails.update(sim, places, options.values.trails);
    },
    clearTrails: () => trails.clear(),
    destroy: parts.destroy,
  };
}

type Parts = ReturnType<typeof createParts>;

function createParts() {
  const object = new Group();
  const sphere = new SphereGeometry(1, 48, 32);
  const globes = new Map<BodyName, Globe>(BODY_NAMES.map((name) => [name, createGlobe(name, sphere)]));
  const moons = createMoonBalls(sphere);
  const orbiting = BODY_NAMES.filter((name) => name !== 'sun');
  const lines = new Map<BodyName, OrbitLine>(orbiting.map((name) => [name, createOrbitLine(LOOKS[name].color)]));
  const sky = createSky(SKY_DISTANCE);
  const light = new PointLight(0xfff4e0, 3.4, 0, 0);
  const path = createPathLine(PROBE_COLOR, 4000, true);
  const trails = createTrails();
  const glow = paintGlow('#ffffff', 0.35);
  const probe = new Sprite(new SpriteMaterial({ map: glow, color: PROBE_COLOR, depthWrite: false, depthTest: false }));
  object.add(sky.object, light, new AmbientLight(0x8090c0, 0.16), path.object, trails.object, moons.object, probe);
  for (const { object: part } of [...globes.values(), ...lines.values()]) object.add(part);
  const destroy = () => {
    for (const part of [...globes.values(), ...lines.values(), moons, sky, path, trails]) part.destroy();
    sphere.dispose();
    glow.dispose();
    probe.material.dispose();
  };
  return { object, globes, lines, moons, light, path, trails, probe, numbers: new Float64Array(6), destroy };
}

/** Places bodies and probe, and gives them their size. */
function showGlobes(sim: SolarGame, spots: readonly Spot[], { globes, probe }: Parts, options: PictureOptions): void {
  const { pixelAt, values } = options;
  for (let i = 0; i < BODY_NAMES.length; i++) {
    const [spot, name] = [spots[i], BODY_NAMES[i]];
    const globe = globes.get(name) as Globe;
    globe.object.visible = spot.isShown;
    if (!spot.isShown) continue;
    const real = UNIT * SOLAR_STATES[name].radius;
    spot.radius = Math.max(real, (values.enlarged ? LOOKS[name].pixels : MIN_PIXELS) * pixelAt(spot.place));
    globe.object.position.copy(spot.place);
    globe.show(spot.radius, sim.clock.julianDate - EPOCH);
  }
  hideMoonInEarth(spots, globes);
  const ship = spots[BODY_NAMES.length];
  probe.visible = ship.isShown;
  probe.position.copy(ship.place);
  ship.radius = PROBE_PIXELS * pixelAt(ship.place);
  probe.scale.setScalar(2.4 * ship.radius);
}

/** Where everything is, km, between the last two steps if these are close to each other. */
function placesOf(sim: SolarGame, alpha: number): ReadonlyMap<FollowName, Vector> {
  const { Position } = sim.world.components;
  const before = sim.world.previous.Position;
  const isClose = !sim.clock.isTravelling && sim.clock.actualRate * sim.dt < MAX_INTERPOLATED;
  const share = isClose ? alpha : 1;
  const between = (id: number): Vector =>
    vector(
      before.x[id] + share * (Position.x[id] - before.x[id]),
      before.y[id] + share * (Position.y[id] - before.y[id]),
      before.z[id] + share * (Position.z[id] - before.z[id]),
    );
  const places = new Map<FollowName, Vector>();
  for (const name of BODY_NAMES) {
    const id = sim.system.ids[name];
    if (id !== undefined) places.set(name, between(id));
  }
  const { phase, probe } = sim.flight;
  if (probe !== 0) places.set('probe', between(probe));
  else if (phase === 'ready' && !sim.clock.isTravelling) places.set('probe', sim.probeState().position);
  return places;
}

/** The enlarged Moon would stand in the enlarged Earth when seen from afar. */
function hideMoonInEarth(spots: readonly Spot[], globes: ReadonlyMap<BodyName, Globe>): void {
  const [earth, moon] = (['earth', 'moon'] as const).map((name) => spots[BODY_NAMES.indexOf(name)]);
  if (!moon.isShown) return;
  moon.isShown = lengthOf(difference(earth.place, moon.place)) > earth.radius + moon.radius;
  (globes.get('moon') as Globe).object.visible = moon.isShown;
}

function showOrbit(sim: SolarGame, name: BodyName, line: OrbitLine, centre: Vector): void {
  if (sim.system.ids[name] === undefined) {
    line.object.visible = false;
    return;
  }
  const main = name === 'moon' ? 'earth' : 'sun';
  const [body, other] = [sim.bodyState(name), sim.bodyState(main)];
  const mu = SOLAR_STATES[name].gm + SOLAR_STATES[main].gm;
  const ellipse = osculatingEllipse(
    difference(body.position, other.position),
    difference(body.velocity, other.velocity),
    mu,
  );
  line.set(ellipse, centre, UNIT);
}

/** The place at which the target will be when the path is closest to it. */
function showMeeting(sim: SolarGame, plan: FlightPlan, spot: Spot, origin: Vector, at: Float64Array): void {
  const { phase } = sim.flight;
  const target = TRACKED.indexOf(sim.mission?.target ?? 'sun');
  spot.isShown = (phase === 'ready' || phase === 'flying') && Number.isFinite(plan.closest[target]);
  if (!spot.isShown) return;
  const date = plan.closestAt[target];
  plan.track.at(0, date, at);
  const sun = vector(at[0], at[1], at[2]);
  plan.track.at(target, date, at);
  Object.assign(spot.place, sum(origin, difference(vector(at[0], at[1], at[2]), sun), UNIT));
}
