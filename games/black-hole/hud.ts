/** The text and bars drawn over the picture. */

import { css, type Palette } from './palette.ts';
import { livesText, scoreText } from './report.ts';
import { type GameEvent, LIVES, TANK } from './rules.ts';
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

/** Free height required to place text above a small stage, CSS pixels. */
const OUTSIDE_ROOM = 50;

/** Position of the stage on the canvas, CSS pixels. */
export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** Free height above the stage. */
  readonly room: number;
}

export interface Hud {
  update(sim: BlackHoleGame, frame: Frame): void;
  toast(news: GameEvent, sim: BlackHoleGame): void;
  destroy(): void;
}

/** Frames between two updates of fuel and speed. */
const FRAMES_A_NUMBER = 9;

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
    lives: find('.bh-lives span'),
    score: find('.bh-score'),
    level: find('.bh-level span'),
    bonus: find('.bh-level small'),
    fuel: find('.bh-fuel'),
    fuelText: find('.bh-fuel small'),
    bar: find('.bh-fuel b'),
    speed: find('.bh-speed'),
    title: find('.bh-call h2'),
    call: find('.bh-call p'),
  };
  const icons = [...root.querySelectorAll('.bh-lives i')];
  const toast = find('.bh-toast');
  const callCard = find('.bh-call');
  /** The values on display: texts are created only when they change, to avoid garbage. */
  const shown = {
    left: Number.NaN,
    top: Number.NaN,
    width: Number.NaN,
    height: Number.NaN,
    fuel: Number.NaN,
    lives: -1,
    score: -1,
    level: -1,
  };
  const words = { prize: -1, bonus: -1, fuel: -1, spent: -1, speed: -1 };
  const place = ({ left, top, width, height, room }: Frame) => {
    // A small stage leaves no room for text inside.
    root.classList.toggle('outside', width < 620 && room > OUTSIDE_ROOM);
    if (left === shown.left && top === shown.top && width === shown.width && height === shown.height) return;
    Object.assign(shown, { left, top, width, height });
    const { style } = root;
    style.left = `${left}px`;
    style.top = `${top}px`;
    style.width = `${width}px`;
    style.height = `${height}px`;
  };
  let colored: Palette | undefined;
  const showColors = (colors: Palette) => {
    if (colors === colored) return;
    colored = colors;
    root.style.setProperty('--ship', css(colors.hull));
    root.style.setProperty('--bad', css(colors.fall));
  };
  const showLives = (lives: number) => {
    if (lives === shown.lives) return;
    shown.lives = lives;
    for (const [i, icon] of icons.entries()) icon.classList.toggle('lost', i >= lives);
    parts.lives.textContent = livesText(lives);
  };
  const showScore = ({ score, dodged, goalPoints, bonus }: BlackHoleGame['rules']) => {
    if (score !== shown.score) parts.score.textContent = scoreText(score);
    if (dodged !== shown.level) parts.level.textContent = `Level ${dodged + 1}`;
    if (goalPoints !== words.prize || bonus !== words.bonus)
      parts.bonus.textContent = `worth ${goalPoints} · bonus ${bonus}`;
    shown.score = score;
    shown.level = dodged;
    words.prize = goalPoints;
    words.bonus = bonus;
  };
  const showFuel = ({ fuel, options }: BlackHoleGame['rules']) => {
    parts.fuel.hidden = !options.fuel;
    if (fuel === shown.fuel) return;
    shown.fuel = fuel;
    parts.fuel.classList.toggle('low', fuel < 0.25 * TANK);
    parts.bar.style.transform = `scaleX(${fuel / TANK})`;
    const rounded = Math.round(fuel);
    if (rounded !== words.fuel) parts.fuelText.textContent = `fuel ${rounded} m/s`;
    words.fuel = rounded;
  };
  const showSpeed = (sim: BlackHoleGame) => {
    const spent = Math.round(sim.rules.spent);
    const speed = Math.round(speedOf(sim));
    if (spent === words.spent && speed === words.speed) return;
    words.spent = spent;
    words.speed = speed;
    parts.speed.textContent = `Δv ${spent} m/s · speed ${speed} m/s`;
  };
  let called: Call | undefined;
  const showCall = (call: Call) => {
    if (call === called) return;
    called = call;
    callCard.classList.toggle('low', call[0] === '');
    parts.title.textContent = call[0];
    parts.call.textContent = call[1];
  };
  let timer = 0;
  let toNumbers = 0;
  return {
    update(sim, frame) {
      const colors = palette();
      place(frame);
      showColors(colors);
      showLives(sim.rules.lives);
      showScore(sim.rules);
      // Every update creates strings; an update in each frame would be unreadable anyway.
      if (toNumbers-- <= 0) {
        toNumbers = FRAMES_A_NUMBER;
        showFuel(sim.rules);
        showSpeed(sim);
      }
      showCall(callOf(sim, colors.goalName));
    },
    toast(news, sim) {
      const text = toastOf(news, sim);
      if (text === '') return;
      toast.textContent = text;
      toast.style.color = css(news.kind === 'fall' ? palette().fall : palette().goal);
      toast.classList.remove('on');
      // Reading the layout restarts the animation.
      void toast.offsetWidth;
      toast.classList.add('on');
      // Required where the system disables animations.
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

type Call = readonly [title: string, text: string];

const CALLS = {
  replay: ['', 'Replay – press any arrow key to take over'],
  demo: ['', 'Demo – press any arrow key to play'],
  autopilot: ['', 'Autopilot on – press A to take over'],
  none: ['', ''],
} satisfies Record<string, Call>;

/** One message per name of the goal's colour. */
const READY = new Map<string, Call>();

function readyCall(goal: string): Call {
  const made = READY.get(goal) ?? ['Black hole', `Reach the ${goal} line. Press an arrow key or tap to launch.`];
  READY.set(goal, made);
  return made;
}

function callOf({ rules, isDemo, isReplay, autopilot }: BlackHoleGame, goal: string): Call {
  if (isReplay) return CALLS.replay;
  if (isDemo) return CALLS.demo;
  if (autopilot) return CALLS.autopilot;
  return rules.phase === 'ready' ? readyCall(goal) : CALLS.none;
}

function toastOf({ kind, points }: GameEvent, { rules }: BlackHoleGame): string {
  if (kind === 'goal') return `Dodged! +${points}${rules.dodged === 4 ? ' – now some holes move' : ''}`;
  if (kind === 'fall') return rules.lives === 0 ? '' : `Swallowed – ${livesText(rules.lives)}`;
  if (kind === 'left') return 'Out of bounds – back to the start';
  if (kind === 'redraw') return 'New layout – no bonus this level';
  if (kind === 'sling') return 'Slingshot! +1 bonus at the goal';
  if (kind === 'empty') return 'Out of fuel';
  return '';
}
