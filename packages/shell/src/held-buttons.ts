/** What buttons do; `release` follows when the last input has let go. */
export interface ButtonActions {
  press(name: string): void;
  release(name: string): void;
}

/**
 * Counts the inputs that hold each button, so that two inputs on one button cause one press. Of an exclusive group only the button
 * that was pressed last counts: when it is let go, the one before it that is still held is pressed again.
 */
export class HeldButtons {
  readonly #holders = new Map<string, Set<string>>();
  /** The held buttons of each exclusive group, the last pressed last. */
  readonly #orders = new Map<string, string[]>();
  readonly #actions: ButtonActions;

  constructor(actions: ButtonActions, exclusive: readonly (readonly string[])[] = []) {
    this.#actions = actions;
    for (const group of exclusive) {
      const order: string[] = [];
      for (const name of group) this.#orders.set(name, order);
    }
  }

  get isAnyHeld(): boolean {
    return [...this.#holders.values()].some(({ size }) => size > 0);
  }

  /** @param holder the input that holds the button: a key, a pointer or a gamepad */
  set(name: string, holder: string, down: boolean): void {
    const holders = this.#holders.get(name) ?? new Set();
    this.#holders.set(name, holders);
    const before = holders.size;
    if (down) holders.add(holder);
    else holders.delete(holder);
    if (before === 0 && holders.size > 0) this.#press(name);
    if (before > 0 && holders.size === 0) this.#release(name);
  }

  #press(name: string): void {
    this.#orders.get(name)?.push(name);
    this.#actions.press(name);
  }

  #release(name: string): void {
    const order = this.#orders.get(name);
    if (order === undefined) {
      this.#actions.release(name);
      return;
    }
    const counted = order.at(-1) === name;
    order.splice(order.indexOf(name), 1);
    const next = order.at(-1);
    if (!counted) return;
    if (next === undefined) this.#actions.release(name);
    else this.#actions.press(next);
  }

  /** An input that is gone, such as a gamepad that was unplugged, lets go of all it held. */
  drop(holder: string): void {
    for (const name of this.#holders.keys()) this.set(name, holder, false);
  }

  /** Presses what is held once more, for a simulation that has not heard of it. */
  pressAgain(): void {
    for (const order of new Set(this.#orders.values())) {
      const last = order.at(-1);
      if (last !== undefined) this.#actions.press(last);
    }
    for (const [name, { size }] of this.#holders) if (size > 0 && !this.#orders.has(name)) this.#actions.press(name);
  }

  clear(): void {
    for (const order of new Set(this.#orders.values())) {
      const last = order.pop();
      order.length = 0;
      if (last !== undefined) this.#actions.release(last);
    }
    for (const [name, holders] of this.#holders) {
      if (holders.size === 0) continue;
      holders.clear();
      if (!this.#orders.has(name)) this.#actions.release(name);
    }
  }
}
