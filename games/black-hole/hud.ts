/** The text and bars drawn over the picture. */
import { dayOf, withLanguage } from '@principia/shell';
import { dayOfSeed, seedOf, unbroken } from './daily.ts';
import type { Comparison } from './ghost.ts';
import { css, type Palette } from './palette.ts';
import { type GameEvent, LIVES, TANK } from './rules.ts';
import type { BlackHoleGame } from './sim.ts';
import { WORDS } from './words.ts';

const STYLE = `
.bh-hud { position: absolute; pointer-events: none; color: #eaf0ff; font: 600 15px/1.3 system-ui, sans-serif;
  text-shadow: 0 1px 3px #000, 0 0 10px #000c; font-variant-numeric: tabular-nums }
.bh-hud > * { position: absolute }
.bh-lives { left: 14px; top: 10px; display: flex; gap: 9px; align-items: center }
.bh-lives i { width: 0; height: 0; border: 6px solid transparent; border-bottom: 13px solid var(--ship); border-top: 0 }
.bh-lives i.lost { border-bottom-color: #ffffff26 }
@media (forced-colors: active) { .bh-lives i { forced-color-adjust: none } .bh-fuel div { background: #000 } }
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
.bh-call h2 { margin: 0; font-size: clamp(26px, 5vw, 46px); letter-spacing: -0.02em } .bh-call p { margin: 4px 0 0; color: #c4d2f6; text-wrap: balance }
/* Clear of the buttons at the right. */
@media (min-width: 621px) and (min-height: 481px) { .bh-hud:not(.outside) .bh-call:not(.low) { max-width: calc(100% - 320px) } }
/* Beside the ship's start, around which players press to steer. */
.bh-redraw { right: 14px; bottom: 40px } .bh-daily { right: 14px; bottom: 84px; text-decoration: none }
.bh-redraw, .bh-daily { padding: 7px 14px; border: 1px solid #ffffff38; border-radius: 11px; background: #ffffff14;
  color: inherit; font: inherit; font-size: 13px; cursor: pointer; pointer-events: auto }
:is(.bh-redraw, .bh-daily):hover { background: #ffffff2c } :is(.bh-redraw, .bh-daily):focus-visible { outline: 2px solid var(--ship) }
@media (pointer: coarse) { .bh-redraw, .bh-daily { min-height: 44px; box-sizing: border-box; display: grid; place-items: center } .bh-daily { bottom: 92px } }
.bh-toast { left: 50%; top: 15%; translate: -50% 0; font-size: 22px; width: max-content; max-width: 92%; text-align: center; text-wrap: balance; opacity: 0 }
.bh-toast.on { opacity: 1; animation: bh-rise 1.7s ease-out both }
@keyframes bh-rise { 0% { opacity: 0; transform: translateY(12px) } 12%, 60% { opacity: 1; transform: none } 100% { opacity: 0; transform: translateY(-10px) } }
@media (pointer: coarse) and (max-height: 480px) and (min-aspect-ratio: 19/10) { .bh-redraw, .bh-daily { right: auto; left: calc(100% + 14px); bottom: 76px; white-space: nowrap } .bh-daily { bottom: 128px } }
@media (pointer: fine) and (max-height: 480px) and (min-aspect-ratio: 17/10) { .bh-redraw, .bh-daily { right: auto; left: calc(100% + 8px); bottom: 12px; padding: 6px 8px; font-size: 12px; white-space: nowrap } .bh-daily { bottom: 50px } }
/* Where little is free beside the field, in two lines: over it they would cover what is said. */
@media (pointer: fine) and (max-height: 480px) and (min-aspect-ratio: 3/2) and (max-aspect-ratio: 17/10) { .bh-redraw, .bh-daily { right: auto; left: calc(100% + 8px); bottom: 12px; padding: 5px; font-size: 12px; max-width: calc(50vw - 50% - 16px); text-align: center } .bh-daily { bottom: 62px } }
@media (max-width: 800px) { .bh-speed { display: none } }
@media (max-height: 480px) { .bh-hud:not(.outside) { font-size: 13px } .bh-hud:not(.outside) > :is(.bh-lives, .bh-score, .bh-level) { top: 2px } .bh-score { font-size: 14px } .bh-toast { font-size: 16px } .bh-call:not(.low) { top: 48% } .bh-call h2 { font-size: 26px } }
/* Beside a field that is too low for them. */
@media (max-height: 480px) and (min-aspect-ratio: 19/10) { .bh-hud > :is(.bh-score, .bh-speed, .bh-call.low) { left: calc(100% + 14px); right: auto; translate: none; width: max-content; max-width: 250px; text-align: left }
  .bh-call.low { top: 28px; bottom: auto } }
@media (max-width: 620px) { .bh-level { flex-direction: column; gap: 0; align-items: end }
  .bh-hud { font-size: 12px } .bh-score { font-size: 13px } .bh-toast { font-size: 17px } .bh-fuel { width: 100px }
  .bh-call:not(.low) { top: 53% } .bh-call.low { left: auto; right: 12px; translate: none; font-size: 11px } }
@media (max-width: 759px), (max-height: 479px) { .game:has(.game-side:not([hidden])) :is(.bh-redraw, .bh-daily, .bh-call) { visibility: hidden } }
@media (max-height: 479px) { .game:has(.game-side:not([hidden])) .bh-speed { visibility: hidden } }
.bh-hud.outside { font-size: 13px } .outside .bh-lives { top: -44px; left: 10px } .outside .bh-level { top: -44px; right: 10px; gap: 3px }
.outside .bh-score { top: -22px; left: 10px; translate: none } .outside .bh-fuel { bottom: -40px; left: 10px }
.outside .bh-speed { display: block; bottom: -24px; right: 10px } .outside .bh-call.low { bottom: 8px; right: 8px }
.outside :is(.bh-redraw, .bh-daily) { right: auto; left: 10px; bottom: -100px } .outside .bh-daily { bottom: -152px }
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
  /** @param comparison of a flight that reached the goal with the best one before it */
  toast(event: GameEvent, sim: BlackHoleGame, comparison?: Comparison): void;
  destroy(): void;
}

/** Frames between two updates of fuel and speed. */
const FRAMES_PER_UPDATE = 9;

/** @param palette returns the present colours @param redraw asks for another layout */
export function createHud(parent: HTMLElement, palette: () => Palette, redraw: () => void): Hud {
  const root = createRoot(parent);
  const find = (selector: string) => root.querySelector(selector) as HTMLElement;
  const place = createPlacement(root);
  const applyColors = createColors(root);
  const showLives = createLives(root, find);
  const showScore = createScore(find);
  const showFuel = createFuel(find);
  const showSpeed = createSpeed(find);
  const showCall = createCall(find, redraw);
  const toast = createToast(find('.bh-toast'));
  let framesToNumbers = 0;
  return {
    update(sim, frame) {
      const current = palette();
      place(frame);
      applyColors(current);
      showLives(sim.rules.lives);
      showScore(sim.rules);
      // Every update creates strings; an update in each frame would be unreadable anyway.
      if (framesToNumbers-- <= 0) {
        framesToNumbers = FRAMES_PER_UPDATE;
        showFuel(sim.rules);
        showSpeed(sim);
      }
      // The daily challenge is offered before the first flight of another game.
      const isFirst = sim.rules.phase === 'ready' && !sim.rules.hasBegun && dayOfSeed(sim.seed) === undefined;
      showCall(callOf(sim, current.goalName), isFirst);
    },
    toast(event, sim, comparison) {
      const text = toastOf(event, sim, comparison);
      if (text !== '') toast.show(text, css(event.kind === 'fall' ? palette().fall : palette().goal));
    },
    destroy() {
      toast.destroy();
      root.remove();
    },
  };
}

function createRoot(parent: HTMLElement): HTMLElement {
  const root = document.createElement('div');
  root.className = 'bh-hud';
  root.dataset.filmed = '';
  root.innerHTML = `<style>${STYLE}</style>
<div class="bh-lives">${'<i></i>'.repeat(LIVES)}<span></span></div><div class="bh-score"></div>
<div class="bh-level"><span></span><small></small></div>
<div class="bh-fuel"><small></small><div data-gauge><b></b></div></div><div class="bh-speed"></div>
<div class="bh-call"><h2></h2><p></p></div><a class="bh-daily" href="${withLanguage(`?seed=${seedOf(dayOf(new Date()))}`)}">${WORDS.daily}</a><button type="button" class="bh-redraw" title="${WORDS.redrawHint}">${WORDS.redraw}</button><div class="bh-toast" role="status"></div>`;
  parent.append(root);
  return root;
}

type Find = (selector: string) => HTMLElement;

// The functions below update one part of the display each. They remember the values on display, because texts are
// garbage and are only created when they change.

function createPlacement({ classList, style }: HTMLElement) {
  const shown = { left: Number.NaN, top: Number.NaN, width: Number.NaN, height: Number.NaN };
  return ({ left, top, width, height, room }: Frame) => {
    // A small stage leaves no room for text inside.
    classList.toggle('outside', width < 620 && room > OUTSIDE_ROOM);
    if (left === shown.left && top === shown.top && width === shown.width && height === shown.height) return;
    Object.assign(shown, { left, top, width, height });
    style.left = `${left}px`;
    style.top = `${top}px`;
    style.width = `${width}px`;
    style.height = `${height}px`;
  };
}

function createColors(root: HTMLElement) {
  let shown: Palette | undefined;
  return (colors: Palette) => {
    if (colors === shown) return;
    shown = colors;
    root.style.setProperty('--ship', css(colors.hull));
    root.style.setProperty('--bad', css(colors.fall));
  };
}

function createLives(root: HTMLElement, find: Find) {
  const text = find('.bh-lives span');
  const icons = [...root.querySelectorAll('.bh-lives i')];
  let shown = -1;
  return (lives: number) => {
    if (lives === shown) return;
    shown = lives;
    for (const [i, icon] of icons.entries()) icon.classList.toggle('lost', i >= lives);
    text.textContent = WORDS.lives(lives);
  };
}

function createScore(find: Find) {
  const [points, level, rewards] = [find('.bh-score'), find('.bh-level span'), find('.bh-level small')];
  const shown = { score: -1, dodged: -1, goalPoints: -1, bonus: -1 };
  return ({ score, dodged, goalPoints, bonus }: BlackHoleGame['rules']) => {
    if (score !== shown.score) points.textContent = score === 0 ? '' : WORDS.dodged(score);
    if (dodged !== shown.dodged) level.textContent = WORDS.level(dodged + 1);
    if (goalPoints !== shown.goalPoints || bonus !== shown.bonus)
      rewards.textContent = WORDS.rewards(goalPoints, bonus);
    shown.score = score;
    shown.dodged = dodged;
    shown.goalPoints = goalPoints;
    shown.bonus = bonus;
  };
}

function createFuel(find: Find) {
  const [gauge, text, bar] = [find('.bh-fuel'), find('.bh-fuel small'), find('.bh-fuel b')];
  const shown = { fuel: Number.NaN, rounded: -1 };
  return ({ fuel, options }: BlackHoleGame['rules']) => {
    gauge.hidden = !options.fuel;
    if (fuel === shown.fuel) return;
    shown.fuel = fuel;
    gauge.classList.toggle('low', fuel < 0.25 * TANK);
    bar.style.transform = `scaleX(${fuel / TANK})`;
    const rounded = Math.round(fuel);
    if (rounded !== shown.rounded) text.textContent = WORDS.fuel(rounded);
    shown.rounded = rounded;
  };
}

function createSpeed(find: Find) {
  const text = find('.bh-speed');
  const shown = { spent: -1, speed: -1 };
  return (sim: BlackHoleGame) => {
    const spent = Math.round(sim.rules.spent);
    const speed = Math.round(speedOf(sim));
    if (spent === shown.spent && speed === shown.speed) return;
    shown.spent = spent;
    shown.speed = speed;
    text.textContent = WORDS.speed(spent, speed);
  };
}

function createCall(find: Find, redraw: () => void) {
  const [card, title, text] = [find('.bh-call'), find('.bh-call h2'), find('.bh-call p')];
  const other = find('.bh-redraw');
  other.addEventListener('click', redraw);
  const daily = find('.bh-daily');
  let shown: Call | undefined;
  return (call: Call, isFirst: boolean) => {
    if (daily.hidden === isFirst) daily.hidden = !isFirst;
    if (call === shown) return;
    shown = call;
    card.classList.toggle('low', call[0] === '');
    other.hidden = call[0] === '';
    title.textContent = call[0];
    text.textContent = call[1];
  };
}

function createToast(element: HTMLElement) {
  let timer = 0;
  return {
    show(text: string, color: string) {
      element.textContent = text;
      element.style.color = color;
      element.classList.remove('on');
      // Reading the layout restarts the animation.
      void element.offsetWidth;
      element.classList.add('on');
      // Required where the system disables animations.
      clearTimeout(timer);
      timer = window.setTimeout(() => element.classList.remove('on'), 1700);
    },
    destroy: () => clearTimeout(timer),
  };
}

function speedOf({ scene, world }: BlackHoleGame): number {
  const { x, y } = world.components.Velocity;
  return Math.hypot(x[scene.ship], y[scene.ship]);
}

type Call = readonly [title: string, text: string];

const CALLS = {
  replay: ['', WORDS.replay],
  demo: ['', WORDS.demo],
  autopilot: ['', WORDS.autopilot],
  none: ['', ''],
} satisfies Record<string, Call>;

/** The message before the first flight, and what it was made of. */
let first: { readonly seed: number; readonly goal: string; readonly call: Call } | undefined;
/** One message per level for the other flights. */
const READY = new Map<number, Call>();

function firstCall(seed: number, goal: Palette['goalName']): Call {
  if (first?.seed !== seed || first.goal !== goal) {
    const day = dayOfSeed(seed);
    const title = day === undefined ? WORDS.title : WORDS.dailyTitle(unbroken(day));
    first = { seed, goal, call: [title, `${WORDS.goal[goal]} ${WORDS.launch}.`] };
  }
  return first.call;
}

function readyCall(dodged: number): Call {
  const known = READY.get(dodged);
  if (known !== undefined) return known;
  const made: Call = [WORDS.level(dodged + 1), WORDS.launch];
  READY.set(dodged, made);
  return made;
}

function callOf({ rules, seed, isDemo, isReplay, autopilot }: BlackHoleGame, goal: Palette['goalName']): Call {
  if (isReplay) return CALLS.replay;
  if (isDemo) return CALLS.demo;
  if (autopilot) return CALLS.autopilot;
  if (rules.phase !== 'ready') return CALLS.none;
  return rules.hasBegun ? readyCall(rules.dodged) : firstCall(seed, goal);
}

function toastOf({ kind, points }: GameEvent, { rules, dt }: BlackHoleGame, comparison?: Comparison): string {
  const versus = comparison === undefined ? '' : ` – ${comparisonText(comparison.steps * dt)}`;
  if (kind === 'goal') return `${WORDS.won(points)}${versus}${rules.dodged === 4 ? ` – ${WORDS.nowMoving}` : ''}`;
  if (kind === 'fall') return rules.lives === 0 ? '' : `${WORDS.swallowed} – ${WORDS.lives(rules.lives)}`;
  if (kind === 'left') return WORDS.left;
  if (kind === 'redraw') return WORDS.redrawn;
  if (kind === 'sling') return WORDS.slingshot;
  if (kind === 'empty') return WORDS.empty;
  return '';
}

/** @param seconds how much sooner than the ghost; negative if later */
function comparisonText(seconds: number): string {
  if (seconds === 0) return WORDS.asFast;
  return seconds > 0 ? WORDS.sooner(seconds) : WORDS.later(Math.abs(seconds));
}
