/** The view: a camera that follows the boat, the sea, and the gauges. */
import 'pixi.js/graphics';
import { type Camera2D, toScreen, watchViewport } from '@principia/render-core';
import { applyCamera, openScreen } from '@principia/render-pixi';
import { listenToSteering, listenToTaps, Synth, type View, type ViewContext } from '@principia/shell';
import { Container } from 'pixi.js';
import { createBoatPicture } from './boat-picture.ts';
import { createEchoPicture } from './echo-picture.ts';
import { createHud } from './hud.ts';
import { paintSea, paintShip } from './sea-picture.ts';
import type { Settings } from './settings.ts';
import type { SubmarineGame } from './sim.ts';

/** Height and least width of the sea in view, m. */
const VISIBLE = { height: 92, width: 100 } as const;
/** Highest point at which the camera looks, m: the sky is dull. */
const HIGHEST_VIEW = -24;
/** Time constant with which the camera follows, s. */
const FOLLOW_TIME = 0.35;

export async function openView(context: ViewContext<Settings, SubmarineGame>): Promise<View> {
  const screen = await openScreen(context.element, { background: '#030e1a', antialias: true });
  const { canvas, renderer } = screen;
  const content = new Container();
  screen.stage.addChild(content);
  const camera: Camera2D = { x: 50, y: HIGHEST_VIEW, pixelsPerMetre: 8 };
  let zoom = 1;
  const viewport = watchViewport(canvas, (width, height, resolution) => renderer.resize(width, height, resolution));
  let picture = paint(context.sim(), content);
  const hud = createHud(context);
  const sounds = createSounds();
  const place = { x: 0, y: 0 };
  const steering = listenToSteering(canvas, {
    craft() {
      const { world, sub } = context.sim();
      return toScreen(camera, viewport, world.components.Position.x[sub], world.components.Position.y[sub], place);
    },
    steer: (x, y) => context.sim().steer(x, y),
  });
  const stopTaps = listenToTaps(canvas, () => context.sim().ping());
  const state = { turn: 0 };
  return {
    canvas,
    refresh(change) {
      if (change === 'setting') return;
      picture.destroy();
      picture = paint(context.sim(), content);
    },
    draw(alpha, seconds) {
      const sim = context.sim();
      const { Position } = sim.world.components;
      const before = sim.world.previous.Position;
      const x = before.x[sim.sub] + alpha * (Position.x[sim.sub] - before.x[sim.sub]);
      const y = before.y[sim.sub] + alpha * (Position.y[sim.sub] - before.y[sim.sub]);
      state.turn += 14 * seconds * Math.abs(sim.boat.engine);
      picture.boat.update(x, y, sim.boat.fill, sim.tilt, state.turn);
      picture.echo.update(sim, context.values().floodlight);
      const { top, right } = context.insets();
      const width = viewport.width - right;
      camera.pixelsPerMetre = zoom * Math.min(viewport.height / VISIBLE.height, Math.max(width / VISIBLE.width, 3.4));
      const share = 1 - Math.exp(-seconds / FOLLOW_TIME);
      camera.x += share * (x + right / 2 / camera.pixelsPerMetre - camera.x);
      camera.y += share * (Math.min(y, HIGHEST_VIEW) + top / 2 / camera.pixelsPerMetre - camera.y);
      applyCamera(content, camera, viewport);
      steering.update();
      hud.update(sim);
      sounds(sim, context.values().sound);
      screen.render();
    },
    fit() {
      zoom = 1;
    },
    zoom(factor) {
      zoom = Math.min(3, Math.max(0.5, zoom * factor));
    },
    toScreen: (x, y) => toScreen(camera, viewport, x, y, { x: 0, y: 0 }),
    destroy() {
      stopTaps();
      steering.destroy();
      sounds.destroy();
      hud.destroy();
      viewport.destroy();
      picture.destroy();
      screen.destroy();
    },
  };
}

function paint({ sea }: SubmarineGame, parent: Container) {
  const boat = createBoatPicture();
  const echo = createEchoPicture();
  const root = new Container({ children: [paintSea(sea), paintShip(), echo.graphics, boat.container] });
  // Pixi's y axis points down.
  root.scale.y = -1;
  parent.addChild(root);
  return { boat, echo, destroy: () => root.destroy({ children: true, context: true }) };
}

/** A ping, a crate, a knock, the end. */
function createSounds() {
  const synth = new Synth();
  let [ping, crates, hull, ending] = [-100, 0, 1, 'none'];
  const play = ({ boat }: SubmarineGame, isOn: boolean) => {
    synth.set(isOn);
    if (boat.pingTime > ping) synth.tone({ frequency: 1480, to: 1380, loudness: 0.22, seconds: 1.5 });
    if (boat.collected > crates) synth.tone({ frequency: 620, to: 930, loudness: 0.25, seconds: 0.4 });
    if (boat.hull < hull - 0.02) synth.noise({ frequency: 130, to: 50, loudness: 0.5, seconds: 0.5 });
    if (boat.ending !== ending && boat.ending === 'won')
      synth.tone({ frequency: 523, to: 1046, loudness: 0.25, seconds: 1 });
    [ping, crates, hull, ending] = [boat.pingTime, boat.collected, boat.hull, boat.ending];
  };
  return Object.assign(play, { destroy: () => synth.destroy() });
}
