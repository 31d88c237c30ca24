/** Sparks for the eye alone: nothing in the game depends on them, so they may come from anywhere. */
import { Container, Sprite, type Texture } from 'pixi.js';

export interface Sparks {
  readonly container: Container;
  /** @param spread speed of the fastest, m/s */
  burst(x: number, y: number, count: number, spread: number, tint: number, vx?: number, vy?: number): void;
  update(seconds: number): void;
}

/** @param most sparks at a time; later ones take the place of the first */
export function createSparks(spot: Texture, most: number): Sparks {
  const container = new Container();
  const sparks = Array.from({ length: most }, () => {
    const sprite = new Sprite({ texture: spot, anchor: 0.5, blendMode: 'add', visible: false });
    container.addChild(sprite);
    return { sprite, vx: 0, vy: 0, age: 0, life: 0 };
  });
  let next = 0;
  return {
    container,
    burst(x, y, count, spread, tint, vx = 0, vy = 0) {
      for (let i = 0; i < count; i++) {
        const spark = sparks[next++ % most];
        const angle = 2 * Math.PI * Math.random();
        const speed = spread * Math.sqrt(Math.random());
        spark.vx = vx + speed * Math.cos(angle);
        spark.vy = vy + speed * Math.sin(angle);
        spark.age = 0;
        spark.life = 0.35 + 0.6 * Math.random();
        spark.sprite.tint = tint;
        spark.sprite.position.set(x, -y);
      }
    },
    update(seconds) {
      for (const spark of sparks) {
        spark.age += seconds;
        const left = 1 - spark.age / spark.life;
        spark.sprite.visible = left > 0;
        if (!(left > 0)) continue;
        spark.sprite.x += spark.vx * seconds;
        spark.sprite.y -= spark.vy * seconds;
        spark.sprite.alpha = left;
        spark.sprite.scale.set((1 + 5 * left) / 32);
      }
    },
  };
}
