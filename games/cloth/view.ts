/**
 * The view: a line for every thread. The lines follow the bodies; the list of lines changes only when threads break.
 */
import { rgba } from '@principia/physics';
import type { BodySource } from '@principia/render-core';
import { createLinkLayer } from '@principia/render-pixi';
import type { View, ViewContext } from '@principia/shell';
import { openPixiView, type Picture } from '@principia/shell/pixi';
import { query } from 'bitecs';
import type { Settings } from './settings.ts';
import { brokenThreads, CLOTH, type ClothRun } from './sim.ts';

export function openView(context: ViewContext<Settings, ClothRun>): Promise<View> {
  const reach = { x: 0.6 * CLOTH.columns * CLOTH.spacing, y: 0.75 * CLOTH.rows * CLOTH.spacing };
  const bounds = { minX: -reach.x, minY: -reach.y, maxX: reach.x, maxY: 0.7 * reach.y };
  return openPixiView(context, { bounds: () => bounds, paint, grabRadius: 3 * CLOTH.spacing });
}

function paint(sim: ClothRun, source: BodySource): Picture {
  const layer = createLinkLayer({ source, thickness: 1.6 });
  let drawn = -1;
  return {
    container: layer.container,
    update(alpha) {
      if (drawn !== brokenThreads(sim)) {
        drawn = brokenThreads(sim);
        const threads = threadsOf(sim);
        layer.set(threads.pairs, threads.colors.length, threads.colors);
      }
      layer.update(alpha);
    },
    destroy: layer.destroy,
  };
}

/** The two bodies of every intact thread, and its colour. */
function threadsOf({ world, cloth }: ClothRun) {
  const { Spring } = world.components;
  const threads = [...query(world, [Spring])];
  return {
    pairs: threads.flatMap((thread) => [Spring.a[thread], Spring.b[thread]]),
    colors: threads.map((thread) => colorOf((Spring.a[thread] - cloth.nodes[0]) / cloth.nodes.length)),
  };
}

/** Colour from amber at the top (0) to rose at the bottom (1). */
function colorOf(depth: number): number {
  return rgba(1, 0.75 - 0.43 * depth, 0.35 + 0.27 * depth, 0.9);
}
