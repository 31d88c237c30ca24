/** The hands of a player: keys, the mouse, fingers. Bots may read how a game stands, but act only by these. */
import type { Locator, Page } from 'playwright-core';
import { fingersOf, frames } from './game-page.ts';

export type Spot = { readonly x: number; readonly y: number };

/** The mouse with its left button, or a finger. */
export interface Pointer {
  press(at: Spot): Promise<unknown>;
  move(at: Spot): Promise<unknown>;
  release(): Promise<unknown>;
}

export function mouseOf({ mouse }: Page): Pointer {
  return {
    async press({ x, y }) {
      await mouse.move(x, y);
      await mouse.down();
    },
    move: ({ x, y }) => mouse.move(x, y),
    release: () => mouse.up(),
  };
}

/** Fingers that press and leave one by one, each a pointer of its own. */
export async function handOf(page: Page): Promise<(id: number) => Pointer> {
  const touch = await fingersOf(page);
  const down = new Map<number, Spot>();
  const all = () => [...down].map(([id, at]) => ({ id, ...at }));
  return (id) => ({
    press(at) {
      down.set(id, at);
      return touch('touchStart', all());
    },
    async move(at) {
      down.set(id, at);
      await touch('touchMove', all());
      // Browsers hand moves of fingers out once a frame.
      await frames(page);
    },
    release() {
      const at = down.get(id);
      down.delete(id);
      // Named are the fingers that leave.
      return touch('touchEnd', at === undefined ? [] : [{ id, ...at }]);
    },
  });
}

/** A single finger. */
export const fingerOf = async (page: Page): Promise<Pointer> => (await handOf(page))(0);

/** Presses, moves there in some steps, and lets go. */
export async function drag(pointer: Pointer, from: Spot, to: Spot, count = 4): Promise<void> {
  await pointer.press(from);
  for (let i = 1; i <= count; i++) {
    await pointer.move({ x: from.x + ((to.x - from.x) * i) / count, y: from.y + ((to.y - from.y) * i) / count });
  }
  await pointer.release();
}

export async function tap(pointer: Pointer, at: Spot): Promise<void> {
  await pointer.press(at);
  await pointer.release();
}

/** The middle of an element. */
export async function middleOf(element: Locator): Promise<Spot> {
  const box = await element.boundingBox();
  if (box === null) throw new Error('The element is not on the page.');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** How a player works the buttons of a page. */
export type Means = 'keys' | 'mouse' | 'touch';
export const MEANS: readonly Means[] = ['keys', 'mouse', 'touch'];

/** A window of a phone for touch, of a desktop else. */
export function windowFor(means: Means) {
  return means === 'touch'
    ? { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }
    : { viewport: { width: 900, height: 600 }, hasTouch: false, isMobile: false };
}

/** Presses a button or a link: by Tab and Enter, by a click, by a tap. */
export async function choose(page: Page, means: Means, button: Locator): Promise<void> {
  if (means === 'mouse') return button.click();
  if (means === 'touch') return button.tap();
  await button.waitFor({ state: 'visible' });
  await focus(page, button);
  await page.keyboard.press('Enter');
}

/** Presses Tab until an element has the focus. */
export async function focus(page: Page, element: Locator): Promise<void> {
  for (let presses = 0; presses < 100; presses++) {
    if (await element.evaluate((it) => it === document.activeElement)) return;
    await page.keyboard.press('Tab');
  }
  throw new Error('Tab does not reach the element.');
}

/** Steers by fractions to the right and up, of which (0, 0) lets go. */
export type Steer = (x: number, y: number) => Promise<unknown>;

/** One way to steer, made for a page. */
export type Steering = (page: Page) => Steer | Promise<Steer>;

/** Holds what is wanted of some names, and lets go of the others first. */
function holder(press: (name: string) => Promise<unknown>, release: (name: string) => Promise<unknown>) {
  const held = new Set<string>();
  return async (wanted: readonly string[]) => {
    for (const name of [...held]) {
      if (wanted.includes(name)) continue;
      held.delete(name);
      await release(name);
    }
    for (const name of wanted) {
      if (held.has(name)) continue;
      held.add(name);
      await press(name);
    }
  };
}

export type Holder = ReturnType<typeof holder>;

/** Holds keys by their names. */
export const holdKeys = ({ keyboard }: Page): Holder =>
  holder(
    (key) => keyboard.down(key),
    (key) => keyboard.up(key),
  );

/** Holds buttons of the touch pad by their names, each with a finger. @param hand fingers from 10 on are used */
export function holdPad(page: Page, hand: (id: number) => Pointer): Holder {
  const fingers = new Map<string, { readonly finger: Pointer; readonly at: Spot }>();
  return holder(
    async (name) => {
      const at = fingers.get(name)?.at ?? (await middleOf(page.locator(`.game-pad [data-name=${name}]`)));
      const finger = fingers.get(name)?.finger ?? hand(10 + fingers.size);
      fingers.set(name, { finger, at });
      await finger.press(at);
    },
    async (name) => fingers.get(name)?.finger.release(),
  );
}

const ways = (x: number, y: number, [left, right, up, down]: readonly [string, string, string, string]) => [
  ...(x === 0 ? [] : [x < 0 ? left : right]),
  ...(y === 0 ? [] : [y < 0 ? down : up]),
];

export const steerByKeys: Steering = (page) => {
  const hold = holdKeys(page);
  return (x, y) => hold(ways(x, y, ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']));
};

export const steerByPad: Steering = async (page) => {
  const hold = holdPad(page, await handOf(page));
  return (x, y) => hold(ways(x, y, ['left', 'right', 'up', 'down']));
};

/**
 * Steers by pressing beside a place and moving about it.
 * @param place where (0, 0) is
 * @param reach CSS pixels of a full deflection
 */
export function steerByPointer(pointer: Pointer, place: () => Promise<Spot>, reach: number): Steer {
  let isDown = false;
  return async (x, y) => {
    if (x === 0 && y === 0) {
      if (isDown) await pointer.release();
      isDown = false;
      return;
    }
    const centre = await place();
    const at = { x: centre.x + reach * x, y: centre.y - reach * y };
    await (isDown ? pointer.move(at) : pointer.press(at));
    isDown = true;
  };
}

/** The stick of the touch pad. */
export function steerByStick(page: Page, finger: Pointer): Steer {
  const stick = page.locator('.game-stick');
  let box: { x: number; y: number; width: number; height: number } | null = null;
  let isDown = false;
  return async (x, y) => {
    if (isDown) await finger.release();
    isDown = x !== 0 || y !== 0;
    if (!isDown) return;
    box ??= await stick.boundingBox();
    if (box === null) throw new Error('The touch pad has no stick.');
    await finger.press({ x: box.x + box.width * (0.5 + 0.4 * x), y: box.y + box.height * (0.5 - 0.4 * y) });
  };
}
