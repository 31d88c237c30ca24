/** The view: every body as the shape that it has, and, on demand, where bodies touch. */
import { nearestPoint } from '@principia/physics';
import { createBodyLayer } from '@principia/render-pixi';
import type { View, ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import { showHint } from './hint.ts';
import type { Settings } from './settings.ts';
import type { StackingRun } from './sim.ts';

/** Layers of bodies that can be taken: not that of the ground. */
const TAKEN = 1;

export async function openView(context: ViewContext<Settings, StackingRun>): Promise<View> {
  const view = await openPixiView(context, {
    bounds: (sim) => sim.bounds,
    pick: ({ world }, { x, y }, slack) => nearestPoint(world, { x, y }, { mask: TAKEN, maxDistance: slack })?.body ?? 0,
    paint(_, source) {
      const layer = createBodyLayer({ source, rimWidth: 1, minimumPixels: 1 });
      return { container: layer.container, update: layer.update, destroy: layer.destroy };
    },
  });
  const removeHint = showHint(context.element);
  const destroy = () => {
    removeHint();
    view.destroy();
  };
  return { ...view, destroy };
}
