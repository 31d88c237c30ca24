/** The 2D view, drawn by pixi.js. */
import type { BodySource } from '@principia/render-core';
import { type BodyLayer, createBodyLayer, createTrailLayer, type TrailLayer } from '@principia/render-pixi';
import type { BouncingBalls } from '@principia/scenes';
import type { View, ViewContext } from '@principia/shell';
import { openPixiView, type Picture } from '@principia/shell/pixi';
import { Container } from 'pixi.js';
import { longestMove } from './longest-move.ts';
import { createPlay } from './play.ts';
import { createRoom2D } from './room-2d.ts';
import type { Settings } from './settings.ts';
import { createShading } from './shading.ts';
import type { BallsRun } from './sim.ts';

/** Number of balls with trails; more would hide each other. */
const MAX_TRAILS = 2000;

export async function openView2D(context: ViewContext<Settings, BallsRun>): Promise<View> {
  const view = await openPixiView(context, {
    bounds: ({ room: { min, max } }) => ({ minX: min.x, minY: min.y, maxX: max.x, maxY: max.y }),
    paint: (sim, source) => paint(sim, source, () => context.values().trails),
  });
  const play = createPlay(context, view.canvas, (x, y) => ({ ...view.toWorld(x, y), z: 0 }));
  return {
    ...view,
    draw(alpha, seconds) {
      play.update();
      view.draw(alpha, seconds);
    },
    refresh(change) {
      view.refresh(change);
      if (change === 'world') play.refresh();
    },
    destroy() {
      play.destroy();
      view.destroy();
    },
  };
}

function paint(sim: BouncingBalls, source: BodySource, wantsTrails: () => boolean): Picture {
  const room = createRoom2D(sim);
  const shading = createShading(sim);
  // Without shading, balls have no mark and rotation is invisible.
  const layer: BodyLayer = createBodyLayer({ source, rotation: shading !== undefined, minimumPixels: 0.8 });
  const trailParent = new Container();
  let trails: TrailLayer | undefined;
  const parts = [room.ground, trailParent, shading?.below, layer.container, shading?.above, room.walls];
  const root = new Container({ children: parts.filter((part) => part !== undefined) });
  const showTrails = (shown: boolean) => {
    if (shown === (trails !== undefined)) return;
    trails?.destroy();
    trails = shown
      ? createTrailLayer({
          source,
          bodies: sim.balls.subarray(0, MAX_TRAILS),
          length: 48,
          thickness: Math.min(5, 60 * sim.radius),
          opacity: 0.5,
          blendMode: 'add',
          maxSegment: longestMove(sim),
        })
      : undefined;
    if (trails !== undefined) trailParent.addChild(trails.container);
  };
  showTrails(wantsTrails());
  return {
    container: root,
    refresh: () => showTrails(wantsTrails()),
    update(alpha: number, pixelsPerMetre: number) {
      trails?.update(alpha);
      shading?.update(alpha, pixelsPerMetre);
      layer.update(alpha);
    },
    destroy() {
      showTrails(false);
      shading?.destroy();
      layer.destroy();
      room.destroy();
      root.destroy({ children: true, context: true });
    },
  };
}
