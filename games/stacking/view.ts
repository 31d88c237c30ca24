/** The view: every body as the shape that it has, its joints, and the tools with which a pointer works on them. */

import { nearestPoint } from '@principia/physics';
import { placeOnCanvas } from '@principia/render-core';
import { createBodyLayer } from '@principia/render-pixi';
import { copyLink, listenToTaps, showHint, type View, type ViewContext } from '@principia/shell';
import { openPixiView, type PixiView } from '@principia/shell/pixi';
import { Container } from 'pixi.js';
import { cutAlong } from './cut.ts';
import { createInsideLayers } from './inside-layers.ts';
import { join } from './join.ts';
import { createJointMarks } from './joint-marks.ts';
import { sceneOf } from './saved-scene.ts';
import { writeScene } from './scene-link.ts';
import type { Settings } from './settings.ts';
import type { StackingRun } from './sim.ts';
import { createPalette } from './tools.ts';
import { WORDS } from './words.ts';

/** Layers of bodies that can be taken: not that of the ground. */
const TAKEN = 1;

export async function openView(context: ViewContext<Settings, StackingRun>): Promise<View> {
  const palette = createPalette(
    context.element,
    () => void share(context),
    (text) => context.showMessage(text),
  );
  const view = await openPixiView(context, {
    bounds: (sim) => sim.bounds,
    pick({ world }, { x, y }, slack) {
      if (palette.tool !== 'drag') return 0;
      return nearestPoint(world, { x, y }, { mask: TAKEN, walls: false, maxDistance: slack })?.body ?? 0;
    },
    paint({ world }, source) {
      const layer = createBodyLayer({ source, rimWidth: 1, minimumPixels: 1 });
      const marks = createJointMarks(world);
      const inside = createInsideLayers(world);
      return {
        container: new Container({ children: [layer.container, marks.container, inside.container] }),
        update(alpha, pixelsPerMetre) {
          layer.update(alpha);
          marks.update(alpha, pixelsPerMetre);
          inside.update(context.values().layer);
        },
        destroy() {
          layer.destroy();
          marks.destroy();
          inside.destroy();
        },
      };
    },
  });
  const stopTools = listenToTools(context, view, () => palette.tool);
  const removeHint = showHint(context.element, WORDS.hint);
  const destroy = () => {
    stopTools();
    removeHint();
    palette.destroy();
    view.destroy();
  };
  return { ...view, destroy };
}

/** Taps make joints, swipes cut. @returns a function that stops listening */
function listenToTools(context: ViewContext<Settings, StackingRun>, view: PixiView, tool: () => string): () => void {
  const { canvas } = view;
  const stopTaps = listenToTaps(canvas, (x, y) => {
    const name = tool();
    if (name === 'drag' || name === 'cut') return;
    const joint = join(context.sim().world, name as 'hinge' | 'motor' | 'weld', view.toWorld(x, y));
    if (joint === 0) context.showMessage(WORDS.nothingToJoin);
  });
  const stop = new AbortController();
  const { signal } = stop;
  const starts = new Map<number, { x: number; y: number }>();
  const locate = (event: PointerEvent) => {
    const { x, y } = placeOnCanvas(canvas, event);
    return view.toWorld(x, y);
  };
  const down = (event: PointerEvent) => {
    if (tool() === 'cut' && event.button === 0) starts.set(event.pointerId, locate(event));
  };
  const up = (event: PointerEvent) => {
    const start = starts.get(event.pointerId);
    if (start !== undefined && starts.size === 1) cutAlong(context.sim().world, start, locate(event));
    starts.delete(event.pointerId);
  };
  canvas.addEventListener('pointerdown', down, { signal });
  canvas.addEventListener('pointerup', up, { signal });
  canvas.addEventListener('pointercancel', ({ pointerId }) => starts.delete(pointerId), { signal });
  return () => {
    stopTaps();
    stop.abort();
  };
}

async function share(context: ViewContext<Settings, StackingRun>): Promise<void> {
  const { world, ground } = context.sim();
  try {
    const link = new URL(location.href);
    link.hash = `scene=${await writeScene(sceneOf(world, ground))}`;
    context.showMessage(await copyLink(link.href, WORDS.yourScene));
  } catch (error) {
    context.showMessage((error as Error).message);
  }
}
