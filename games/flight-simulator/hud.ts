/** What lies over the picture: instruments, the next task in a sentence, and a mark on the next goal. */
import { RINGS } from './course.ts';
import { createInstruments } from './instruments.ts';
import { createRudderSlider } from './rudder-slider.ts';
import { objective } from './sentences.ts';
import type { Flight } from './sim.ts';
import { RUNWAY } from './terrain.ts';
import { WORDS } from './words.ts';

const STYLES = `
.fs-hud { position: absolute; inset: 0; pointer-events: none; overflow: hidden; font-variant-numeric: tabular-nums }
.fs-instruments { position: absolute; left: 50%; bottom: max(12px, env(safe-area-inset-bottom)); width: 340px; height: 168px;
  translate: -50% 0; padding: 6px; border-radius: 16px; background: #0b122699; box-shadow: 0 6px 24px #0006 }
.fs-task { box-sizing: border-box; position: absolute; left: 50%; top: calc(var(--bar, 58px) + 8px); translate: -50% 0; margin: 0; width: max-content; max-width: calc(100% - 40px);
  padding: 8px 16px; border-radius: 12px; background: #0b1226cc; color: #fff; font-weight: 600; font-size: 16px; text-align: center }
.fs-task:empty:not([data-hold]) { display: none } .fs-task[data-warning] { background: #b3261ee6 }
.fs-task[data-hold]::after { content: attr(data-hold); display: block; color: #9ff0b8; font-size: 13px }
.fs-goal { position: absolute; left: 0; top: 0; color: #ffcf7a; font: 600 13px/1.2 system-ui, sans-serif; text-align: center;
  text-shadow: 0 1px 3px #000, 0 0 6px #000; width: 80px; margin: -9px -40px }
.fs-goal i { display: block; width: 14px; height: 14px; margin: 0 auto 3px; border: 2px solid #ffb454; rotate: 45deg }
.game:has(.game-side:not([hidden])) .fs-task, .game:has(.game-side:not([hidden])) .fs-instruments { left: calc(50% - 144px) }
.game:has(.game-side:not([hidden])) .fs-rudder { left: calc(50% - 328px) }
/* The pad lies over a bright runway. */
.game:has(.fs-hud) .game-pad :is(button, .game-stick) { background: #0b122699 }
/* Above the horizon, where the rings are, and the task below. */
@media (pointer: coarse) { .fs-task { top: 216px; font-size: 15px; line-height: 1.4 } .fs-instruments { bottom: auto; top: 62px; scale: 0.82; transform-origin: 50% 0 } }
@media (pointer: coarse) and (max-height: 500px) { .fs-instruments { top: auto; bottom: 4px; left: max(6px, env(safe-area-inset-left)); translate: 0 0; scale: 0.72; transform-origin: 0 100% } .fs-task { top: 58px; font-size: 14px } }
/* A page that is enlarged has little height: the aeroplane stays in sight. */
@media (pointer: fine) and (max-height: 420px) { .fs-instruments { left: 6px; bottom: 6px; translate: none; scale: 0.62; transform-origin: 0 100% }
  .fs-task { top: 60px; padding: 3px 12px; font-size: 13px } }
@media (max-width: 1100px) { .game:has(.game-side:not([hidden])) .fs-rudder { left: calc(50% - 144px); translate: -50% 0; bottom: 200px } }
@media (max-width: 759px), (pointer: coarse) { .game:has(.game-side:not([hidden])) :is(.fs-task, .fs-instruments, .fs-rudder) { visibility: hidden } }
`;

export interface Hud {
  update(flight: Flight, toScreen: (x: number, y: number, z: number) => { x: number; y: number; ahead: boolean }): void;
  destroy(): void;
}

/** @param present gives the present flight */
export function createHud(
  parent: HTMLElement,
  present: () => Flight,
  size: { readonly width: number; readonly height: number },
): Hud {
  const style = document.createElement('style');
  style.textContent = STYLES;
  const root = document.createElement('div');
  root.className = 'fs-hud';
  const instruments = createInstruments();
  const task = document.createElement('p');
  task.className = 'fs-task';
  task.setAttribute('role', 'status');
  const goal = document.createElement('div');
  goal.className = 'fs-goal';
  const distance = document.createElement('span');
  goal.append(document.createElement('i'), distance);
  for (const each of [instruments.element, task, goal]) each.dataset.filmed = '';
  const rudder = createRudderSlider(present);
  root.append(style, goal, task, instruments.element, rudder.element);
  parent.append(root);
  let held = Number.NaN;
  return {
    update(flight, toScreen) {
      instruments.draw(flight);
      rudder.update(flight);
      showHold(flight);
      const sentence = objective(flight);
      if (task.textContent !== sentence) task.textContent = sentence;
      task.toggleAttribute('data-warning', flight.isStalling);
      showGoal(flight, toScreen);
    },
    destroy: () => root.remove(),
  };

  function showHold({ pilot }: Flight): void {
    const { isOn, altitude } = pilot.hold;
    const metres = isOn ? Math.round(altitude) : Number.NaN;
    if (Object.is(metres, held)) return;
    held = metres;
    if (isOn) task.dataset.hold = WORDS.holds(metres);
    else delete task.dataset.hold;
  }

  function showGoal({ log, world, plane, mission }: Flight, toScreen: Parameters<Hud['update']>[1]): void {
    const ring = RINGS[log.ring];
    const hasGoal = mission !== 'free' && log.hasFlown && !log.onGround && log.phase === 'flying';
    goal.hidden = !hasGoal;
    if (!hasGoal) return;
    // The mark of a landing is the place where the wheels should touch.
    const { x, y, z } = ring === undefined ? { x: 250 - RUNWAY.length / 2, y: 1, z: 0 } : ring.at;
    const { Position: p } = world.components;
    const metres = Math.hypot(x - p.x[plane], y - p.y[plane], z - p.z[plane]);
    const place = toScreen(x, y, z);
    const [middleX, middleY] = [size.width / 2, size.height / 2];
    // A goal behind is shown at the side to which one has to turn.
    const side = place.ahead ? 1 : -1;
    let [dx, dy] = [side * (place.x - middleX), side * (place.y - middleY)];
    const outside = Math.max(Math.abs(dx) / (middleX - 50), Math.abs(dy) / (middleY - 110));
    if (!place.ahead || outside > 1) [dx, dy] = [dx / outside, dy / outside];
    goal.style.transform = `translate(${(middleX + dx).toFixed(1)}px, ${(middleY + dy).toFixed(1)}px)`;
    const text = metres > 1000 ? WORDS.kilometres(metres / 1000) : `${Math.round(metres / 10) * 10} m`;
    if (distance.textContent !== text) distance.textContent = text;
  }
}
