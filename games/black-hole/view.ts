/** The view: the picture, the text over it, and pointer control. */
import { toScreen, watchViewport } from '@principia/render-core';
import { openScreen } from '@principia/render-pixi';
import { BLACK_HOLE } from '@principia/scenes';
import { type Insets, listenToSteering, type View, type ViewContext } from '@principia/shell';
import { Container, RendererType, type Texture } from 'pixi.js';
import { type Comparison, Ghost } from './ghost.ts';
import { createHud, type Frame, type Hud } from './hud.ts';
import { paletteOf } from './palette.ts';
import { createPicture, type Picture } from './picture.ts';
import { reached, type Settings } from './settings.ts';
import type { BlackHoleGame } from './sim.ts';
import { createSounds, type Sounds } from './sounds.ts';
import { StageCamera } from './stage-camera.ts';
import { paintSky, paintSpot } from './stars.ts';

const { width: STAGE_WIDTH, height: STAGE_HEIGHT } = BLACK_HOLE;

export async function openView(context: ViewContext<Settings, BlackHoleGame>): Promise<View> {
  const screen = await openScreen(context.element, { background: '#04060e', antialias: true });
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const [sky, spot] = [paintSky(5), paintSpot()];
  const ghost = new Ghost();
  const paint = () => paintGame(context, content, { sky, spot, ghost, canBend: renderer.type === RendererType.WEBGL });
  let picture = paint();
  let shownEvents = 0;
  const hud = openHud(context);
  const stage = new StageCamera();
  const { camera } = stage;
  const viewport = watchViewport(canvas, (width, height, resolution) => {
    renderer.resize(width, height, resolution);
  });
  const shown = { x: 0, y: 0 };
  const place = (x: number, y: number) => toScreen(camera, viewport, x, y, shown);
  const sounds = createSounds();
  const compare = () => compareFlight(context, ghost);
  const frame = { left: 0, top: 0, width: 0, height: 0, room: 0 };
  const steering = listenToSteering(canvas, {
    craft: () => place(picture.ship[0], picture.ship[1]),
    steer: (x, y) => context.sim().steer(x, y),
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
      const insets = context.insets();
      stage.update(insets, viewport, picture.ship[0], seconds);
      shownEvents = showEvents(sim, shownEvents, { picture, hud, sounds, compare });
      sounds.update(sim, context.values().sound);
      picture.update(alpha, seconds, camera, viewport);
      steering.update();
      setFrame(frame, place(0, STAGE_HEIGHT), camera.pixelsPerMetre, insets, viewport.width);
      hud.update(sim, frame);
      screen.render();
    },
    fit() {
      stage.zoom = 1;
    },
    zoom(factor) {
      stage.zoom = Math.min(4, Math.max(0.5, stage.zoom * factor));
    },
    toScreen: place,
    destroy() {
      steering.destroy();
      sounds.destroy();
      viewport.destroy();
      hud.destroy();
      picture.destroy();
      ghost.container.destroy({ children: true, context: true });
      screen.destroy();
      sky.destroy(true);
      spot.destroy(true);
    },
  };
}

function openHud(context: ViewContext<Settings, BlackHoleGame>): Hud {
  return createHud(
    context.element,
    () => paletteOf(context.safeColors),
    () => context.sim().press('redraw'),
  );
}

/** Compares a flight that has reached the goal with the ghost's, unless the player does not want to see it. */
function compareFlight(context: ViewContext<Settings, BlackHoleGame>, ghost: Ghost): Comparison | undefined {
  const comparison = ghost.finish(context.sim());
  return context.values().ghost ? comparison : undefined;
}

function paintGame(
  context: ViewContext<Settings, BlackHoleGame>,
  parent: Container,
  shared: { readonly sky: Texture; readonly spot: Texture; readonly ghost: Ghost; readonly canBend: boolean },
): Picture {
  const isCalm = context.reducedMotion;
  const palette = paletteOf(context.safeColors);
  const picture = createPicture({ sim: context.sim(), parent, ...shared, isCalm, palette });
  picture.show(context.values());
  return picture;
}

interface EventDisplay {
  readonly picture: Picture;
  readonly hud: Hud;
  readonly sounds: Sounds;
  /** Compares a flight that has reached the goal with the best one. */
  compare(): Comparison | undefined;
}

/** Shows the events since the first `shownCount`. @returns the number of events so far */
function showEvents(sim: BlackHoleGame, shownCount: number, { picture, hud, sounds, compare }: EventDisplay): number {
  const { events, eventCount } = sim.rules;
  const newCount = Math.max(0, Math.min(events.length, eventCount - shownCount));
  for (let i = events.length - newCount; i < events.length; i++) {
    picture.celebrate(events[i]);
    hud.toast(events[i], sim, events[i].kind === 'goal' ? compare() : undefined);
    if (events[i].kind === 'goal') reached.note(sim);
    if (!sim.isDemo) sounds.play(events[i]);
  }
  return eventCount;
}

/** Computes the part of the window that the stage fills. @param corner upper left corner of the stage */
function setFrame(
  frame: Mutable<Frame>,
  corner: { x: number; y: number },
  pixelsPerMetre: number,
  { top, left, right }: Insets,
  windowWidth: number,
): void {
  frame.left = Math.max(left, corner.x);
  frame.top = corner.y;
  frame.width = Math.min(windowWidth - right, corner.x + STAGE_WIDTH * pixelsPerMetre) - frame.left;
  frame.height = STAGE_HEIGHT * pixelsPerMetre;
  frame.room = corner.y - top;
}

type Mutable<T> = { -readonly [Name in keyof T]: T[Name] };
