/** What a player did at which step: with the seed of a world, all that is needed to play a game again. */
export interface LoggedInput<Input> {
  /** `world.tick` of the step that took it. */
  readonly tick: number;
  readonly input: Input;
}

/**
 * The inputs of a game. Whatever comes from keys, fingers or a log waits here until the next step takes it, so that a
 * game played from its log is the same to the bit.
 */
export class InputLog<Input> {
  /** How far it is: name it to `keepState`, and a world that goes back in time forgets what was done since. */
  readonly state = { taken: 0, next: 0, waiting: [] as Input[] };
  /** The first `state.taken` count; the others were given up. */
  readonly #taken: LoggedInput<Input>[] = [];
  readonly #script: readonly LoggedInput<Input>[];

  /** @param script inputs of an earlier game, played as if they came now */
  constructor(script: readonly LoggedInput<Input>[] = []) {
    this.#script = [...script];
  }

  /** Everything steps have taken so far, oldest first. */
  get entries(): readonly LoggedInput<Input>[] {
    this.#taken.length = this.state.taken;
    return this.#taken;
  }

  /** An input for the next step. */
  add(input: Input): void {
    this.state.waiting.push(input);
  }

  /** Hands the inputs of the step that begins at `tick` to `use`, in the order they came. */
  take(tick: number, use: (input: Input) => void): void {
    const { state } = this;
    while (state.next < this.#script.length && this.#script[state.next].tick <= tick) {
      this.#use(tick, this.#script[state.next++].input, use);
    }
    if (state.waiting.length === 0) return;
    for (const input of state.waiting.splice(0)) this.#use(tick, input, use);
  }

  /** Whether inputs of an earlier game are still to come. */
  get isScripted(): boolean {
    return this.state.next < this.#script.length;
  }

  /** Leaves out the rest of the earlier game. */
  endScript(): void {
    this.state.next = this.#script.length;
  }

  #use(tick: number, input: Input, use: (input: Input) => void): void {
    this.#taken.length = this.state.taken++;
    this.#taken.push({ tick, input });
    use(input);
  }
}
