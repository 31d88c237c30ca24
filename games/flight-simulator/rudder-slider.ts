/** The pedals for mouse and finger: a knob that a finger's release centres, and that stays where a mouse leaves it. */
import type { Flight } from './sim.ts';
import { WORDS } from './words.ts';

const STYLES = `
.fs-rudder { position: absolute; left: calc(50% - 184px); bottom: max(12px, env(safe-area-inset-bottom)); translate: -100% 0; width: 172px;
  height: 48px; box-sizing: border-box; border-radius: 24px; border: 1px solid #ffffff38; background: #0b122699; pointer-events: auto;
  touch-action: none; cursor: ew-resize; color: #fff; font: 600 11px/1 system-ui, sans-serif; display: grid; justify-items: center;
  align-items: end; user-select: none; -webkit-user-select: none }
.fs-rudder::before { content: ''; position: absolute; left: 24px; right: 24px; top: 17px; height: 2px; background: #ffffff50 }
.fs-rudder i { position: absolute; left: 50%; top: 4px; width: 28px; height: 28px; margin-left: -14px; border-radius: 50%;
  background: #ffffff80; border: 1px solid #fff; box-sizing: border-box }
.fs-rudder span { padding-bottom: 3px; opacity: .85; position: relative }
.fs-rudder:focus-visible { outline: 2px solid #ffb454 }
@media (pointer: fine) and (max-width: 760px) { .fs-rudder { left: 50%; translate: -50% 0; bottom: 200px } }
@media (pointer: fine) and (max-height: 420px) { .fs-rudder { left: auto; right: 8px; bottom: 8px; translate: none; width: 150px } }
@media (pointer: coarse) { .fs-rudder { left: max(20px, env(safe-area-inset-left)); translate: none; bottom: max(24px, env(safe-area-inset-bottom)) } }
/* Between the instruments, 254 px wide, and the pad. */
@media (pointer: coarse) and (max-height: 500px) { .fs-rudder { left: max(52% - 86px, 268px); width: clamp(112px, 100% - 452px, 172px); bottom: 8px } }
`;

/** Part of the travel that an arrow key moves the pedals by. */
const KEY_STEP = 0.1;
/** Within this part of the travel the pedals are even. */
const DEAD = 0.08;
/** Width of the bar beyond the travel of the knob, CSS pixels. */
const ENDS = 32;

export interface RudderSlider {
  readonly element: HTMLElement;
  /** Shows the pedals, however they were moved. */
  update(flight: Flight): void;
}

/** @param flight gives the present one */
export function createRudderSlider(flight: () => Flight): RudderSlider {
  const element = document.createElement('div');
  element.className = 'fs-rudder';
  element.title = WORDS.rudderHint;
  for (const [name, value] of Object.entries({ role: 'slider', tabindex: '0', 'aria-label': WORDS.rudder })) {
    element.setAttribute(name, value);
  }
  element.setAttribute('aria-valuemin', '-100');
  element.setAttribute('aria-valuemax', '100');
  const style = document.createElement('style');
  style.textContent = STYLES;
  const knob = document.createElement('i');
  const label = document.createElement('span');
  label.textContent = WORDS.rudder;
  element.append(style, knob, label);
  listen(element, (position) => flight().pedals(position));
  element.addEventListener('keydown', (event) => {
    const position = pedalsByKey(event.key, flight().pedalPosition);
    if (position === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    // The arrow keys belong to the stick everywhere else.
    event.preventDefault();
    event.stopPropagation();
    flight().pedals(position);
  });
  let shown = Number.NaN;
  return {
    element,
    update({ pilot }) {
      const percent = Math.round(100 * pilot.pedal);
      if (percent === shown) return;
      shown = percent;
      knob.style.translate = `${((element.clientWidth - ENDS) / 2) * (percent / 100)}px 0`;
      element.setAttribute('aria-valuenow', String(percent));
    },
  };
}

/** Where a key of a slider moves the pedals, that are at a position from −1 to 1; undefined for other keys. */
export function pedalsByKey(key: string, position: number): number | undefined {
  const steps = Math.round(position / KEY_STEP);
  if (key === 'ArrowLeft') return Math.max(-1, (steps - 1) * KEY_STEP);
  if (key === 'ArrowRight') return Math.min(1, (steps + 1) * KEY_STEP);
  if (key === 'Home') return -1;
  return key === 'End' ? 1 : undefined;
}

function listen(element: HTMLElement, move: (position: number) => void): void {
  const follow = (event: PointerEvent) => {
    const { left, width } = element.getBoundingClientRect();
    const position = ((event.clientX - left - width / 2) * 2) / (width - ENDS);
    move(Math.abs(position) < DEAD ? 0 : Math.min(1, Math.max(-1, Math.round(20 * position) / 20)));
  };
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    follow(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (element.hasPointerCapture(event.pointerId)) follow(event);
  });
  for (const type of ['pointerup', 'pointercancel'] as const) {
    element.addEventListener(type, ({ pointerType }) => {
      if (pointerType !== 'mouse') move(0);
    });
  }
  element.addEventListener('dblclick', () => move(0));
  // Who moves the pedals by a mouse goes on flying by the arrow keys, so only Tab gives the focus.
  element.addEventListener('mousedown', (event) => event.preventDefault());
  element.addEventListener('contextmenu', (event) => event.preventDefault());
}
