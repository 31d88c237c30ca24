/** The view: every body as the shape that it has, and, on demand, where bodies touch. */
import { nearestPoint } from '@principia/physics';
import { createBodyLayer } from '@principia/render-pixi';
import { hasCoarsePointer, showHint, type View, type ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { Settings } from './settings.ts';
import type { StackingRun } from './sim.ts';

const TEXT = 'Drag bodies to stack or throw them. C throws a ball, N drops a block, T blows up the middle.';
const TOUCH_TEXT = 'Drag bodies to stack or throw them. The buttons throw a ball, drop a block and blow up the middle.';

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
  const removeHint = showHint(context.element, hasCoarsePointer() ? TOUCH_TEXT : TEXT);
  const destroy = () => {
    removeHint();
    view.destroy();
  };
  return { ...view, destroy };
}
