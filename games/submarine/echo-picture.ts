/** What is seen of bed and crates: by daylight, in the floodlight, and for a while in the echo of a ping. */
import { Graphics } from 'pixi.js';
import { daylight } from './sea-picture.ts';
import { PING, type SubmarineGame } from './sim.ts';

const STEP = 3.5;
const FLOODLIGHT = 30;
/** Parts of the bed farther away are out of the picture, m. */
const IN_VIEW = 130;

export interface EchoPicture {
  readonly graphics: Graphics;
  update(game: SubmarineGame, hasFloodlight: boolean): void;
}

export function createEchoPicture(): EchoPicture {
  const graphics = new Graphics();
  return {
    graphics,
    update(game, hasFloodlight) {
      graphics.clear();
      const { bed, crates } = game.sea;
      const { Position } = game.world.components;
      const [sx, sy] = [Position.x[game.sub], Position.y[game.sub]];
      const seen = (x: number, y: number) => {
        const near = hasFloodlight ? Math.max(0, 1 - Math.hypot(x - sx, y - sy) / FLOODLIGHT) : 0;
        return Math.min(1, Math.max(0.8 * daylight(-y), 1.3 * near, echoOf(game, x, y)));
      };
      for (let i = 0; i + 3 < bed.length; i += 2) {
        if (Math.abs(bed[i] - sx) > IN_VIEW) continue;
        const [ax, ay, bx, by] = [bed[i], bed[i + 1], bed[i + 2], bed[i + 3]];
        const count = Math.ceil((bx - ax) / STEP);
        for (let k = 0; k < count; k++) {
          const [from, to] = [k / count, (k + 1) / count];
          const x = ax + from * (bx - ax);
          const y = ay + from * (by - ay);
          const alpha = seen(x, y);
          if (alpha < 0.04) continue;
          graphics.moveTo(x, y).lineTo(ax + to * (bx - ax), ay + to * (by - ay));
          graphics.stroke({ width: 0.7, color: 0x6fe0c8, alpha, cap: 'round' });
        }
      }
      for (let i = 0; i < game.taken.length; i++) {
        const [x, y] = [crates[2 * i], crates[2 * i + 1]];
        const alpha = game.taken[i] === 1 ? 0 : seen(x, y);
        if (alpha < 0.04) continue;
        graphics.rect(x - 1.6, y - 1.2, 3.2, 2.6).fill({ color: 0xffa63d, alpha });
        graphics.circle(x, y, 4.5).stroke({ width: 0.35, color: 0xffd28a, alpha: 0.7 * alpha });
      }
      const { pingX, pingY, pingTime } = game.boat;
      const age = game.world.time - pingTime;
      if (age < 4)
        graphics
          .circle(pingX, pingY, 1 + PING.speed * age)
          .stroke({ width: 0.6, color: 0x9ff5e2, alpha: 0.5 * (1 - age / 4) });
    },
  };
}

/** Brightness of the echo from a place: the sound has passed it, and it fades. */
function echoOf({ boat, world }: SubmarineGame, x: number, y: number): number {
  const age = world.time - boat.pingTime - Math.hypot(x - boat.pingX, y - boat.pingY) / PING.speed;
  return age < 0 || age > PING.life ? 0 : 1 - age / PING.life;
}
