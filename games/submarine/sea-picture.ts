/** Sky, water, the bed and the ship: what stands still. */
import { Graphics } from 'pixi.js';
import { type Sea, SHIP, WIDTH } from './sea.ts';

const SIDE = 400;
const BOTTOM = -400;
/** Thickness of a layer of water of one colour, m, and depth at which the sea is dark. */
const LAYER = 2.5;
export const DARK = 78;

/** Daylight at a depth: 1 at the surface, 0 in the dark. */
export const daylight = (depth: number): number => Math.max(0, 1 - Math.max(0, depth) / DARK);

export function paintSea({ bed, crushDepth }: Sea): Graphics {
  const picture = new Graphics();
  picture.rect(-SIDE, 0, WIDTH + 2 * SIDE, 60).fill(0x8fc6e8);
  picture.rect(-SIDE, 60, WIDTH + 2 * SIDE, 400).fill(0x5f9fd0);
  for (let depth = 0; depth < -BOTTOM; depth += LAYER) {
    const light = daylight(depth) ** 1.4;
    const mix = (dark: number, bright: number) => Math.round(dark + light * (bright - dark));
    const color = (mix(3, 32) << 16) | (mix(14, 128) << 8) | mix(26, 170);
    picture.rect(-SIDE, -depth - LAYER, WIDTH + 2 * SIDE, LAYER + 0.2).fill(color);
  }
  const outline = [...bed, WIDTH + SIDE, bed[bed.length - 1] + 30, WIDTH + SIDE, BOTTOM, -SIDE, BOTTOM, -SIDE, -10];
  picture.poly(outline).fill(0x020a12);
  for (let x = 0; x < WIDTH; x += 12) picture.rect(x, -crushDepth - 0.2, 5, 0.4).fill({ color: 0xff6a5a, alpha: 0.55 });
  return picture;
}

export function paintShip(): Graphics {
  const ship = new Graphics();
  ship.poly([-16, 2.6, 15, 2.6, 11, -2.2, -12, -2.2]).fill(0xd8483c);
  ship.rect(-11, 2.6, 9, 4.5).fill(0xf4f1e8).rect(-8, 7.1, 4, 3).fill(0xf4f1e8);
  ship.rect(-7, 8.1, 2, 1).fill(0x3a4a60);
  ship.poly([6, 2.6, 7, 2.6, 12.5, 10, 12, 10.4]).fill(0xffc15e);
  ship.position.set(SHIP.x - 32, 0);
  return ship;
}
