/** The boat, with the water in its tank. */
import { Container, Graphics } from 'pixi.js';
import { HULL } from './hull.ts';
import type { Pitch } from './pitch.ts';

const HALF = HULL.length / 2;
const R = HULL.halfHeight;
const TANK = { width: 7, height: 1.9, bottom: -1.5 } as const;

export interface BoatPicture {
  readonly container: Container;
  /** @param turn of the propeller, rad */
  update(x: number, y: number, fill: number, tilt: Readonly<Pitch>, turn: number): void;
}

export function createBoatPicture(): BoatPicture {
  const hull = new Graphics();
  hull
    .roundRect(-1.6, R - 0.4, 3.4, 2.6, 0.5)
    .fill(0xe0a82e)
    .rect(0.2, R + 2, 0.35, 1.6)
    .fill(0xe0a82e);
  hull.rect(0.2, R + 3.3, 1.2, 0.4).fill(0xe0a82e);
  hull.roundRect(-HALF, -R, 2 * HALF, 2 * R, R).fill(0xf2bd3f);
  hull.roundRect(-HALF, -R, 2 * HALF, R, R).fill({ color: 0xc98f22, alpha: 0.5 });
  for (let i = 0; i < 6; i++)
    hull
      .circle(-4.4 + 1.75 * i, 0.95, 0.5)
      .fill(0x1c3a52)
      .circle(-4.3 + 1.75 * i, 1.05, 0.22)
      .fill(0x9fdcff);
  hull.roundRect(-TANK.width / 2, TANK.bottom, TANK.width, TANK.height, 0.3).fill(0xf6f9ff);
  const water = new Graphics().rect(0, 0, TANK.width - 0.3, TANK.height - 0.3).fill(0x2f8fe0);
  water.position.set(-TANK.width / 2 + 0.15, TANK.bottom + 0.15);
  const propeller = new Graphics().ellipse(0, 0, 0.35, 1.7).fill(0x8a6a1c);
  propeller.position.set(-HALF - 0.5, 0);
  const body = new Container({ children: [propeller, hull, water] });
  return {
    container: body,
    update(x, y, fill, { facing, pitch }, turn) {
      body.position.set(x, y);
      body.scale.x = facing;
      body.rotation = facing * pitch;
      water.scale.y = Math.max(0.001, fill);
      propeller.scale.y = Math.cos(turn);
    },
  };
}
