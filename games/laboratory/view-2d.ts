/** The view of an example in two dimensions, drawn by pixi.js. */
import { type Example, frameOf } from '@principia/scenes/examples';
import type { Settings, View, ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { LabRun } from './lab-run.ts';
import { disturb, showing, trailing } from './on-display.ts';
import { drawPicture } from './picture-2d.ts';
import { listenToPresses, type Presses, withPresses } from './presses.ts';

/** @param pointer what presses on the picture do, if anything */
export async function openView(context: ViewContext<Settings, LabRun>, pointer: Example['pointer']): Promise<View> {
  let presses: Presses | undefined;
  const aim = () => (pointer?.aims ? presses?.aim() : undefined);
  const view = await openPixiView(context, {
    bounds: ({ picture }) => frameOf(picture).bounds,
    yDown: ({ picture }) => picture.yDown ?? false,
    paint(run, source) {
      const picture = drawPicture(run, source, () => context.values(), aim);
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
  if (pointer === undefined) return showing(view);
  presses = listenToPresses(context, view.canvas, { pointUnder: view.toWorld });
  return showing(withPresses(view, presses));
}
