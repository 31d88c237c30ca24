/**
 * The 2D view: a line for every thread. The lines follow the bodies; the list of lines changes only when threads break or
 * are cut.
 */
import { rgba } from '@principia/physics';
import type { BodySource } from '@principia/render-core';
import { createLinkLayer } from '@principia/render-pixi';
import type { View, ViewContext } from '@principia/shell';
import { openPixiView, type Picture } from '@principia/shell/pixi';
import { query } from 'bitecs';
import { colorAt } from './colors.ts';
import type { Settings } from './settings.ts';
import { CLOTH, type ClothRun, threadCount } from './sim.ts';
import { listenToSwipes } from './swipes.ts';

export async function openView(context: ViewContext<Settings, ClothRun>): Promise<View> {
  const reach = { x: 0.6 * CLOTH.columns * CLOTH.spacing, y: 0.75 * CLOTH.rows * CLOTH.spacing };
  const bounds = { minX: -reach.x, minY: -reach.y, maxX: reach.x, maxY: 0.7 * reach.y };
  const view = await openPixiView(context, {
    bounds: () => bounds,
    paint: (sim, source) => paint(sim, source, context.safeColors),
    grabRadius: 3 * CLOTH.spacing,
  });
  const place = (node: number) => {
    const { x, y } = context.sim().world.components.Position;
    return view.toScreen(x[node], y[node], 0);
  };
  const stopSwipes = listenToSwipes(context, view.canvas, place);
  const destroy = () => {
    stopSwipes();
    view.destroy();
  };
  return { ...view, destroy };
}

function paint(sim: ClothRun, source: BodySource, safeColors: boolean): Picture {
  const layer = createLinkLayer({ source, thickness: 1.6 });
  let drawn = -1;
  return {
    container: layer.container,
    update(alpha) {
      if (drawn !== threadCount(sim)) {
        drawn = threadCount(sim);
        const threads = threadsOf(sim, safeColors);
        layer.set(threads.pairs, threads.colors.length, threads.colors);
      }
      layer.update(alpha);
    },
    destroy: layer.destroy,
  };
}

/** The two bodies of every intact thread, and its colour. */
function threadsOf({ world, cloth }: ClothRun, safeColors: boolean) {
  const { Spring } = world.components;
  const threads = [...query(world, [Spring])];
  return {
    pairs: threads.flatMap((thread) => [Spring.a[thread], Spring.b[thread]]),
    colors: threads.map((thread) => {
      const depth = (Spring.a[thread] - cloth.nodes[0]) / cloth.nodes.length;
      return rgba(...colorAt(depth, safeColors), 0.9);
    }),
  };
}
