/** The view: the picture, the text over it, and pointer control. */
import { type Camera2D, fit, toScreen, watchViewport } from '@principia/render-core';
import { openScreen } from '@principia/render-pixi';
import { BLACK_HOLE } from '@principia/scenes';
import type { View, ViewContext } from '@principia/shell';
import { Container, RendererType, type Texture } from 'pixi.js';
import { createHud, type Frame, type Hud } from './hud.ts';
import { paletteOf } from './palette.ts';
import { createPicture, type Picture } from './picture.ts';
import type { Settings } from './settings.ts';
import type { BlackHoleGame } from './sim.ts';
import { paintSky, paintSpot } from './stars.ts';
import { listenToSteering } from './steering.ts';

const MARGIN = 14;
/** Height of the touch pad and its margin, CSS pixels. */
const PAD_HEIGHT = 250;
const COARSE = matchMedia('(pointer: coarse)');
const { width: STAGE_WIDTH, height: STAGE_HEIGHT } = BLACK_HOLE;

export async function openView(context: ViewContext<Settings, BlackHoleGame>): Promise<View> {
  const screen = await openScreen(context.element, { background: '#04060e', antialias: true });
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const [sky, spot] = [paintSky(5), paintSpot()];
  const paint = () => paintGame(context, content, sky, spot, renderer.type === RendererType.WEBGL);
  let picture = paint();
  let shownEvents = 0;
  const hud = createHud(context.element, () => paletteOf(context.safeColors));
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
    press: (input) => context.sim().press(input),
  });
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') {
        picture.show(context.values());
        return;
      }
      picture.destroy();
      picture = paint();
      // Events of a new game are new; a palette change repeats none.
      shownEvents = context.sim().rules.eventCount;
    },
    draw(alpha, seconds) {
      const sim = context.sim();
      fitCamera(camera, context, viewport, zoomed);
      shownEvents = showEvents(sim, shownEvents, picture, hud);
      picture.update(alpha, seconds, camera, viewport);
      steering.update();
      setFrame(frame, place(0, STAGE_HEIGHT), camera.pixelsPerMetre, context.insets().top);
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

function paintGame(
  context: ViewContext<Settings, BlackHoleGame>,
  parent: Container,
  sky: Texture,
  spot: Texture,
  canBend: boolean,
): Picture {
  const isCalm = context.reducedMotion;
  const palette = paletteOf(context.safeColors);
  const picture = createPicture({ sim: context.sim(), parent, sky, spot, canBend, isCalm, palette });
  picture.show(context.values());
  return picture;
}

/** Shows the events since the first `shownCount`. @returns the number of events so far */
function showEvents(sim: BlackHoleGame, shownCount: number, picture: Picture, hud: Hud): number {
  const { events, eventCount } = sim.rules;
  const newCount = Math.max(0, Math.min(events.length, eventCount - shownCount));
  for (let i = events.length - newCount; i < events.length; i++) {
    picture.celebrate(events[i]);
    hud.toast(events[i], sim);
  }
  return eventCount;
}

/** Computes the frame of the stage on the canvas. @param corner its upper left corner @param top inset of the window */
function setFrame(frame: Mutable<Frame>, corner: { x: number; y: number }, pixelsPerMetre: number, top: number): void {
  frame.left = corner.x;
  frame.top = corner.y;
  frame.width = STAGE_WIDTH * pixelsPerMetre;
  frame.height = STAGE_HEIGHT * pixelsPerMetre;
  frame.room = corner.y - top;
}

type Mutable<T> = { -readonly [Name in keyof T]: T[Name] };

const WHOLE_STAGE = { minX: 0, minY: 0, maxX: STAGE_WIDTH, maxY: STAGE_HEIGHT };
const free = { width: 0, height: 0 };

/** Fits the stage into the part of the window that nothing covers. */
function fitCamera(
  camera: Camera2D,
  context: ViewContext<Settings, BlackHoleGame>,
  size: { readonly width: number; readonly height: number },
  zoomed: number,
): void {
  const { top, right, bottom, left } = context.insets();
  free.width = size.width - left - right;
  free.height = size.height - top - bottom;
  if (!(free.width > 0 && free.height > 0)) return;
  fit(camera, WHOLE_STAGE, free, MARGIN);
  // The touch pad covers the lower right, so the stage moves to the upper left.
  if (COARSE.matches) {
    camera.x += (free.width / 2 - MARGIN) / camera.pixelsPerMetre - STAGE_WIDTH / 2;
    camera.y -= (free.height / 2 - MARGIN) / camera.pixelsPerMetre - STAGE_HEIGHT / 2;
    // On a phone in portrait the stage is centred in the space above the pad.
    const spare = free.height - STAGE_HEIGHT * camera.pixelsPerMetre - PAD_HEIGHT;
    if (free.height > free.width && spare > 0) camera.y += spare / 2 / camera.pixelsPerMetre;
  }
  camera.pixelsPerMetre *= zoomed;
  camera.x += (right - left) / 2 / camera.pixelsPerMetre;
  camera.y += (top - bottom) / 2 / camera.pixelsPerMetre;
}
