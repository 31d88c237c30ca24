/** The view of an example in two dimensions, drawn by pixi.js. */
import { frameOf } from '@principia/scenes/examples';
import type { Settings, View, ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { LabRun } from './lab-run.ts';
import { disturb, showing, trailing } from './on-display.ts';
import { drawPicture } from './picture-2d.ts';

export async function openView(context: ViewContext<Settings, LabRun>): Promise<View> {
  const view = await openPixiView(context, {
    bounds: ({ picture }) => frameOf(picture).bounds,
    yDown: ({ picture }) => picture.yDown ?? false,
    paint(run, source) {
      const picture = drawPicture(run, source, () => context.values());
      trailing(picture.recordTrails);
      return {
        ...picture,
        update(alpha, pixelsPerMetre) {
          if (context.dragging().dragged.length > 0) disturb(run);
          picture.update(alpha, pixelsPerMetre);
        },
      };
    },
  });
  return showing(view);
}
