/** Decorative sparks, which do not affect the game and may use Math.random. */
import { Container, Sprite, type Texture } from 'pixi.js';

export interface Sparks {
  readonly container: Container;
  /** Source of the next burst, m, and its mean velocity, m/s: x, y, vx, vy. */
  readonly source: Float64Array;
  /** @param spread speed of the fastest spark relative to the source, m/s */
  burst(count: number, spread: number, tint: number): void;
  update(seconds: number): void;
}

/** @param capacity sparks at a time; a new spark replaces the oldest */
export function createSparks(spot: Texture, capacity: number): Sparks {
  const container = new Container();
  const sparks = Array.from({ length: capacity }, () => {
    const sprite = new Sprite({ texture: spot, anchor: 0.5, blendMode: 'add', visible: false });
    container.addChild(sprite);
    return { sprite, tint: 0xffffff };
  });
  const source = new Float64Array(4);
  /** Velocity, age and lifetime of each spark. */
  const flights = new Float64Array(4 * capacity);
  let next = 0;
  return {
    container,
    source,
    burst(count, spread, tint) {
      for (let i = 0; i < count; i++) {
        const spark = sparks[next];
        const at = 4 * next;
        next = (next + 1) % capacity;
        const angle = 2 * Math.PI * Math.random();
        const speed = spread * Math.sqrt(Math.random());
        flights[at] = source[2] + speed * Math.cos(angle);
        flights[at + 1] = source[3] + speed * Math.sin(angle);
        flights[at + 2] = 0;
        flights[at + 3] = 0.35 + 0.6 * Math.random();
        // Pixi converts a tint whenever it is set, which allocates objects.
        if (spark.tint !== tint) spark.sprite.tint = tint;
        spark.tint = tint;
        spark.sprite.position.set(source[0], -source[1]);
      }
    },
    update(seconds) {
      for (let i = 0; i < capacity; i++) {
        const { sprite } = sparks[i];
        const at = 4 * i;
        flights[at + 2] += seconds;
        const left = 1 - flights[at + 2] / flights[at + 3];
        sprite.visible = left > 0;
        if (!(left > 0)) continue;
        const { position } = sprite;
        position.set(position.x + flights[at] * seconds, position.y - flights[at + 1] * seconds);
        sprite.alpha = left;
        sprite.scale.set((1 + 5 * left) / 32);
      }
    },
  };
}
