/** Everything drawn of one game. */
import 'pixi.js/graphics';
import { type Camera2D, type ViewportSize, worldSource } from '@principia/render-core';
import { applyCamera, createTrailLayer, type TrailLayer } from '@principia/render-pixi';
import { BLACK_HOLE } from '@principia/scenes';
import { Container, Graphics, type Texture } from 'pixi.js';
import { glow } from './hawking.ts';
import { DIRECTIONS } from './heading.ts';
import { MOST_LENSES } from './lens-program.ts';
import type { Palette } from './palette.ts';
import type { News } from './rules.ts';
import type { Values } from './settings.ts';
import { createPathView, createShipView } from './ship-view.ts';
import type { BlackHoleGame } from './sim.ts';
import { createBentSky, createPlainSky, type HoleTable, type SkyView } from './sky-view.ts';
import { createSparks, type Sparks } from './sparks.ts';

export interface Picture {
  /** The player changed what is shown. */
  show(values: Readonly<Values>): void;
  update(alpha: number, seconds: number, camera: Camera2D, size: ViewportSize): void;
  /** Something happened: sparks. */
  celebrate(news: News): void;
  /** The ship between two steps: x and y, m. */
  readonly ship: Readonly<Float64Array>;
  destroy(): void;
}

export interface PictureOptions {
  readonly sim: BlackHoleGame;
  readonly parent: Container;
  readonly sky: Texture;
  readonly spot: Texture;
  /** Whether the renderer takes the shader. */
  readonly canBend: boolean;
  readonly isCalm: boolean;
  readonly palette: Palette;
}

export function createPicture({ sim, parent, sky, spot, canBend, isCalm, palette }: PictureOptions): Picture {
  const ship = new Float64Array([BLACK_HOLE.start.x, BLACK_HOLE.start.y]);
  const holes: HoleTable = { values: new Float32Array(4 * MOST_LENSES), count: 0 };
  const skyPlace = new Container();
  const world = new Container();
  const trailPlace = new Container();
  const path = createPathView(spot, sim.scene.isSteep, palette);
  const shipView = createShipView(palette);
  const sparks = createSparks(spot, 180);
  const rays = createSparks(spot, 420);
  world.addChild(
    createLines(palette),
    rays.container,
    trailPlace,
    path.container,
    sparks.container,
    shipView.container,
  );
  const root = new Container({ children: [skyPlace, world] });
  parent.addChild(root);
  let skyView: SkyView | undefined;
  let isBent: boolean | undefined;
  let trail: TrailLayer | undefined;
  let isPathShown = true;
  let isGlowing = true;
  // In a cell: a variable that a function keeps would be a new number on the heap with every frame.
  const time = new Float64Array(1);
  return {
    ship,
    show(values) {
      isPathShown = values.path;
      isGlowing = values.glow;
      if (isBent !== (values.lens && canBend)) {
        skyView?.destroy();
        isBent = values.lens && canBend;
        skyView = isBent ? createBentSky(sky) : createPlainSky(sky);
        skyPlace.addChild(skyView.container);
      }
      if (values.trail === (trail !== undefined)) return;
      trail?.destroy();
      trail = values.trail ? createTrail(sim, palette.trail) : undefined;
      if (trail !== undefined) trailPlace.addChild(trail.container);
    },
    update(alpha, seconds, camera, size) {
      if (!isCalm) time[0] += seconds;
      readPlaces(sim, alpha, ship, holes);
      skyView?.update(holes, camera, size, time);
      applyCamera(world, camera, size);
      trail?.update(alpha);
      path.container.visible = isPathShown && sim.rules.phase === 'flying';
      if (path.container.visible) path.update(sim);
      shipView.update(sim, ship, seconds);
      if (!isCalm) exhaust(sim, ship, sparks);
      sparks.update(seconds);
      if (isGlowing && !isCalm) glow(holes, seconds, rays);
      rays.update(seconds);
    },
    celebrate({ kind, x, y }) {
      if (isCalm) return;
      sparks.source.set([x, y, 0, 0]);
      if (kind === 'fall' || kind === 'over') sparks.burst(70, 120, palette.fall);
      if (kind === 'goal') sparks.burst(60, 150, palette.goal);
      if (kind === 'sling') sparks.burst(24, 60, 0x9fd0ff);
    },
    destroy() {
      skyView?.destroy();
      trail?.destroy();
      // Told what to destroy, pixi leaves out even the shapes that a Graphics alone has, unless they are named.
      root.destroy({ children: true, context: true });
    },
  };
}

function createTrail({ world, scene }: BlackHoleGame, color: number): TrailLayer {
  return createTrailLayer({
    source: worldSource(world),
    bodies: [scene.ship],
    length: 120,
    interval: 2,
    thickness: 3.5,
    color,
    opacity: 0.6,
    maxSegment: 30,
    blendMode: 'add',
  });
}

/** Farther than any window reaches, m. */
const FAR = 8000;

/** The goal, the foot of the holes' zone, and the edge of the stage. */
function createLines({ goal: color, zone: zoneColor }: Palette): Graphics {
  const { width, height, goal, zone } = BLACK_HOLE;
  const lines = new Graphics().rect(0, -height, width, height).stroke({ width: 1.5, color: 0x9fb4ff, alpha: 0.28 });
  // What lies outside is out of play: it steps back.
  for (const [x, y, w, h] of [
    [-FAR, -FAR, FAR, 2 * FAR],
    [width, -FAR, FAR, 2 * FAR],
    [0, -FAR, width, FAR - height],
    [0, 0, width, FAR],
  ]) {
    lines.rect(x, y, w, h).fill({ color: 0x02030a, alpha: 0.5 });
  }
  for (let i = 0; i < 5; i++) {
    lines.rect(0, -goal - 2 * (i + 1), width, 4 * (i + 1)).fill({ color, alpha: 0.035 });
  }
  lines.moveTo(0, -goal).lineTo(width, -goal).stroke({ width: 2, color, alpha: 0.9 });
  return lines.moveTo(0, -zone.min).lineTo(width, -zone.min).stroke({ width: 1.5, color: zoneColor, alpha: 0.45 });
}

function mix(from: number, to: number, share: number): number {
  return from + (to - from) * share;
}

/** Where everything is between two steps. */
function readPlaces({ world, scene }: BlackHoleGame, alpha: number, ship: Float64Array, holes: HoleTable) {
  const { Position, Collider } = world.components;
  const old = world.previous.Position;
  ship[0] = mix(old.x[scene.ship], Position.x[scene.ship], alpha);
  ship[1] = mix(old.y[scene.ship], Position.y[scene.ship], alpha);
  holes.count = Math.min(MOST_LENSES, scene.holeIds.length);
  for (let i = 0; i < holes.count; i++) {
    const id = scene.holeIds[i];
    holes.values[4 * i] = mix(old.x[id], Position.x[id], alpha);
    holes.values[4 * i + 1] = mix(old.y[id], Position.y[id], alpha);
    holes.values[4 * i + 2] = Collider.radius[id];
  }
}

function exhaust({ rules }: BlackHoleGame, ship: Readonly<Float64Array>, sparks: Sparks): void {
  if (rules.phase !== 'flying' || rules.heading === undefined || !rules.hasFuel) return;
  const way = DIRECTIONS[rules.heading];
  const { source } = sparks;
  source[0] = ship[0] - 8 * way.x;
  source[1] = ship[1] - 8 * way.y;
  source[2] = -70 * way.x;
  source[3] = -70 * way.y;
  sparks.burst(1, 14, 0xffa04c);
}
