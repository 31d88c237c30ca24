/** The view of an example in three dimensions, drawn by three.js. */
import type { Example, Picture } from '@principia/scenes/examples';
import type { Settings, View, ViewContext } from '@principia/shell';
import { type BoxBounds, openThreeView } from '@principia/shell/three';
import type { LabRun } from './lab-run.ts';
import { disturb, showing, trailing } from './on-display.ts';
import { drawPicture3D } from './picture-3d.ts';
import { listenToPresses, withPresses } from './presses.ts';

/** From the right above in front. */
const DIRECTION = { x: 0.5, y: 0.35, z: 1 };

/** A press that stays for so long is no drag that turns the view, ms. */
const PATIENCE = 200;

/** @param pointer what presses on the picture do, if anything */
export async function openView3D(context: ViewContext<Settings, LabRun>, pointer: Example['pointer']): Promise<View> {
  const view = await openThreeView(context, {
    bounds: ({ picture }) => boxOf(picture),
    path: ({ picture }) => picture.cameraPath,
    direction: directionOf(context.sim().picture),
    paint(run, source) {
      const picture = drawPicture3D(run, source, () => context.values());
      trailing(picture.recordTrails);
      return {
        ...picture,
        update(alpha) {
          if (context.dragging().dragged.length > 0) disturb(run);
          picture.update(alpha);
        },
      };
    },
  });
  if (pointer === undefined) return showing(view);
  const { canvas, pointUnder } = view;
  return showing(withPresses<View>(view, listenToPresses(context, canvas, { pointUnder, patience: PATIENCE })));
}

function directionOf({ camera }: Picture) {
  if (camera === undefined) return DIRECTION;
  const { eye, target } = camera;
  return { x: eye.x - target.x, y: eye.y - target.y, z: (eye.z ?? 0) - (target.z ?? 0) };
}

/** As deep as the view is wide or high, whichever is less, unless it says how deep it is. */
function boxOf({ view }: Picture): BoxBounds {
  const { minX, maxX, minY, maxY } = view;
  const depth = Math.min(maxX - minX, maxY - minY) / 2;
  return {
    min: { x: minX, y: minY, z: view.minZ ?? -depth },
    max: { x: maxX, y: maxY, z: view.maxZ ?? depth },
  };
}
