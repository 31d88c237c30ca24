/** The 2D view: a line for every thread. */
import type { View, ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { ClothPrint } from './cloth-print.ts';
import { createPlay, type Play } from './play.ts';
import type { Settings } from './settings.ts';
import { CLOTH, type ClothRun } from './sim.ts';
import { paintThreads } from './threads-2d.ts';

export async function openView(context: ViewContext<Settings, ClothRun>, print: ClothPrint): Promise<View> {
  const reach = { x: 0.6 * CLOTH.columns * CLOTH.spacing, y: 0.75 * CLOTH.rows * CLOTH.spacing };
  const bounds = { minX: -reach.x, minY: -reach.y, maxX: reach.x, maxY: 0.7 * reach.y };
  let play: Play | undefined;
  const view = await openPixiView(context, {
    bounds: () => bounds,
    paint: (sim, source) =>
      paintThreads(sim, source, { print, safeColors: context.safeColors, film: () => play?.film }),
    grabRadius: 3 * CLOTH.spacing,
  });
  const place = (node: number) => {
    const { x, y } = context.sim().world.components.Position;
    return view.toScreen(x[node], y[node], 0);
  };
  play = createPlay(context, view.canvas, print, place, (x, y) => ({
    through: { ...view.toWorld(x, y), z: 0 },
    along: { x: 0, y: 0, z: 0 },
  }));
  return {
    ...view,
    refresh(change) {
      view.refresh(change);
      if (change === 'world') play.refresh();
    },
    draw(alpha, seconds) {
      play.update(seconds);
      view.draw(alpha, seconds);
    },
    destroy() {
      play.destroy();
      view.destroy();
    },
  };
}
