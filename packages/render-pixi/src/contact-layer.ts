import { type ContactPoints, contactPoints, type PhysicsWorld } from '@principia/physics';
import { checkOptions, type OptionNames, worldOf } from '@principia/render-core';
import { Container } from 'pixi.js';
import { groupColor } from './group-colors.ts';
import { createSegmentLayer } from './segment-layer.ts';

/** Options of a contact layer. */
export interface ContactLayerOptions {
  /** A world with the preset `rigidBodies`. */
  world: PhysicsWorld;
  /** Pixels of the layer's own coordinates per metre; default 1, which is what `applyCamera` expects. */
  pixelsPerMetre?: number;
  /** Diameter of a point, CSS pixels; default 5. */
  pointSize?: number;
  /** Length of a normal, m; default 0.25. */
  normalLength?: number;
  /** Colour of points, as 0xRRGGBB; default 0xff5050. */
  pointColor?: number;
  /** Colour of normals, as 0xRRGGBB; default 0xffd060. */
  normalColor?: number;
  /** Whether points that the solver takes side by side have one colour; default false. */
  byColor?: boolean;
}

/** Contact points of rigid bodies and their normals, for looking into a simulation. */
export interface ContactLayer {
  /** Add it anywhere, as that of a body layer. */
  readonly container: Container;
  /** Draws the contacts of the last step, where the bodies are now; call it once a frame before rendering. */
  update(): void;
  /** Frees the layer's resources and removes it from its parent. */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<ContactLayerOptions> = {
  world: true,
  pixelsPerMetre: true,
  pointSize: true,
  normalLength: true,
  pointColor: true,
  normalColor: true,
  byColor: true,
};

/**
 * Creates a layer that shows where rigid bodies touch.
 * @throws Error when there is no world, or an option is out of range or does not exist
 */
export function createContactLayer(options: ContactLayerOptions): ContactLayer {
  const world = worldOf(options, 'createContactLayer');
  checkOptions(options, OPTION_NAMES, 'createContactLayer');
  const { pixelsPerMetre = 1, pointSize = 5, normalLength = 0.25 } = options;
  const { pointColor = 0xff5050, normalColor = 0xffd060, byColor = false } = options;
  const normals = createSegmentLayer({ pixelsPerMetre, thickness: 1.5, color: normalColor });
  const points = createSegmentLayer({ pixelsPerMetre, thickness: pointSize, color: pointColor });
  const container = new Container({
    label: 'principia-contacts',
    children: [normals.container, points.container],
  });
  const lines: number[] = [];
  const colors: number[] = [];
  let list: ContactPoints | undefined;
  let live = true;

  return {
    container,
    update() {
      list = contactPoints(world, list);
      const { count, x, y } = list;
      writeLines(lines, list, normalLength);
      normals.set(lines, count);
      // A line without length is a dot.
      for (let i = 0; i < count; i++) {
        lines[4 * i + 2] = x[i];
        lines[4 * i + 3] = y[i];
        colors[i] = byColor ? groupColor(list.color[i]) : 0;
      }
      points.set(lines, count, colors);
    },
    destroy() {
      if (!live) return;
      live = false;
      normals.destroy();
      points.destroy();
      container.destroy();
    },
  };
}

/** The ends of each normal, which starts at its point. */
function writeLines(lines: number[], { count, x, y, nx, ny }: ContactPoints, length: number): void {
  for (let i = 0; i < count; i++) {
    lines[4 * i] = x[i];
    lines[4 * i + 1] = y[i];
    lines[4 * i + 2] = x[i] + length * nx[i];
    lines[4 * i + 3] = y[i] + length * ny[i];
  }
}
