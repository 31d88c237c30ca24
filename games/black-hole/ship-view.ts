/** Draws the ship, its flame, and the dots of its predicted path. */
import { Container, Graphics, Sprite, type Texture } from 'pixi.js';
import { Flight } from './flight.ts';
import { thrustOf } from './heading.ts';
import type { Palette } from './palette.ts';
import type { BlackHoleGame } from './sim.ts';

/** Length of the prediction, its time step, both in s, and steps between two dots. */
const PREVIEW_SECONDS = 2;
const PREVIEW_DT = 1 / 120;
const STEPS_PER_DOT = 6;
const DOTS = PREVIEW_SECONDS / PREVIEW_DT / STEPS_PER_DOT;

export interface ShipView {
  readonly container: Container;
  /** @param place interpolated position of the ship: x and y, m */
  update(sim: BlackHoleGame, place: Readonly<Float64Array>, seconds: number): void;
}

export function createShipView({ hull: hullColor, hullShade }: Palette): ShipView {
  const flame = new Graphics().poly([-3.2, 5, 0, 20, 3.2, 5]).fill({ color: 0xff9d3c, alpha: 0.85 });
  flame.poly([-1.8, 5, 0, 13, 1.8, 5]).fill(0xfff2c4);
  flame.blendMode = 'add';
  const hull = new Graphics().poly([0, -8, 6.4, 6, 0, 3.2, -6.4, 6]).fill(hullColor);
  hull.poly([0, -8, 6.4, 6, 0, 3.2]).fill({ color: hullShade, alpha: 0.75 });
  hull.circle(0, -0.5, 1.7).fill(0xcfefff);
  const container = new Container({ children: [flame, hull] });
  // A typed array, because a captured variable would allocate a number on the heap in every frame.
  const time = new Float64Array(1);
  return {
    container,
    update({ rules }, place, seconds) {
      time[0] += seconds;
      container.visible = rules.phase === 'ready' || rules.phase === 'flying';
      container.position.set(place[0], -place[1]);
      const { push } = rules;
      if (push !== undefined) {
        // Turns by the smaller angle, most of it within a tenth of a second.
        const wanted = Math.atan2(push.x, push.y);
        const turn = Math.atan2(Math.sin(wanted - container.rotation), Math.cos(wanted - container.rotation));
        container.rotation += turn * (1 - Math.exp(-18 * Math.max(seconds, 1 / 60)));
      } else if (rules.phase === 'ready') container.rotation = 0;
      flame.visible = push !== undefined && rules.hasFuel && rules.phase === 'flying';
      const strength = push === undefined ? 0 : Math.hypot(push.x, push.y);
      flame.scale.set(
        0.5 + 0.5 * strength,
        (0.3 + 0.7 * strength) * (0.85 + 0.2 * Math.sin(70 * time[0]) + 0.1 * Math.sin(113 * time[0])),
      );
    },
  };
}

export interface PathView {
  readonly container: Container;
  update(sim: BlackHoleGame): void;
}

export function createPathView(spot: Texture, isSteep: boolean, { path, goal, fall }: Palette): PathView {
  const container = new Container();
  const flight = new Flight(isSteep);
  const craft = { x: 0, y: 0, vx: 0, vy: 0 };
  const thrust = { x: 0, y: 0 };
  const dots = Array.from({ length: DOTS }, (_, i) => {
    const dot = new Sprite({ texture: spot, anchor: 0.5, alpha: 0.85 * (1 - i / DOTS) + 0.08 });
    dot.scale.set((5.5 - (2.5 * i) / DOTS) / 32);
    container.addChild(dot);
    return dot;
  });
  /** Pixi converts a tint whenever it is set, which allocates objects. */
  const tints = dots.map(() => Number.NaN);
  const paint = (index: number, tint: number) => {
    if (tints[index] === tint) return;
    tints[index] = tint;
    dots[index].tint = tint;
  };
  return {
    container,
    update({ scene, rules }) {
      const { ship, world, holes } = scene;
      const { Position, Velocity } = world.components;
      craft.x = Position.x[ship];
      craft.y = Position.y[ship];
      craft.vx = Velocity.x[ship];
      craft.vy = Velocity.y[ship];
      // Where no hole moves, the time has no effect; a constant avoids allocating a number.
      flight.begin(craft, holes, rules.movingHoles > 0 ? scene.holeTime : 0);
      thrustOf(rules.hasFuel ? rules.push : undefined, thrust);
      for (let d = 0; d < dots.length; d++) {
        const dot = dots[d];
        for (let s = 0; s < STEPS_PER_DOT; s++) flight.step(PREVIEW_DT, thrust);
        dot.visible = flight.status === 'flying';
        dot.position.set(flight.x, -flight.y);
        paint(d, path);
      }
      if (flight.status === 'flying') return;
      // The last dot shows the end of the flight: a fall, the goal, or out of bounds.
      let end = 0;
      while (dots[end].visible) end++;
      const last = dots[end];
      last.visible = flight.status !== 'gone';
      paint(end, flight.status === 'fallen' ? fall : goal);
    },
  };
}
