/** The view of an example in two dimensions, drawn by pixi.js. */
import { frameOf } from '@principia/scenes/examples';
import type { Settings, View, ViewContext } from '@principia/shell';
import { openPixiView } from '@principia/shell/pixi';
import type { LabRun } from './lab-run.ts';
import { showing } from './on-display.ts';
import { drawPicture } from './picture-2d.ts';

export async function openView(context: ViewContext<Settings, LabRun>): Promise<View> {
  const view = await openPixiView(context, {
    bounds: ({ picture }) => frameOf(picture).bounds,
    yDown: ({ picture }) => picture.yDown ?? false,
    paint: (run, source) => drawPicture(run, source, () => context.values()),
  });
  return showing(view);
}
