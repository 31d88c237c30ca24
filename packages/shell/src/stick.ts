/** Analogue sticks: one on the screen for a thumb, and that of a gamepad. */
import { element } from './element.ts';
import { words } from './words.ts';

/** Takes a deflection: fractions per axis, y up, at most 1 long; (0, 0) when released. */
export type Steer = (x: number, y: number) => void;

/** Deflection of a gamepad's stick below which it counts as released; worn sticks rest beside the centre. */
const DEAD_ZONE = 0.15;
/** Steps per unit, so that a resting hand reports nothing new. */
const STEPS = 20;

/** Reports a deflection only when it changed. */
export class Stick {
  #x = 0;
  #y = 0;
  readonly #steer: Steer;

  constructor(steer: Steer) {
    this.#steer = steer;
  }

  /** @param x to the right @param y up; beyond a length of 1 both are scaled down */
  set(x: number, y: number): void {
    const shrink = 1 / Math.max(1, Math.hypot(x, y));
    const roundedX = Math.round(x * shrink * STEPS) / STEPS || 0;
    const roundedY = Math.round(y * shrink * STEPS) / STEPS || 0;
    if (roundedX === this.#x && roundedY === this.#y) return;
    this.#x = roundedX;
    this.#y = roundedY;
    this.#steer(roundedX, roundedY);
  }

  /** Reads the left stick of a standard gamepad. */
  read({ axes }: Gamepad): void {
    const [x = 0, y = 0] = axes;
    const size = Math.hypot(x, y);
    const strength = size > DEAD_ZONE ? Math.min(1, (size - DEAD_ZONE) / (1 - DEAD_ZONE)) / size : 0;
    this.set(strength * x, -strength * y);
  }
}

/** Creates a stick on the screen, to be dragged from its centre. */
export function createTouchStick(stick: Stick): HTMLElement {
  const knob = element('i', '');
  const base = element('div', 'game-stick', { role: 'img', 'aria-label': words().stick }, knob);
  let pointer: number | undefined;
  const move = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    const { left, top, width, height } = base.getBoundingClientRect();
    const reach = width / 3;
    const x = (event.clientX - left - width / 2) / reach;
    const y = (event.clientY - top - height / 2) / reach;
    const shrink = reach / Math.max(1, Math.hypot(x, y));
    knob.style.translate = `${x * shrink}px ${y * shrink}px`;
    stick.set(x, -y);
  };
  const release = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    pointer = undefined;
    knob.style.translate = '';
    stick.set(0, 0);
  };
  base.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    if (pointer !== undefined) return;
    pointer = event.pointerId;
    base.setPointerCapture(pointer);
    move(event);
  });
  base.addEventListener('pointermove', move);
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
    base.addEventListener(type, release);
  base.addEventListener('contextmenu', (event) => event.preventDefault());
  return base;
}
