/** The view: camera, picture, names and controls. */
import { BODY_NAMES, SOLAR_STATES } from '@principia/scenes';
import { listenToTaps, type View, type ViewContext } from '@principia/shell';
import { Scene, WebGLRenderer } from 'three';
import { LOOKS, PROBE_COLOR } from './bodies.ts';
import { FlightPlan } from './flight-plan.ts';
import { createHud } from './hud.ts';
import { createLabels } from './labels.ts';
import { LARGE_MOONS, MOON_NAMES, type MoonName } from './large-moons.ts';
import type { Page } from './page.ts';
import { createPicture, type FollowName, type SolarPicture, type Spot, UNIT } from './picture.ts';
import type { Settings } from './settings.ts';
import type { SolarGame } from './sim.ts';
import { SolarCamera } from './solar-camera.ts';
import { createSounds } from './sounds.ts';
import { difference, lengthOf, scaled, vector } from './vectors.ts';
import { WORDS } from './words.ts';

/** Distance from which a body is first seen, in its radii. */
const RADII_AWAY = 26;
/** Distances from which a probe and the inner planets are, millions of km. */
const PROBE_DISTANCE = 40;
const INNER_PLANETS = 560;
/** Distance from which an orbit is seen, in its radii. */
const ORBIT_AWAY = 2.4;
/** A tap this close to a body follows it, CSS pixels. */
const TAP_RADIUS = 26;

export async function openView(context: ViewContext<Settings, SolarGame>, page: Page): Promise<View> {
  const renderer = new WebGLRenderer({ antialias: true, logarithmicDepthBuffer: true });
  renderer.setClearColor(0x03050c);
  const canvas = renderer.domElement;
  context.element.append(canvas);
  const view = new SolarCamera(renderer, context.reducedMotion);
  const plan = new FlightPlan();
  const picture = createPicture(context.sim, plan);
  const scene = new Scene().add(picture.object);
  const hud = createHud(context, page, plan);
  const sounds = createSounds();
  const labels = createLabels(hud.labels, textsOf(), (i) => follow(context, page, picture.spots[i]));
  const attend = createAttention(context, page, view, picture);
  const place = createPlacement(view);
  const stopTaps = listenToTaps(canvas, (x, y) => {
    const found = nearest(picture.spots, x, y, view);
    if (found !== undefined) follow(context, page, found);
  });
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      picture.clearTrails();
      plan.reset();
    },
    draw(alpha, seconds) {
      const sim = context.sim();
      plan.update(sim, seconds);
      attend(alpha);
      view.update(seconds, context.insets(), hud.covered());
      renderer.render(scene, view.camera);
      labels.update(picture.spots, context.values().names, place);
      hud.update(seconds);
      sounds.update(sim, context.values().sound);
    },
    fit: () => view.approach(distanceFor(context.sim(), page.follow), page.follow === 'sun'),
    zoom: (factor) => view.zoom(factor),
    toScreen(x, y, z) {
      const seen = view.toScreen(scaled(difference(vector(x, y, z), picture.focus), UNIT));
      return seen === undefined ? { x: -1, y: -1 } : { ...seen };
    },
    destroy() {
      stopTaps();
      for (const part of [labels, hud, sounds, picture, plan, view]) part.destroy();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

const isLargeMoon = (name: Spot['name']): name is MoonName => name in LARGE_MOONS;

/** Follows a body, and of a large moon its planet. */
function follow(context: ViewContext<Settings, SolarGame>, page: Page, { name }: Spot): void {
  if (isLargeMoon(name)) page.follow = LARGE_MOONS[name].planet;
  else page.follow = name === 'meeting' ? (context.sim().mission?.target ?? 'sun') : name;
}

/** Returns a function that brings the picture up to date, and sends the camera to what the player follows. */
function createAttention(
  context: ViewContext<Settings, SolarGame>,
  page: Page,
  view: SolarCamera,
  picture: SolarPicture,
): (alpha: number) => void {
  let followed: FollowName | undefined;
  let mission = '';
  const options = {
    get follow() {
      return page.follow;
    },
    get values() {
      return context.values();
    },
    get distance() {
      return view.distance;
    },
    pixelAt: view.pixelAt,
  };
  return (alpha) => {
    const sim = context.sim();
    if (page.follow === 'probe' && sim.flight.phase === 'none') page.follow = 'sun';
    if (page.follow === 'moon' && sim.system.ids.moon === undefined) page.follow = 'earth';
    const before = { ...picture.focus };
    picture.update(alpha, options);
    if (followed === page.follow && mission === sim.flight.mission) return;
    if (followed !== undefined && followed !== page.follow) {
      view.shift(scaled(difference(before, picture.focus), UNIT));
    }
    view.approach(distanceFor(sim, page.follow), page.follow === 'sun', followed === undefined);
    followed = page.follow;
    mission = sim.flight.mission;
    // Sizes on the screen depend on where the camera is now.
    picture.update(alpha, options);
  };
}

/** Distance from which a body is seen well, and from the Sun the orbits that matter, millions of km. */
function distanceFor(sim: SolarGame, name: FollowName): number {
  if (name === 'probe') return PROBE_DISTANCE;
  if (name !== 'sun') return RADII_AWAY * UNIT * SOLAR_STATES[name].radius;
  const target = sim.mission?.target ?? 'mars';
  const reach = lengthOf(difference(sim.bodyState(target).position, sim.bodyState('sun').position));
  return Math.max(INNER_PLANETS, ORBIT_AWAY * UNIT * reach);
}

/** Returns the place and drawn radius of a body on the canvas; the result is reused. */
function createPlacement(view: SolarCamera) {
  const label = { x: 0, y: 0, radius: 0 };
  return (spot: Spot) => {
    const place = view.toScreen(spot.place);
    if (place === undefined) return undefined;
    label.x = place.x;
    label.y = place.y;
    label.radius = Math.min(spot.radius / view.pixelAt(spot.place), view.height / 3);
    return label;
  };
}

function textsOf(): readonly (readonly [string, string])[] {
  return [
    ...BODY_NAMES.map((name) => [WORDS.bodies[name][0], LOOKS[name].color] as const),
    [WORDS.probe, PROBE_COLOR],
    ['◎', PROBE_COLOR],
    ...MOON_NAMES.map((name) => [WORDS.largeMoons[name], LARGE_MOONS[name].color] as const),
  ];
}

/** The body at a place of the canvas. */
function nearest(spots: readonly Spot[], x: number, y: number, view: SolarCamera): Spot | undefined {
  let found: Spot | undefined;
  let best = 0;
  for (const spot of spots) {
    const place = spot.isShown ? view.toScreen(spot.place) : undefined;
    if (place === undefined) continue;
    const gap = Math.hypot(place.x - x, place.y - y) - spot.radius / view.pixelAt(spot.place) - TAP_RADIUS;
    if (gap >= best) continue;
    best = gap;
    found = spot;
  }
  return found;
}
