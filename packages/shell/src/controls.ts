import { element } from './element.ts';
import { HeldButtons } from './held-buttons.ts';
import type { KeyTarget } from './keyboard.ts';
import { createTouchStick, Stick } from './stick.ts';
import { words } from './words.ts';

/** A button that the player holds down by key, touch or gamepad. */
export interface ControlButton {
  /** Label on the touch pad: a symbol or a short word. */
  readonly label: string;
  /** What the button does, for a symbol: a tooltip, and what screen readers say. Default its name. */
  readonly title?: string;
  /** Values of `KeyboardEvent.key`, in lower case. These keys have no other function in the game. */
  readonly keys: readonly string[];
  /** Button indices of a standard gamepad. Default none. */
  readonly pad?: readonly number[];
  /** False leaves the button out of the touch pad; default true. */
  readonly touch?: boolean;
  /** Axis of a gamepad and the direction that counts as pressed, in games that do not `steer`. Default none. */
  readonly axis?: readonly [index: number, sign: 1 | -1];
}

/** How a game is controlled. Button names give the layout of the touch pad: `up`, `left`, `right`, `down`, `action`. */
export interface Controls<Sim> {
  /** The buttons by name. */
  readonly buttons: Readonly<Record<string, ControlButton>>;
  /**
   * Groups of buttons of which only the one pressed last counts, such as directions: when it is let go, the one before it that is still
   * held is pressed again, and `release` follows the last of them. Default none.
   */
  readonly exclusive?: readonly (readonly string[])[];
  /** Shows the touch pad to a mouse too, which has no other way to these buttons; default false. */
  readonly forMouse?: boolean;
  /** The player presses a button: once, however many keys, fingers and gamepads hold it. */
  press(sim: Sim, name: string): void;
  /** The last of them has let go. */
  release(sim: Sim, name: string): void;
  /**
   * Takes the deflection of a stick, on the screen or of a gamepad: fractions per axis, y up, at most 1 long; (0, 0) when
   * it is released. The touch pad then has a stick in place of the four directions.
   */
  steer?(sim: Sim, x: number, y: number): void;
  /**
   * Lets go of what the simulation holds to be pressed, after a moment of the past was restored in which something was that is not now.
   * Default nothing.
   */
  letGo?(sim: Sim): void;
}

/** The listener for keyboard, touch and gamepad input. */
export interface ControlListener {
  /** Reads the gamepads; call it once a frame. */
  poll(): void;
  /** Releases all buttons, as when the window loses the focus. */
  releaseAll(): void;
  /** Lets go of what is held in a moment that was restored, unless the player holds anything now. */
  restore(): void;
  /** Presses in a world that has just begun what the player holds. */
  renew(): void;
  /** Releases all buttons, removes the touch pad and stops listening. */
  destroy(): void;
}

/** Deflection of an axis beyond which it counts as pressed. */
const AXIS_THRESHOLD = 0.5;

let hasGamepad = false;
const NO_GAMEPADS: readonly Gamepad[] = [];

/** Each call of `getGamepads` allocates a list, so it is not called before a gamepad is connected. */
function connectedGamepads(): readonly (Gamepad | null)[] {
  return hasGamepad ? (navigator.getGamepads?.() ?? NO_GAMEPADS) : NO_GAMEPADS;
}

/**
 * Listens to keys, the touch pad and gamepads.
 * @param parent element that receives the touch pad
 * @param sim the simulation that buttons act on
 * @param within hears the keys; default the whole page
 * @param gamepads the gamepads, read in `poll`; default those of the browser
 */
export function listenToControls<Sim>(
  parent: HTMLElement,
  controls: Controls<Sim>,
  sim: () => Sim,
  within: KeyTarget = document,
  gamepads: () => readonly (Gamepad | null)[] = connectedGamepads,
): ControlListener {
  const { buttons } = controls;
  const stick = controls.steer && new Stick((x, y) => controls.steer?.(sim(), x, y));
  const held = new HeldButtons(
    { press: (name) => controls.press(sim(), name), release: (name) => controls.release(sim(), name) },
    controls.exclusive,
  );
  const stopKeys = listenToHeldKeys(buttons, held, within);
  const pad = createTouchPad(buttons, held, stick);
  pad.toggleAttribute('data-mouse', controls.forMouse === true);
  parent.append(pad);
  const releaseAll = () => {
    held.clear();
    stick?.releaseAll();
  };
  globalThis.addEventListener('blur', releaseAll);
  const noticeGamepad = () => {
    hasGamepad = true;
  };
  // A gamepad that was used while the page loaded causes no further `gamepadconnected` event.
  if (navigator.getGamepads?.().some((gamepad) => gamepad !== null)) noticeGamepad();
  globalThis.addEventListener('gamepadconnected', noticeGamepad);
  // What is unplugged while it is pushed can no longer be let go.
  const dropGamepad = ({ gamepad: { index } }: GamepadEvent) => {
    held.drop(holderOf(index));
    stick?.set(0, 0, index);
  };
  globalThis.addEventListener('gamepaddisconnected', dropGamepad);
  return {
    poll() {
      const present = gamepads();
      for (let i = 0; i < present.length; i++) {
        const gamepad = present[i];
        if (!gamepad?.connected) continue;
        readGamepad(gamepad, buttons, held, stick === undefined);
        stick?.read(gamepad);
      }
    },
    releaseAll,
    restore() {
      if (!held.isAnyHeld && stick?.isPushed !== true) controls.letGo?.(sim());
    },
    renew() {
      held.pressAgain();
      stick?.reportAgain();
    },
    destroy() {
      stopKeys();
      globalThis.removeEventListener('blur', releaseAll);
      globalThis.removeEventListener('gamepadconnected', noticeGamepad);
      globalThis.removeEventListener('gamepaddisconnected', dropGamepad);
      pad.remove();
      releaseAll();
    },
  };
}

function listenToHeldKeys(
  buttons: Readonly<Record<string, ControlButton>>,
  held: HeldButtons,
  within: KeyTarget,
): () => void {
  const names = new Map(Object.entries(buttons).flatMap(([name, { keys }]) => keys.map((key) => [key, name])));
  const listen = (event: KeyboardEvent) => {
    const name = names.get(event.key.toLowerCase());
    const down = event.type === 'keydown';
    // A key that is let go counts with whichever other key is held by then.
    if (name === undefined || (down && (event.ctrlKey || event.metaKey || event.altKey))) return;
    const target = event.target as Element | null;
    if (down && target?.closest?.('input, select, textarea, [contenteditable], dialog')) return;
    // What has the focus is pressed by this key.
    if (down && event.key === 'Enter' && target?.closest?.('button, a, summary')) return;
    event.preventDefault();
    if (!event.repeat) held.set(name, event.key.toLowerCase(), down);
  };
  within.addEventListener('keydown', listen);
  document.addEventListener('keyup', listen);
  return () => {
    within.removeEventListener('keydown', listen);
    document.removeEventListener('keyup', listen);
  };
}

/** Creates the buttons for touch; the style sheet shows them where the pointer is coarse. */
function createTouchPad(
  buttons: Readonly<Record<string, ControlButton>>,
  held: HeldButtons,
  stick: Stick | undefined,
): HTMLElement {
  const pad = element('div', 'game-pad', { role: 'group', 'aria-label': words().controls });
  if (stick !== undefined) pad.append(createTouchStick(stick));
  for (const [name, { label, title, touch = true }] of Object.entries(buttons)) {
    if (!touch || (stick !== undefined && Object.hasOwn(FOUR_WAYS, name))) continue;
    const button = element(
      'button',
      '',
      {
        type: 'button',
        'data-name': name,
        'aria-label': title ?? words().ways[name] ?? name,
        ...(title === undefined ? {} : { title }),
      },
      label,
    );
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

const holderOf = (index: number) => `gamepad ${index}`;

/** Handles releases first: a stick moved from one direction to another then ends with the other one pressed. */
function readGamepad(
  gamepad: Gamepad,
  buttons: Readonly<Record<string, ControlButton>>,
  held: HeldButtons,
  usesAxes: boolean,
): void {
  for (const wanted of [false, true]) {
    for (const [name, { pad = [], axis }] of Object.entries(buttons)) {
      const isPushed = usesAxes && axis !== undefined && (gamepad.axes[axis[0]] ?? 0) * axis[1] > AXIS_THRESHOLD;
      const isDown = isPushed || pad.some((index) => gamepad.buttons[index]?.pressed);
      if (isDown === wanted) held.set(name, holderOf(gamepad.index), isDown);
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
