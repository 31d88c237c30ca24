/** Soft shadows under balls and lights on them: two more layers that read the same positions. */
import { type BodySource, SHAPES, worldSource } from '@principia/render-core';
import { type BodyLayer, createBodyLayer } from '@principia/render-pixi';
import type { BouncingBalls } from '@principia/scenes';
import type { Container } from 'pixi.js';

/** Balls smaller than this on the screen are drawn flat, CSS pixels. */
const SMALLEST_SHADED = 3;
/** Most balls that are shaded: with more, each is too small to be seen so closely. */
const MOST_SHADED = 5000;

/** Two layers that make flat discs look round. */
export interface Shading {
  readonly below: Container;
  readonly above: Container;
  update(alpha: number, pixelsPerMetre: number): void;
  destroy(): void;
}

export function createShading({ world, balls, radius }: BouncingBalls): Shading | undefined {
  if (balls.length > MOST_SHADED) return undefined;
  const source = worldSource(world);
  const shadow = createBodyLayer({ source: spots(source, balls, 1.5 * radius, 0x8c1a0c05), rotation: false });
  const light = createBodyLayer({ source: spots(source, balls, 0.56 * radius, 0x99ffffff), rotation: false });
  const layers: readonly BodyLayer[] = [shadow, light];
  shadow.container.position.set(0.12 * radius, 0.34 * radius);
  light.container.position.set(-0.27 * radius, -0.33 * radius);
  return {
    below: shadow.container,
    above: light.container,
    update(alpha, pixelsPerMetre) {
      const visible = radius * pixelsPerMetre >= SMALLEST_SHADED;
      for (let i = 0; i < layers.length; i++) {
        layers[i].container.visible = visible;
        if (visible) layers[i].update(alpha);
      }
    },
    destroy() {
      for (const layer of layers) layer.destroy();
    },
  };
}

/** The same bodies as spots of one radius and colour. */
function spots(source: BodySource, balls: Uint32Array, radius: number, color: number): BodySource {
  const size = new Float32Array(source.rows);
  const colors = new Uint32Array(source.rows);
  const shape = new Uint32Array(source.rows);
  for (const id of balls) {
    size[id] = radius;
    colors[id] = color;
    shape[id] = SHAPES.glow;
  }
  return { ...source, ids: source.ids, count: source.count, lastId: source.lastId, size, color: colors, shape };
}
