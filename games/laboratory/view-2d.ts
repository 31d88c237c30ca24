/** The view of an example in two dimensions, drawn by pixi.js. */
import { toWorld } from '@principia/render-core';
import { type Example, frameOf, type Point } from '@principia/scenes/examples';
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
  presses = listenToPresses(context, view.canvas, { pointUnder: (x, y, run) => pointUnder(view, x, y, run) });
  return showing(withPresses(view, presses));
}

function pointUnder(view: View, x: number, y: number, { picture }: LabRun): Point {
  const [centreX, centreY, metres] = view.camera?.() ?? [0, 0, 1];
  const { width, height } = view.canvas.getBoundingClientRect();
  const up = picture.yDown ? -1 : 1;
  const camera = { x: centreX, y: up * centreY, pixelsPerMetre: height / metres };
  const at = toWorld(camera, { width, height }, x, y, { x: 0, y: 0 });
  return { x: at.x, y: up * at.y };
}
