import { element } from './element.ts';

/** Something the player holds down: the same by key, by finger and by gamepad. */
export interface ControlButton {
  /** What it is called on the touch pad: one sign or a short word. */
  readonly label: string;
  /** Names as in `KeyboardEvent.key`, in lower case; they do nothing else in this game. */
  readonly keys: readonly string[];
  /** Buttons of a standard gamepad. */
  readonly pad?: readonly number[];
  /** Axis of a gamepad and the side of it that counts as pressed. */
  readonly axis?: readonly [index: number, sign: 1 | -1];
}

/** How a game is steered. Names of buttons place them on the touch pad: `up`, `left`, `right`, `down`, `action`. */
export interface Controls<Sim> {
  readonly buttons: Readonly<Record<string, ControlButton>>;
  press(sim: Sim, name: string): void;
  release(sim: Sim, name: string): void;
}

/** Listens to the player's hands. */
export interface ControlListener {
  /** Looks at the gamepads; call it once a frame. */
  poll(): void;
  /** Lets go of everything, as when the window loses the keyboard. */
  releaseAll(): void;
  destroy(): void;
}

/** An axis pushed farther than this counts as pressed. */
const AXIS_THRESHOLD = 0.5;

let hasGamepad = false;
const NO_GAMEPADS: readonly Gamepad[] = [];

/** Every look at the gamepads is a new list of the browser's: none is taken before there is one. */
function connectedGamepads(): readonly (Gamepad | null)[] {
  return hasGamepad ? (navigator.getGamepads?.() ?? NO_GAMEPADS) : NO_GAMEPADS;
}

/** Counts who holds each button, so that two ways to press one are one press. */
class HeldButtons {
  readonly #holders = new Map<string, Set<string>>();
  readonly #press: (name: string) => void;
  readonly #release: (name: string) => void;

  constructor(press: (name: string) => void, release: (name: string) => void) {
    this.#press = press;
    this.#release = release;
  }

  /** @param holder who holds it: a key, a finger, a gamepad */
  set(name: string, holder: string, down: boolean): void {
    const holders = this.#holders.get(name) ?? new Set();
    this.#holders.set(name, holders);
    const before = holders.size;
    if (down) holders.add(holder);
    else holders.delete(holder);
    if (before === 0 && holders.size > 0) this.#press(name);
    if (before > 0 && holders.size === 0) this.#release(name);
  }

  clear(): void {
    for (const [name, holders] of this.#holders) {
      if (holders.size === 0) continue;
      holders.clear();
      this.#release(name);
    }
  }
}

/** Listens to keys, to a pad on touch screens, and to gamepads. @param parent where the touch pad goes */
export function listenToControls<Sim>(
  parent: HTMLElement,
  controls: Controls<Sim>,
  sim: () => Sim,
  gamepads: () => readonly (Gamepad | null)[] = connectedGamepads,
): ControlListener {
  const { buttons } = controls;
  const held = new HeldButtons(
    (name) => controls.press(sim(), name),
    (name) => controls.release(sim(), name),
  );
  const stopKeys = listenToHeldKeys(buttons, held);
  const pad = createTouchPad(buttons, held);
  parent.append(pad);
  const releaseAll = () => held.clear();
  globalThis.addEventListener('blur', releaseAll);
  const noticeGamepad = () => {
    hasGamepad = true;
  };
  // One that was used while the page loaded is not announced again.
  if (navigator.getGamepads?.().some((gamepad) => gamepad !== null)) noticeGamepad();
  globalThis.addEventListener('gamepadconnected', noticeGamepad);
  return {
    poll() {
      const present = gamepads();
      for (let i = 0; i < present.length; i++) {
        const gamepad = present[i];
        if (gamepad?.connected) readGamepad(gamepad, buttons, held);
      }
    },
    releaseAll,
    destroy() {
      stopKeys();
      globalThis.removeEventListener('blur', releaseAll);
      globalThis.removeEventListener('gamepadconnected', noticeGamepad);
      pad.remove();
      releaseAll();
    },
  };
}

function listenToHeldKeys(buttons: Readonly<Record<string, ControlButton>>, held: HeldButtons): () => void {
  const names = new Map(Object.entries(buttons).flatMap(([name, { keys }]) => keys.map((key) => [key, name])));
  const listen = (event: KeyboardEvent) => {
    const name = names.get(event.key.toLowerCase());
    if (name === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as Element | null;
    const down = event.type === 'keydown';
    if (down && target?.closest?.('input, select, textarea, [contenteditable], dialog')) return;
    event.preventDefault();
    if (!event.repeat) held.set(name, event.key.toLowerCase(), down);
  };
  document.addEventListener('keydown', listen);
  document.addEventListener('keyup', listen);
  return () => {
    document.removeEventListener('keydown', listen);
    document.removeEventListener('keyup', listen);
  };
}

/** Buttons for fingers; the style sheet shows them where the pointer is coarse. */
function createTouchPad(buttons: Readonly<Record<string, ControlButton>>, held: HeldButtons): HTMLElement {
  const pad = element('div', 'game-pad', { role: 'group', 'aria-label': 'Controls' });
  for (const [name, { label }] of Object.entries(buttons)) {
    const button = element('button', '', { type: 'button', 'data-name': name, 'aria-label': name }, label);
    button.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      button.setPointerCapture(event.pointerId);
      held.set(name, `pointer ${event.pointerId}`, true);
    });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      button.addEventListener(type, (event) => held.set(name, `pointer ${event.pointerId}`, false));
    }
    button.addEventListener('contextmenu', (event) => event.preventDefault());
    pad.append(button);
  }
  return pad;
}

/** What is let go comes first: a stick that is moved from one way to another ends up pressing the other. */
function readGamepad(gamepad: Gamepad, buttons: Readonly<Record<string, ControlButton>>, held: HeldButtons): void {
  for (const wanted of [false, true]) {
    for (const [name, { pad = [], axis }] of Object.entries(buttons)) {
      const isPushed = axis !== undefined && (gamepad.axes[axis[0]] ?? 0) * axis[1] > AXIS_THRESHOLD;
      const isDown = isPushed || pad.some((index) => gamepad.buttons[index]?.pressed);
      if (isDown === wanted) held.set(name, `gamepad ${gamepad.index}`, isDown);
    }
  }
}

/** The four directions by arrow keys, d-pad and left stick. */
export const FOUR_WAYS = {
  up: { label: '▲', keys: ['arrowup'], pad: [12], axis: [1, -1] },
  left: { label: '◀', keys: ['arrowleft'], pad: [14], axis: [0, -1] },
  right: { label: '▶', keys: ['arrowright'], pad: [15], axis: [0, 1] },
  down: { label: '▼', keys: ['arrowdown'], pad: [13], axis: [1, 1] },
} as const satisfies Record<string, ControlButton>;
