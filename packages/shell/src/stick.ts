/** Analogue sticks: one on the screen for a thumb, and that of a gamepad. */
import { element } from './element.ts';
import { words } from './words.ts';

/** Takes a deflection: fractions per axis, y up, at most 1 long; (0, 0) when released. */
export type Steer = (x: number, y: number) => void;

/** Deflection of a gamepad's stick below which it counts as released; worn sticks rest beside the centre. */
const DEAD_ZONE = 0.15;
/** Steps per unit, so that a resting hand reports nothing new. */
const STEPS = 20;

/** The source of the stick on the screen; that of a gamepad is its index. */
const SCREEN = -1;

/** Reports a deflection only when it changed: of several sources that of the one that is pushed farthest. */
export class Stick {
  #x = 0;
  #y = 0;
  /** x and y by source. */
  readonly #sources = new Map<number, Float64Array>();
  readonly #steer: Steer;

  constructor(steer: Steer) {
    this.#steer = steer;
  }

  get isPushed(): boolean {
    return this.#x !== 0 || this.#y !== 0;
  }

  /** Reports a deflection once more, for a simulation that has not heard of it. */
  reportAgain(): void {
    if (this.isPushed) this.#steer(this.#x, this.#y);
  }

  /** @param x to the right @param y up; beyond a length of 1 both are scaled down @param source the stick that is pushed */
  set(x: number, y: number, source = SCREEN): void {
    const shrink = 1 / Math.max(1, Math.hypot(x, y));
    const roundedX = Math.round(x * shrink * STEPS) / STEPS || 0;
    const roundedY = Math.round(y * shrink * STEPS) / STEPS || 0;
    let known = this.#sources.get(source);
    if (known === undefined) {
      known = new Float64Array(2);
      this.#sources.set(source, known);
    }
    if (roundedX === known[0] && roundedY === known[1]) return;
    known[0] = roundedX;
    known[1] = roundedY;
    this.#report();
  }

  /** Lets go of all sources; one that is still held counts again when it is moved. */
  releaseAll(): void {
    for (const source of this.#sources.values()) source.fill(0);
    this.#report();
  }

  #report(): void {
    let farthest = 0;
    let [x, y] = [0, 0];
    for (const [sourceX, sourceY] of this.#sources.values()) {
      const length = Math.hypot(sourceX, sourceY);
      if (length <= farthest) continue;
      farthest = length;
      [x, y] = [sourceX, sourceY];
    }
    if (x === this.#x && y === this.#y) return;
    this.#x = x;
    this.#y = y;
    this.#steer(x, y);
  }

  /** Reads the left stick of a standard gamepad. */
  read({ axes, index = 0 }: Gamepad): void {
    const [x = 0, y = 0] = axes;
    const size = Math.hypot(x, y);
    const strength = size > DEAD_ZONE ? Math.min(1, (size - DEAD_ZONE) / (1 - DEAD_ZONE)) / size : 0;
    this.set(strength * x, -strength * y, index);
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
