/** The 3D view, drawn by three.js. */
import type { BodySource } from '@principia/render-core';
import { createBodyMesh, createTrailLines, type TrailLines } from '@principia/render-three';
import type { View, ViewContext } from '@principia/shell';
import { openThreeView, type ThreePicture } from '@principia/shell/three';
import { Group, MeshStandardMaterial } from 'three';
import { longestMove } from './longest-move.ts';
import { createPlay } from './play.ts';
import { createRoom3D } from './room-3d.ts';
import type { Settings } from './settings.ts';
import type { BallsRun } from './sim.ts';

/**
 * Number of balls up to which lights and shadows are real; more balls use a cheaper shading that moves with the camera.
 */
const MAX_LIT = 3000;
const MAX_TRAILS = 2000;

export async function openView3D(context: ViewContext<Settings, BallsRun>): Promise<View> {
  const view = await openThreeView(context, {
    bounds: ({ room }) => room,
    direction: { x: 0.36, y: 0.2, z: 1 },
    shadows: true,
    paint: (sim, source) => createPicture(sim, source, () => context.values().trails),
  });
  const play = createPlay(context, view.canvas, view.pointUnder);
  return {
    ...view,
    refresh(change) {
      view.refresh(change);
      if (change === 'world') play.refresh();
    },
    draw(alpha, seconds) {
      play.update();
      view.draw(alpha, seconds);
    },
    destroy() {
      play.destroy();
      view.destroy();
    },
  };
}

/** The drawing of one world. */
function createPicture(sim: BallsRun, source: BodySource, hasTrails: () => boolean): ThreePicture {
  const isLit = sim.balls.length <= MAX_LIT;
  const room = createRoom3D(sim, isLit);
  const mesh = createBodyMesh({
    source,
    ...(isLit
      ? { material: new MeshStandardMaterial({ roughness: 0.38 }), castShadow: true, receiveShadow: true }
      : {}),
  });
  const object = new Group().add(room.object, mesh.object);
  let trails: TrailLines | undefined;
  const showTrails = (shown: boolean) => {
    if (shown === (trails !== undefined)) return;
    if (trails !== undefined) object.remove(trails.object);
    trails?.destroy();
    const bodies = sim.balls.subarray(0, MAX_TRAILS);
    const style = { length: 48, width: 2.5, opacity: 0.55, maxSegment: longestMove(sim) };
    trails = shown ? createTrailLines({ source, bodies, ...style }) : undefined;
    if (trails !== undefined) object.add(trails.object);
  };
  showTrails(hasTrails());
  return {
    object,
    refresh: () => showTrails(hasTrails()),
    update(alpha) {
      trails?.update(alpha);
      mesh.update(alpha);
    },
    destroy() {
      showTrails(false);
      mesh.destroy();
      room.destroy();
    },
  };
}
