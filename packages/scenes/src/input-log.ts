/** An input and its step. With the seed of the world, a log of inputs suffices to replay a game. */
export interface LoggedInput<Input> {
  /** `world.tick` of the step that processed the input. */
  readonly tick: number;
  readonly input: Input;
}

/**
 * The inputs of a game. Live and replayed inputs wait here until the next step processes them, so that a replay is
 * bitwise identical.
 */
export class InputLog<Input> {
  /** Mutable state; pass it to `keepState`, so that restoring the world also discards later inputs. */
  readonly state = { taken: 0, next: 0, waiting: [] as Input[] };
  /** Only the first `state.taken` entries are valid; later ones were discarded by a restore. */
  readonly #taken: LoggedInput<Input>[] = [];
  readonly #script: readonly LoggedInput<Input>[];

  /** @param script inputs of an earlier game to replay */
  constructor(script: readonly LoggedInput<Input>[] = []) {
    this.#script = [...script];
  }

  /** All processed inputs, oldest first. */
  get entries(): readonly LoggedInput<Input>[] {
    this.#taken.length = this.state.taken;
    return this.#taken;
  }

  /** Adds an input for the next step. */
  add(input: Input): void {
    this.state.waiting.push(input);
  }

  /** Passes the inputs of the step that begins at `tick` to `use`, in order of arrival. */
  take(tick: number, use: (input: Input) => void): void {
    const { state } = this;
    while (state.next < this.#script.length && this.#script[state.next].tick <= tick) {
      this.#use(tick, this.#script[state.next++].input, use);
    }
    if (state.waiting.length === 0) return;
    for (const input of state.waiting.splice(0)) this.#use(tick, input, use);
  }

  /** Whether inputs of the earlier game remain. */
  get isScripted(): boolean {
    return this.state.next < this.#script.length;
  }

  /** Discards the rest of the earlier game. */
  endScript(): void {
    this.state.next = this.#script.length;
  }

  #use(tick: number, input: Input, use: (input: Input) => void): void {
    this.#taken.length = this.state.taken++;
    this.#taken.push({ tick, input });
    use(input);
  }
}
