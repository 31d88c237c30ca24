/** Soft shadows and highlights of balls: two more layers that read the same positions. */
import { type BodySource, SHAPES, worldSource } from '@principia/render-core';
import { type BodyLayer, createBodyLayer } from '@principia/render-pixi';
import type { BouncingBalls } from '@principia/scenes';
import type { Container } from 'pixi.js';

/** Smaller balls are drawn flat, CSS pixels. */
const MIN_SHADED_PIXELS = 3;
/** With more balls than this, each is too small for shading. */
const MAX_SHADED = 5000;

/** Two layers that make flat discs look like spheres. */
export interface Shading {
  readonly below: Container;
  readonly above: Container;
  update(alpha: number, pixelsPerMetre: number): void;
  destroy(): void;
}

export function createShading({ world, balls, radius }: BouncingBalls): Shading | undefined {
  if (balls.length > MAX_SHADED) return undefined;
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
      const visible = radius * pixelsPerMetre >= MIN_SHADED_PIXELS;
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

/** A body source in which the same bodies are spots of a given radius and colour. */
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
