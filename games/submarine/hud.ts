/** The gauges: depth and pressure, tank, hull, air and breath, and what is to be done. */
import type { ViewContext } from '@principia/shell';
import type { Settings } from './settings.ts';
import { AIR, breathOf, type SubmarineGame } from './sim.ts';
import { WORDS } from './words.ts';

const STYLE = `
.sub-hud { position: absolute; inset: 0; pointer-events: none; color: #eaf6ff; font: 600 14px/1.35 system-ui, sans-serif;
  text-shadow: 0 1px 3px #001018, 0 0 8px #001018; font-variant-numeric: tabular-nums }
/* Below the surface, where the ship is not; beside the button of a touch pad. */
.sub-panel { position: absolute; left: 20px; bottom: 20px; display: grid; gap: 3px; justify-items: start; padding: 6px 12px; border-radius: 12px; background: #04182ab0 }
.sub-goal { font-size: 17px; max-width: min(460px, 92vw) } .sub-say { font-size: 13px; color: #ff9d8a; max-width: min(460px, 92vw) } .sub-say.tip { color: #e6f4ff }
.sub-depth { font-size: 14px } .sub-gauges { display: grid; grid-template-columns: auto 120px; gap: 3px 10px; align-items: center; font-size: 12.5px }
.sub-gauges i { height: 8px; border-radius: 4px; background: #ffffff24; position: relative; overflow: hidden }
.sub-gauges i b { position: absolute; inset: 0; background: var(--c); transform-origin: 0; border-radius: 4px }
.sub-gauges i u { position: absolute; left: 50%; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff }
@media (forced-colors: active) { .sub-gauges i { background: #04182a } }
.sub-gauges em { font-style: normal; color: #d5e9f5 }
@media (max-width: 759px), (max-height: 479px) { .sub-panel { gap: 1px; bottom: 12px } .sub-goal { font-size: 15px } .sub-say, .sub-depth { font-size: 12.5px } .sub-gauges { grid-template-columns: auto 84px; font-size: 11.5px } }
@media (pointer: coarse) { .sub-panel { left: 104px } .sub-goal, .sub-say { max-width: 38vw } }
/* Low, so that it leaves the bed in sight. */
@media (max-height: 479px) { .sub-gauges { grid-template-columns: auto 72px auto 72px } .sub-goal { font-size: 13.5px } .sub-goal, .sub-say { line-height: 1.15 } }
/* A page that is enlarged has little height: one line each for the goal, a word, and all gauges. */
@media (pointer: fine) and (max-height: 420px) { .sub-panel { left: 8px; right: 8px; bottom: 6px; padding: 2px 10px 4px; display: flex; flex-wrap: wrap; justify-content: space-between; gap: 0 14px }
  .sub-goal { font-size: 13.5px } .sub-depth { order: 1; font-size: 12px } .sub-say { max-width: none; font-size: 12px } .sub-say, .sub-gauges { order: 2; flex-basis: 100% } .sub-gauges { grid-template-columns: repeat(4, auto 44px); gap: 0 8px } }
/* A card says how it ended, and the settings cover what lies below them. */
@media (max-width: 759px), (max-height: 479px) { .sub-hud.over .sub-panel { visibility: hidden } }
@media (max-width: 759px) { .game:has(.game-side:not([hidden])) .sub-panel { visibility: hidden } }
/* A window held upright has more sky than the ship is high; gauges side by side leave the sea in sight. */
@media (orientation: portrait) { .sub-panel { left: 8px; top: 60px; bottom: auto; padding: 3px 12px 4px } .sub-goal, .sub-say { max-width: min(460px, 86vw) }
  .sub-goal { font-size: 14px; line-height: 1.2 } .sub-say { line-height: 1.2 } .sub-gauges { grid-template-columns: auto 56px auto 56px; gap: 2px 8px } }
@media (orientation: portrait) and (max-width: 389px) { .sub-panel { right: 8px; width: fit-content } .sub-depth { font-size: 11.5px } .sub-gauges { grid-template-columns: auto 48px auto 48px } }
`;

export interface Hud {
  update(sim: SubmarineGame): void;
  destroy(): void;
}

/** How long the first hint is shown, s. */
const TIP_SECONDS = 14;
/** Frames between two updates. */
const FRAMES = 6;

export function createHud(context: ViewContext<Settings, SubmarineGame>): Hud {
  const root = document.createElement('div');
  root.className = 'sub-hud';
  root.dataset.filmed = '';
  const { tank, hull, air, breath } = WORDS.gauges;
  const bar = (name: string, color: string, mark = '') =>
    `<em>${name}</em><i data-gauge style="--c: ${color}"><b></b>${mark}</i>`;
  root.innerHTML = `<style>${STYLE}</style><div class="sub-panel"><div class="sub-goal"></div><div class="sub-say" role="status"></div><div class="sub-depth"></div><div class="sub-gauges">${bar(tank, '#4aa8ff', '<u></u>')}${bar(hull, '#ffc15e')}${bar(air, '#9ff5e2')}${bar(breath, '#ff9d8a')}</div></div>`;
  context.element.append(root);
  const [goal, warning, depth] = ['.sub-goal', '.sub-say', '.sub-depth'].map(
    (selector) => root.querySelector(selector) as HTMLElement,
  );
  const bars = [...root.querySelectorAll<HTMLElement>('.sub-gauges b')];
  let frame = 0;
  const say = (element: HTMLElement, text: string) => {
    if (element.textContent !== text) element.textContent = text;
  };
  return {
    update(sim) {
      if (frame++ % FRAMES !== 0) return;
      const { boat } = sim;
      const { x, y } = sim.world.components.Velocity;
      const { length } = sim.taken;
      const isWon = boat.ending === 'won';
      const isFull = boat.collected === length;
      say(goal, isWon ? WORDS.endings.won : isFull ? WORDS.allAboard : WORDS.goal(boat.collected, length));
      root.classList.toggle('over', sim.isOver);
      const isNew = sim.world.time < TIP_SECONDS && boat.ending === 'none';
      warning.classList.toggle('tip', isNew);
      say(warning, isNew ? WORDS.start : warningOf(sim));
      const speed = WORDS.speed(Math.hypot(x[sim.sub], y[sim.sub]));
      say(depth, `${WORDS.depth(sim.depth, sim.pressure)} · ${WORDS.density(sim.ratio)} · ${speed}`);
      const full = breathOf(sim.level);
      const shares = [boat.fill, boat.hull, boat.air / AIR.full, boat.breath / full];
      for (const [i, share] of shares.entries()) bars[i].style.transform = `scaleX(${share.toFixed(3)})`;
    },
    destroy: () => root.remove(),
  };
}

function warningOf({ boat, depth, sea }: SubmarineGame): string {
  if (boat.ending !== 'none') return '';
  if (depth > sea.crushDepth) return WORDS.tooDeep;
  if (boat.breath < 40) return WORDS.lowBreath;
  return boat.air < 0.15 * AIR.full ? WORDS.lowAir : '';
}
