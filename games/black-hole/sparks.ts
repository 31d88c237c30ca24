/** Decorative sparks, which do not affect the game. */
import { createRandom, type Random } from '@principia/physics';
import { Container, Sprite, type Texture } from 'pixi.js';

export interface Sparks {
  readonly container: Container;
  /** Source of the next burst, m, and its mean velocity, m/s: x, y, vx, vy. */
  readonly source: Float64Array;
  readonly random: Random;
  /** @param spread speed of the fastest spark relative to the source, m/s */
  burst(count: number, spread: number, tint: number): void;
  update(seconds: number): void;
}

/** @param capacity sparks at a time; a new spark replaces the oldest */
export function createSparks(spot: Texture, capacity: number): Sparks {
  const container = new Container();
  // Math.random would allocate a number in every call.
  const random = createRandom(1);
  const sparks = Array.from({ length: capacity }, () => {
    const sprite = new Sprite({ texture: spot, anchor: 0.5, blendMode: 'add', visible: false });
    container.addChild(sprite);
    return { sprite, tint: 0xffffff };
  });
  const source = new Float64Array(4);
  /** Position, velocity, age and lifetime of each spark. */
  const flights = new Float64Array(6 * capacity);
  let next = 0;
  return {
    container,
    source,
    random,
    burst(count, spread, tint) {
      for (let i = 0; i < count; i++) {
        const spark = sparks[next];
        const at = 6 * next;
        next = (next + 1) % capacity;
        const angle = random.uniform(0, 2 * Math.PI);
        const speed = spread * Math.sqrt(random.uniform());
        flights[at] = source[0];
        flights[at + 1] = source[1];
        flights[at + 2] = source[2] + speed * Math.cos(angle);
        flights[at + 3] = source[3] + speed * Math.sin(angle);
        flights[at + 4] = 0;
        flights[at + 5] = random.uniform(0.35, 0.95);
        // Pixi converts a tint whenever it is set, which allocates objects.
        if (spark.tint !== tint) spark.sprite.tint = tint;
        spark.tint = tint;
      }
    },
    update(seconds) {
      for (let i = 0; i < capacity; i++) {
        const { sprite } = sparks[i];
        const at = 6 * i;
        flights[at + 4] += seconds;
        const left = 1 - flights[at + 4] / flights[at + 5];
        sprite.visible = left > 0;
        if (!(left > 0)) continue;
        flights[at] += flights[at + 2] * seconds;
        flights[at + 1] += flights[at + 3] * seconds;
        sprite.position.set(flights[at], -flights[at + 1]);
        sprite.alpha = left;
        sprite.scale.set((1 + 5 * left) / 32);
      }
    },
  };
}
