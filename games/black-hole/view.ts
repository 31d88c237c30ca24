/** The view: the picture, what is written over it, and the pointer that steers. */
import { type Camera2D, fit, toScreen, watchViewport } from '@principia/render-core';
import { openScreen } from '@principia/render-pixi';
import { BLACK_HOLE } from '@principia/scenes';
import type { Stage, View } from '@principia/shell';
import { Container, RendererType } from 'pixi.js';
import { createHud } from './hud.ts';
import { paletteOf } from './palette.ts';
import { createPicture, type Picture } from './picture.ts';
import type { Settings } from './settings.ts';
import type { BlackHoleGame } from './sim.ts';
import { paintSky, paintSpot } from './stars.ts';
import { listenToSteering } from './steering.ts';

const MARGIN = 14;
/** Of the touch pad and what lies below it, CSS pixels. */
const PAD_HEIGHT = 250;
const COARSE = matchMedia('(pointer: coarse)');
const { width: STAGE_WIDTH, height: STAGE_HEIGHT } = BLACK_HOLE;

export async function openView(stage: Stage<Settings, BlackHoleGame>): Promise<View> {
  const screen = await openScreen(stage.element, { background: '#04060e', antialias: true });
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const [sky, spot] = [paintSky(5), paintSpot()];
  const canBend = renderer.type === RendererType.WEBGL;
  const paint = (): Picture => {
    const sim = stage.sim();
    const made = createPicture({
      sim,
      parent: content,
      sky,
      spot,
      canBend,
      isCalm: stage.reducedMotion,
      palette: paletteOf(stage.safeColors),
    });
    made.show(stage.values());
    return made;
  };
  let picture = paint();
  let told = 0;
  const hud = createHud(stage.element, () => paletteOf(stage.safeColors));
  const camera: Camera2D = { x: STAGE_WIDTH / 2, y: STAGE_HEIGHT / 2, pixelsPerMetre: 1 };
  let zoomed = 1;
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
  });
  const shown = { x: 0, y: 0 };
  const place = (x: number, y: number) => toScreen(camera, viewport, x, y, shown);
  const frame = { left: 0, top: 0, width: 0, height: 0, room: 0 };
  const steering = listenToSteering(canvas, {
    ship: () => place(picture.ship[0], picture.ship[1]),
    press: (input) => stage.sim().press(input),
  });
  const tellNews = (sim: BlackHoleGame) => {
    const { news, newsCount } = sim.rules;
    const fresh = Math.max(0, Math.min(news.length, newsCount - told));
    for (let i = news.length - fresh; i < news.length; i++) {
      picture.celebrate(news[i]);
      hud.toast(news[i], sim);
    }
    told = newsCount;
  };
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') {
        picture.show(stage.values());
        return;
      }
      picture.destroy();
      picture = paint();
      // What a new game brings is news; other colours are not.
      told = stage.sim().rules.newsCount;
    },
    draw(alpha, seconds) {
      const sim = stage.sim();
      look(camera, stage, viewport, zoomed);
      tellNews(sim);
      picture.update(alpha, seconds, camera, viewport);
      steering.update();
      const { x, y } = place(0, STAGE_HEIGHT);
      const { pixelsPerMetre: scale } = camera;
      frame.left = x;
      frame.top = y;
      frame.width = STAGE_WIDTH * scale;
      frame.height = STAGE_HEIGHT * scale;
      frame.room = y - stage.insets().top;
      hud.update(sim, frame);
      screen.render();
    },
    fit() {
      zoomed = 1;
    },
    zoom(factor) {
      zoomed = Math.min(4, Math.max(0.5, zoomed * factor));
    },
    toScreen: place,
    destroy() {
      steering.destroy();
      viewport.destroy();
      hud.destroy();
      picture.destroy();
      screen.destroy();
      sky.destroy(true);
      spot.destroy(true);
    },
  };
}

const WHOLE_STAGE = { minX: 0, minY: 0, maxX: STAGE_WIDTH, maxY: STAGE_HEIGHT };
const free = { width: 0, height: 0 };

/** Shows the whole stage in the part of the window that nothing covers. */
function look(
  camera: Camera2D,
  stage: Stage<Settings, BlackHoleGame>,
  size: { readonly width: number; readonly height: number },
  zoomed: number,
): void {
  const { top, right, bottom, left } = stage.insets();
  free.width = size.width - left - right;
  free.height = size.height - top - bottom;
  if (!(free.width > 0 && free.height > 0)) return;
  fit(camera, WHOLE_STAGE, free, MARGIN);
  // The touch pad covers the lower right: the stage moves to the upper left.
  if (COARSE.matches) {
    camera.x += (free.width / 2 - MARGIN) / camera.pixelsPerMetre - STAGE_WIDTH / 2;
    camera.y -= (free.height / 2 - MARGIN) / camera.pixelsPerMetre - STAGE_HEIGHT / 2;
    // On a phone held upright there is room above the pad: the stage goes to its middle.
    const spare = free.height - STAGE_HEIGHT * camera.pixelsPerMetre - PAD_HEIGHT;
    if (free.height > free.width && spare > 0) camera.y += spare / 2 / camera.pixelsPerMetre;
  }
  camera.pixelsPerMetre *= zoomed;
  camera.x += (right - left) / 2 / camera.pixelsPerMetre;
  camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
}
