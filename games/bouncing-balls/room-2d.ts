/** The room in 2D: a background, a grid of metres, walls. */
import 'pixi.js/graphics';
import { createSegmentLayer } from '@principia/render-pixi';
import type { BouncingBalls } from '@principia/scenes';
import { Container, Graphics } from 'pixi.js';

export interface Room2D {
  readonly ground: Container;
  readonly walls: Container;
  destroy(): void;
}

export function createRoom2D({ room }: BouncingBalls): Room2D {
  const { min, max } = room;
  const fill = new Graphics().rect(min.x, -max.y, max.x - min.x, max.y - min.y).fill({ color: 0x0b1026, alpha: 0.38 });
  const grid = createSegmentLayer({ thickness: 1, color: 0x9fb4ff, opacity: 0.09 });
  const lines: number[] = [];
  for (let x = Math.ceil(min.x) + 1; x < max.x; x++) lines.push(x, min.y, x, max.y);
  for (let y = Math.ceil(min.y) + 1; y < max.y; y++) lines.push(min.x, y, max.x, y);
  grid.set(lines);
  const walls = createSegmentLayer({ thickness: 3, color: 0xaebcf0 });
  const corners = [
    [min.x, min.y],
    [max.x, min.y],
    [max.x, max.y],
    [min.x, max.y],
  ];
  walls.set(corners.flatMap((corner, i) => [...corner, ...corners[(i + 1) % 4]]));
  const ground = new Container({ children: [fill, grid.container] });
  return {
    ground,
    walls: walls.container,
    destroy() {
      grid.destroy();
      walls.destroy();
      // With options, pixi destroys even a Graphics' own shapes only if `context` is given.
      ground.destroy({ children: true, context: true });
    },
  };
}
