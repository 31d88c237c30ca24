/** Random input, as of a child at the keyboard: keys, pointer, wheel, and every control of the panel at its limits. */
import type { Page } from 'playwright-core';

/**
 * Plays `rounds` of half a second each: an input and 30 steps, or as many as fit into 60 ms.
 * @returns the errors that were shown or written to the console, each with the inputs before it
 */
export function playAtRandom(page: Page, rounds: number, seed: number): Promise<string[]> {
  return page.evaluate(playInPage, { rounds, seed });
}

/** Runs in the page. */
async function playInPage({ rounds, seed }: { rounds: number; seed: number }): Promise<string[]> {
  const errors: string[] = [];
  const inputs: string[] = [];
  const note = (text: string) => errors.push(`${text.slice(0, 300)} (after ${inputs.slice(-8).join('; ')})`);
  const write = console.error;
  console.error = (...text: unknown[]) => void note(text.join(' '));
  // The generator of Park and Miller.
  let state = seed;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
  const keys = [
    ...'abcdeghijklnopqrstuvwxyz0123456789 +-',
    'ArrowUp',
    'ArrowDown',
    'ArrowLeft',
    'ArrowRight',
    'Escape',
  ];
  const stage = document.querySelector('.game-stage') as HTMLElement;
  const down = new Set<string>();
  const place = () => {
    const box = stage.getBoundingClientRect();
    return { clientX: box.left + random() * box.width, clientY: box.top + random() * box.height };
  };
  const pointer = (type: string, init: PointerEventInit = {}) => {
    const target = stage.querySelector('canvas') ?? stage;
    const options = {
      bubbles: true,
      cancelable: true,
      pointerId: 1,
      isPrimary: true,
      pointerType: 'mouse',
      ...place(),
    };
    target.dispatchEvent(
      new PointerEvent(type, { button: 0, buttons: type === 'pointerup' ? 0 : 1, ...options, ...init }),
    );
  };
  const actions = {
    key() {
      const key = pick(keys);
      const type = down.delete(key) ? 'keyup' : 'keydown';
      if (type === 'keydown') down.add(key);
      inputs.push(`${type} ${key}`);
      document.body.dispatchEvent(new KeyboardEvent(type, { key, code: key, bubbles: true, cancelable: true }));
    },
    drag() {
      inputs.push('drag');
      pointer('pointerdown');
      for (let i = 0; i < 4; i++) pointer('pointermove');
      pointer(pick(['pointerup', 'pointerup', 'pointercancel']));
    },
    press() {
      inputs.push('press');
      pointer('pointerdown');
      pointer('pointerup');
    },
    wheel() {
      inputs.push('wheel');
      const deltaY = (random() - 0.5) * 2000;
      stage
        .querySelector('canvas')
        ?.dispatchEvent(new WheelEvent('wheel', { deltaY, bubbles: true, cancelable: true, ...place() }));
    },
    control() {
      const controls = [
        ...document.querySelectorAll<HTMLInputElement | HTMLSelectElement>('.game-side input, .game-side select'),
      ];
      const control = pick(controls.filter(({ offsetParent }) => offsetParent !== null));
      if (control === undefined) return;
      if (control instanceof HTMLSelectElement) control.selectedIndex = Math.floor(random() * control.options.length);
      else if (control.type === 'checkbox') control.checked = !control.checked;
      else
        control.value = pick([
          control.min,
          control.max,
          String(Number(control.min) + random() * (Number(control.max) - Number(control.min))),
        ]);
      inputs.push(
        `${control.labels?.[0]?.textContent ?? control.ariaLabel ?? control.id} = ${control.type === 'checkbox' ? (control as HTMLInputElement).checked : control.value}`,
      );
      for (const type of ['input', 'change']) control.dispatchEvent(new Event(type, { bubbles: true }));
    },
  };
  for (let round = 0; round < rounds; round++) {
    actions[pick(['key', 'drag', 'press', 'wheel', 'control', 'control'] as const)]();
    const until = performance.now() + 60;
    try {
      for (let i = 0; i < 30 && performance.now() < until; i++) __game.step(1);
    } catch (error) {
      note(`step: ${(error as Error).message}`);
      break;
    }
    await new Promise((done) => requestAnimationFrame(done));
    const banner = document.querySelector<HTMLElement>('.game-banner');
    if (banner?.hidden === false && banner.dataset.kind === 'error') {
      note(banner.textContent ?? '');
      break;
    }
  }
  console.error = write;
  return errors;
}
