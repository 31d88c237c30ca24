/** Words and bars over the picture. */

import { css, type Palette } from './palette.ts';
import { dodgeText, livesText } from './report.ts';
import { LIVES, type News, TANK } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';

const STYLE = `
.bh-hud { position: absolute; pointer-events: none; color: #eaf0ff; font: 600 15px/1.3 system-ui, sans-serif;
  text-shadow: 0 1px 3px #000, 0 0 10px #000c; font-variant-numeric: tabular-nums }
.bh-hud > * { position: absolute }
.bh-lives { left: 14px; top: 10px; display: flex; gap: 9px; align-items: center }
.bh-lives i { width: 0; height: 0; border: 6px solid transparent; border-bottom: 13px solid var(--ship); border-top: 0 }
.bh-lives i.lost { border-bottom-color: #ffffff26 }
.bh-score { left: 50%; top: 8px; translate: -50% 0; font-size: 18px; white-space: nowrap }
.bh-level { right: 14px; top: 10px; display: flex; flex-direction: row-reverse; gap: 12px; align-items: baseline; white-space: nowrap }
.bh-level small { color: #9fb0dc; font-weight: 500 }
.bh-fuel { left: 14px; bottom: 12px; width: 150px } .bh-fuel small { color: #9fb0dc; font-weight: 500 }
.bh-fuel div { height: 6px; margin-top: 4px; border-radius: 3px; background: #ffffff1f; overflow: hidden }
.bh-fuel b { display: block; height: 100%; border-radius: 3px; background: linear-gradient(90deg, #ff8a3c, #ffd98a); transform-origin: 0 }
.bh-fuel.low b { background: var(--bad) }
.bh-speed { right: 14px; bottom: 10px; color: #9fb0dc; font-weight: 500; font-size: 13px }
.bh-call { left: 50%; top: 64%; translate: -50% 0; text-align: center; width: max-content; max-width: 92% }
.bh-call.low { top: auto; bottom: 10px; font-size: 13px }
.bh-call h2 { margin: 0; font-size: clamp(26px, 5vw, 46px); letter-spacing: -0.02em } .bh-call p { margin: 4px 0 0; color: #c4d2f6 }
.bh-toast { left: 50%; top: 15%; translate: -50% 0; font-size: 22px; width: max-content; max-width: 92%; text-align: center; opacity: 0 }
.bh-toast.on { opacity: 1; animation: bh-rise 1.7s ease-out both }
@keyframes bh-rise { 0% { opacity: 0; transform: translateY(12px) } 12%, 60% { opacity: 1; transform: none } 100% { opacity: 0; transform: translateY(-10px) } }
@media (max-width: 800px) { .bh-speed { display: none } }
@media (max-height: 480px) { .bh-toast { font-size: 16px } .bh-call:not(.low) { top: 48% } .bh-call h2 { font-size: 26px } }
@media (max-width: 620px) { .bh-level { flex-direction: column; gap: 0; align-items: end }
  .bh-hud { font-size: 12px } .bh-score { font-size: 13px } .bh-toast { font-size: 17px } .bh-fuel { width: 100px }
  .bh-call:not(.low) { top: 44% } .bh-call.low { left: auto; right: 12px; translate: none; font-size: 11px } }
.bh-hud.outside { font-size: 13px } .outside .bh-lives { top: -44px; left: 2px } .outside .bh-level { top: -44px; right: 2px; gap: 3px }
.outside .bh-score { top: -22px; left: 2px; translate: none } .outside .bh-fuel { bottom: -40px; left: 2px }
.outside .bh-speed { display: block; bottom: -24px; right: 2px } .outside .bh-call.low { bottom: 8px; right: 8px }
`;

/** What stands above a small stage needs this much, CSS pixels. */
const OUTSIDE_ROOM = 50;

/** Where the stage is on the canvas, CSS pixels. */
export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** Free room above it. */
  readonly room: number;
}

export interface Hud {
  update(sim: BlackHoleGame, frame: Frame): void;
  toast(news: News, sim: BlackHoleGame): void;
  destroy(): void;
}

/** @param palette colours as they are now */
export function createHud(parent: HTMLElement, palette: () => Palette): Hud {
  const root = document.createElement('div');
  root.className = 'bh-hud';
  root.innerHTML = `<style>${STYLE}</style>
<div class="bh-lives">${'<i></i>'.repeat(LIVES)}<span></span></div><div class="bh-score"></div>
<div class="bh-level"><span></span><small></small></div>
<div class="bh-fuel"><small></small><div><b></b></div></div><div class="bh-speed"></div>
<div class="bh-call"><h2></h2><p></p></div><div class="bh-toast" role="status"></div>`;
  parent.append(root);
  const find = (selector: string) => root.querySelector(selector) as HTMLElement;
  const parts = {
    ...{ lives: find('.bh-lives span'), score: find('.bh-score'), level: find('.bh-level span') },
    ...{ bonus: find('.bh-level small'), fuel: find('.bh-fuel'), fuelText: find('.bh-fuel small') },
    ...{ bar: find('.bh-fuel b'), speed: find('.bh-speed'), title: find('.bh-call h2'), call: find('.bh-call p') },
  };
  const icons = [...root.querySelectorAll('.bh-lives i')];
  const toast = find('.bh-toast');
  let timer = 0;
  return {
    update(sim, { left, top, width, height, room }) {
      const colors = palette();
      root.style.cssText = `left:${left}px;top:${top}px;width:${width}px;height:${height}px;
        --ship:${css(colors.hull)};--bad:${css(colors.fall)}`;
      // A small stage needs all its room for the game.
      root.classList.toggle('outside', width < 620 && room > OUTSIDE_ROOM);
      const { rules } = sim;
      for (const [i, icon] of icons.entries()) icon.classList.toggle('lost', i >= rules.lives);
      parts.fuel.hidden = !rules.options.fuel;
      parts.fuel.classList.toggle('low', rules.fuel < 0.25 * TANK);
      parts.bar.style.transform = `scaleX(${rules.fuel / TANK})`;
      const [title, call] = callOf(sim, colors.goalName);
      root.querySelector('.bh-call')?.classList.toggle('low', title === '');
      const texts: [HTMLElement, string][] = [
        [parts.lives, livesText(rules.lives)],
        [parts.score, dodgeText(rules.score)],
        [parts.level, `Level ${rules.dodged + 1}`],
        [parts.bonus, `prize ${rules.prize} · bonus ${rules.bonus}`],
        [parts.fuelText, `fuel ${rules.fuel.toFixed(0)} m/s`],
        [parts.speed, `Δv ${rules.spent.toFixed(0)} m/s · speed ${speedOf(sim).toFixed(0)} m/s`],
        [parts.title, title],
        [parts.call, call],
      ];
      for (const [part, text] of texts) if (part.textContent !== text) part.textContent = text;
    },
    toast(news, sim) {
      const text = toastOf(news, sim);
      if (text === '') return;
      toast.textContent = text;
      toast.style.color = css(news.kind === 'fall' ? palette().fall : palette().goal);
      toast.classList.remove('on');
      // Reading the layout makes the animation begin anew.
      void toast.offsetWidth;
      toast.classList.add('on');
      // Where the system wants no animation, this alone takes it away.
      clearTimeout(timer);
      timer = window.setTimeout(() => toast.classList.remove('on'), 1700);
    },
    destroy() {
      clearTimeout(timer);
      root.remove();
    },
  };
}

function speedOf({ scene, world }: BlackHoleGame): number {
  const { x, y } = world.components.Velocity;
  return Math.hypot(x[scene.ship], y[scene.ship]);
}

function callOf({ rules, isDemo, isReplay, autopilot }: BlackHoleGame, goal: string): [string, string] {
  if (isReplay) return ['', 'Replay — push any arrow to take over'];
  if (isDemo) return ['', 'Demo — push any arrow to play yourself'];
  if (autopilot) return ['', 'Autopilot — A gives you the ship'];
  if (rules.phase === 'ready') return ['Black hole', `Reach the ${goal} line. Push an arrow, or touch, to launch.`];
  return ['', ''];
}

function toastOf({ kind, points }: News, { rules }: BlackHoleGame): string {
  if (kind === 'goal') return `Dodged! +${points}${rules.dodged === 4 ? ' — now they move' : ''}`;
  if (kind === 'fall') return rules.lives === 0 ? '' : `Swallowed — ${livesText(rules.lives)}`;
  if (kind === 'left') return 'Lost in space: back to the start';
  if (kind === 'redraw')
    return points < 0 ? 'Other holes: the prize is a point less' : 'Other holes: that costs a life';
  if (kind === 'sling') return 'Slingshot! bonus +1 at the goal';
  if (kind === 'empty') return 'The tank is empty';
  return '';
}
