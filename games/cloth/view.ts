/** The picture: a line for every thread. The lines follow the bodies by themselves, and change only where threads break. */
import { rgba } from '@principia/physics';
import type { BodySource } from '@principia/render-core';
import { createLinkLayer } from '@principia/render-pixi';
import type { Stage, View } from '@principia/shell';
import { openPixiView, type Picture } from '@principia/shell/pixi';
import { query } from 'bitecs';
import type { Settings } from './settings.ts';
import { brokenThreads, CLOTH, type ClothRun } from './sim.ts';

export function openView(stage: Stage<Settings, ClothRun>): Promise<View> {
  const reach = { x: 0.6 * CLOTH.columns * CLOTH.spacing, y: 0.75 * CLOTH.rows * CLOTH.spacing };
  const bounds = { minX: -reach.x, minY: -reach.y, maxX: reach.x, maxY: 0.7 * reach.y };
  return openPixiView(stage, { bounds: () => bounds, paint, hand: 3 * CLOTH.spacing });
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

/** The two bodies of every thread that is whole, and its colour. */
function threadsOf({ world, cloth }: ClothRun) {
  const { Spring } = world.components;
  const threads = [...query(world, [Spring])];
  return {
    pairs: threads.flatMap((thread) => [Spring.a[thread], Spring.b[thread]]),
    colors: threads.map((thread) => colorOf((Spring.a[thread] - cloth.nodes[0]) / cloth.nodes.length)),
  };
}

/** From amber at the top (0) to rose at the hem (1). */
function colorOf(down: number): number {
  return rgba(1, 0.75 - 0.43 * down, 0.35 + 0.27 * down, 0.9);
}
