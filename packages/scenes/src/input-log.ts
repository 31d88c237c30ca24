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
  readonly #taken: LoggedInput<Input>[] = [];
  readonly #waiting: Input[] = [];
  readonly #script: readonly LoggedInput<Input>[];
  #next = 0;

  /** @param script inputs of an earlier game, played as if they came now */
  constructor(script: readonly LoggedInput<Input>[] = []) {
    this.#script = [...script];
  }

  /** Everything steps have taken so far, oldest first. */
  get entries(): readonly LoggedInput<Input>[] {
    return this.#taken;
  }

  /** An input for the next step. */
  add(input: Input): void {
    this.#waiting.push(input);
  }

  /** Hands the inputs of the step that begins at `tick` to `use`, in the order they came. */
  take(tick: number, use: (input: Input) => void): void {
    while (this.#next < this.#script.length && this.#script[this.#next].tick <= tick) {
      this.#use(tick, this.#script[this.#next++].input, use);
    }
    for (const input of this.#waiting.splice(0)) this.#use(tick, input, use);
  }

  /** Whether inputs of an earlier game are still to come. */
  get isScripted(): boolean {
    return this.#next < this.#script.length;
  }

  /** Leaves out the rest of the earlier game. */
  endScript(): void {
    this.#next = this.#script.length;
  }

  /** Notes what was taken so far; returns what forgets all that was taken since, as when a game goes back in time. */
  remember(): () => void {
    const count = this.#taken.length;
    const next = this.#next;
    return () => {
      this.#taken.length = count;
      this.#waiting.length = 0;
      this.#next = next;
    };
  }

  #use(tick: number, input: Input, use: (input: Input) => void): void {
    this.#taken.push({ tick, input });
    use(input);
  }
}
