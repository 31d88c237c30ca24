/** The drawing of one game. */
import 'pixi.js/graphics';
import { type Camera2D, type ViewportSize, worldSource } from '@principia/render-core';
import { applyCamera, createTrailLayer, type TrailLayer } from '@principia/render-pixi';
import { BLACK_HOLE } from '@principia/scenes';
import { Container, Graphics, type Texture } from 'pixi.js';
import { createFallCloseUp } from './fall-close-up.ts';
import type { Ghost } from './ghost.ts';
import { emitGlow } from './hawking.ts';
import { MAX_LENSES } from './lens-program.ts';
import type { Palette } from './palette.ts';
import type { GameEvent } from './rules.ts';
import type { Values } from './settings.ts';
import { createPathView, createShipView } from './ship-view.ts';
import type { BlackHoleGame } from './sim.ts';
import { createBentSky, createPlainSky, type HoleTable, type SkyView } from './sky-view.ts';
import { createSparks, type Sparks } from './sparks.ts';

export interface Picture {
  /** Applies changed settings. */
  show(values: Readonly<Values>): void;
  update(alpha: number, seconds: number, camera: Camera2D, size: ViewportSize): void;
  /** Emits the sparks of a game event. */
  celebrate(event: GameEvent): void;
  /** Interpolated position of the ship between two steps: x and y, m. */
  readonly ship: Readonly<Float64Array>;
  destroy(): void;
}

export interface PictureOptions {
  readonly sim: BlackHoleGame;
  readonly parent: Container;
  readonly sky: Texture;
  readonly spot: Texture;
  /** Whether the renderer supports the lensing shader. */
  readonly canBend: boolean;
  readonly isCalm: boolean;
  readonly palette: Palette;
  /** Not destroyed with the picture. */
  readonly ghost: Ghost;
}

export function createPicture({ sim, parent, sky, spot, canBend, isCalm, palette, ghost }: PictureOptions): Picture {
  const ship = new Float64Array([BLACK_HOLE.start.x, BLACK_HOLE.start.y]);
  const holes: HoleTable = { values: new Float32Array(4 * MAX_LENSES), count: 0 };
  const skyParent = new Container();
  const world = new Container();
  const trailParent = new Container();
  const path = createPathView(spot, sim.scene.isSteep, palette);
  const shipView = createShipView(palette);
  const closeUp = createFallCloseUp(palette);
  const sparks = createSparks(spot, 180);
  const rays = createSparks(spot, 420);
  const ships = [ghost.container, closeUp.container, sparks.container, shipView.container];
  world.addChild(createLines(palette), rays.container, trailParent, path.container, ...ships);
  const root = new Container({ children: [skyParent, world] });
  parent.addChild(root);
  let skyView: SkyView | undefined;
  let isBent: boolean | undefined;
  let trail: TrailLayer | undefined;
  let isPathShown = true;
  let isGlowing = true;
  let isGhostShown = true;
  // A typed array, because a captured variable would allocate a number on the heap in every frame.
  const time = new Float64Array(1);
  return {
    ship,
    show(values) {
      isPathShown = values.path;
      isGlowing = values.glow;
      isGhostShown = values.ghost;
      if (isBent !== (values.lens && canBend)) {
        skyView?.destroy();
        isBent = values.lens && canBend;
        skyView = isBent ? createBentSky(sky) : createPlainSky(sky);
        skyParent.addChild(skyView.container);
      }
      if (values.trail === (trail !== undefined)) return;
      trail?.destroy();
      trail = values.trail ? createTrail(sim, palette.trail) : undefined;
      if (trail !== undefined) trailParent.addChild(trail.container);
    },
    update(alpha, seconds, camera, size) {
      if (!isCalm) time[0] += seconds;
      readPositions(sim, alpha, ship, holes);
      skyView?.update(holes, camera, size, time);
      applyCamera(world, camera, size);
      trail?.update(alpha);
      path.container.visible = isPathShown && sim.rules.phase === 'flying';
      if (path.container.visible) path.update(sim);
      ghost.update(sim, alpha, isGhostShown);
      shipView.update(sim, ship, seconds);
      if (!isCalm) closeUp.update(sim, alpha, holes);
      if (!isCalm) exhaust(sim, ship, sparks);
      sparks.update(seconds);
      if (isGlowing && !isCalm) emitGlow(holes, seconds, rays);
      rays.update(seconds);
    },
    celebrate({ kind, x, y }) {
      if (isCalm) return;
      sparks.source.set([x, y, 0, 0]);
      burstOf(kind, palette, sparks);
    },
    destroy() {
      skyView?.destroy();
      trail?.destroy();
      ghost.container.removeFromParent();
      // With options, pixi destroys even a Graphics' own shapes only if `context` is given.
      root.destroy({ children: true, context: true });
    },
  };
}

function burstOf(kind: GameEvent['kind'], palette: Palette, sparks: Sparks): void {
  if (kind === 'fall' || kind === 'over') sparks.burst(70, 120, palette.fall);
  if (kind === 'goal') sparks.burst(60, 150, palette.goal);
  if (kind === 'sling') sparks.burst(24, 60, 0x9fd0ff);
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

/** Farther than any window shows, m. */
const FAR = 8000;

/** Draws the goal, the lower edge of the zone of holes, and the border of the stage. */
function createLines({ goal: color, zone: zoneColor }: Palette): Graphics {
  const { width, height, goal, zone } = BLACK_HOLE;
  const lines = new Graphics().rect(0, -height, width, height).stroke({ width: 1.5, color: 0x9fb4ff, alpha: 0.28 });
  // The area out of bounds is darkened.
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

/** Interpolates the positions of ship and holes between two steps. */
function readPositions({ world, scene }: BlackHoleGame, alpha: number, ship: Float64Array, holes: HoleTable) {
  const { Position, Collider } = world.components;
  const old = world.previous.Position;
  ship[0] = mix(old.x[scene.ship], Position.x[scene.ship], alpha);
  ship[1] = mix(old.y[scene.ship], Position.y[scene.ship], alpha);
  holes.count = Math.min(MAX_LENSES, scene.holeIds.length);
  for (let i = 0; i < holes.count; i++) {
    const id = scene.holeIds[i];
    holes.values[4 * i] = mix(old.x[id], Position.x[id], alpha);
    holes.values[4 * i + 1] = mix(old.y[id], Position.y[id], alpha);
    holes.values[4 * i + 2] = Collider.radius[id];
  }
}

function exhaust({ rules }: BlackHoleGame, ship: Readonly<Float64Array>, sparks: Sparks): void {
  const { push: direction } = rules;
  if (rules.phase !== 'flying' || direction === undefined || !rules.hasFuel) return;
  const { source } = sparks;
  source[0] = ship[0] - 8 * direction.x;
  source[1] = ship[1] - 8 * direction.y;
  source[2] = -70 * direction.x;
  source[3] = -70 * direction.y;
  sparks.burst(1, 14, 0xffa04c);
}
