/**
 * The end of a fall from near by and slowly: the ship becomes a thread. Every point of it falls freely and alone, so that
 * what is nearer to the hole runs away from what is behind it: along the fall the ship is drawn out, and across it squeezed,
 * as all its points make for one centre. Nothing of it is seen within the horizon.
 */
import { Container, Graphics, MeshSimple, Texture } from 'pixi.js';
import { heightAfter } from './free-fall.ts';
import type { Palette } from './palette.ts';
import { BREATH } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';
import type { HoleTable } from './sky-view.ts';

/** Radii of the close-up and of the hole in it, and height of the ship above the horizon at the start, m of the stage. */
const [RADIUS, HORIZON, START] = [112, 24, 58];
/** The hull in the close-up, from nose to tail; cross-sections of it. */
const [NOSE, TAIL, HALF_WIDTH] = [18, 13, 14];
const SECTIONS = 48;
/** Parts of the time in which it opens and closes. */
const [OPENS, CLOSES] = [0.1, 0.12];

export interface FallCloseUp {
  readonly container: Container;
  /** Shows a fall that has just ended, or nothing. */
  update(sim: BlackHoleGame, alpha: number, holes: HoleTable): void;
}

export function createFallCloseUp({ hull, fall: color }: Palette): FallCloseUp {
  const sky = new Graphics().circle(0, 0, RADIUS).fill({ color: 0x03040a, alpha: 0.94 });
  sky.circle(0, 0, RADIUS).stroke({ width: 2, color, alpha: 0.9 });
  const hole = new Graphics().circle(0, 0, HORIZON + 4).stroke({ width: 7, color: 0xffb066, alpha: 0.35 });
  hole.circle(0, 0, HORIZON).fill(0x000000).stroke({ width: 2.5, color: 0xffe2b8 });
  const vertices = new Float32Array(4 * (SECTIONS + 1));
  const uvs = new Float32Array(vertices.length);
  const ship = new MeshSimple({ texture: Texture.WHITE, vertices, uvs, indices: trianglesOf(SECTIONS) });
  ship.tint = hull;
  const container = new Container({ children: [sky, ship, hole], visible: false });
  return {
    container,
    update({ rules, world, dt }, alpha, holes) {
      container.visible = false;
      if (rules.phase !== 'breath' && rules.phase !== 'over') return;
      const fall = rules.events.findLast(({ kind }) => kind !== 'over');
      if (fall?.kind !== 'fall') return;
      const part = ((world.tick - fall.tick + alpha) * dt) / BREATH;
      if (part >= 1) return;
      container.visible = true;
      const i = 4 * nearestHole(holes, fall.x, fall.y);
      const [x, y] = [holes.values[i], holes.values[i + 1]];
      container.position.set(x, -y);
      // The ship comes from the right here, and the whole is turned to where it came from.
      container.rotation = Math.atan2(y - fall.y, fall.x - x);
      container.scale.set(Math.min(1, part / OPENS));
      container.alpha = Math.min(1, (1 - part) / CLOSES);
      writeHull(vertices, part);
    },
  };
}

/** The left and right edge of each section of the hull, from nose to tail. */
function writeHull(vertices: Float32Array, part: number): void {
  const highest = START + TAIL;
  for (let i = 0; i <= SECTIONS; i++) {
    const height = START - NOSE + ((NOSE + TAIL) * i) / SECTIONS;
    const distance = HORIZON + heightAfter(height, highest, part);
    const half = (((HALF_WIDTH * i) / SECTIONS) * distance) / (HORIZON + height);
    vertices[4 * i] = vertices[4 * i + 2] = distance;
    vertices[4 * i + 1] = -half;
    vertices[4 * i + 3] = half;
  }
}

/** The hole into which a ship at a place fell. */
function nearestHole({ values, count }: HoleTable, x: number, y: number): number {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i < count; i++) {
    const distance = Math.hypot(values[4 * i] - x, values[4 * i + 1] - y) - values[4 * i + 2];
    if (distance < least) [nearest, least] = [i, distance];
  }
  return nearest;
}

function trianglesOf(sections: number): Uint32Array {
  const corners = [0, 1, 2, 2, 1, 3];
  return Uint32Array.from({ length: 6 * sections }, (_, i) => 2 * Math.floor(i / 6) + corners[i % 6]);
}
