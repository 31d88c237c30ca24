/** The path of the present flight, ten positions a second in whole decimetres: what the ghost of the best flight is made of. */

/** Steps between two positions: at 120 steps a second they are a tenth of a second apart. */
export const SAMPLE_STEPS = 12;
/** A flight of more than a minute and a half keeps its beginning only, and is no best flight. */
export const MAX_SAMPLES = 900;
/** Length of a unit of the path, m. */
export const PATH_UNIT = 0.1;

export class FlightRecord {
  /** Mutable state; pass it to `keepState`. */
  readonly state = { steps: 0, isSteeredByPlayer: true, path: new Int16Array(2 * MAX_SAMPLES) };

  /** Number of steps of the flight so far. */
  get steps(): number {
    return this.state.steps;
  }

  /** Forgets the last flight; the next step is the first of another. */
  clear(): void {
    this.state.steps = 0;
    this.state.isSteeredByPlayer = true;
  }

  /** Marks the flight as one that the autopilot has steered. */
  markAssisted(): void {
    this.state.isSteeredByPlayer = false;
  }

  /** Adds the position of the ship after a step, m. */
  add(x: number, y: number): void {
    const { state } = this;
    const sample = state.steps / SAMPLE_STEPS;
    if (Number.isInteger(sample) && sample < MAX_SAMPLES) {
      state.path[2 * sample] = Math.round(x / PATH_UNIT);
      state.path[2 * sample + 1] = Math.round(y / PATH_UNIT);
    }
    state.steps++;
  }

  /** The path so far: x and y in turn, in units of `PATH_UNIT`; undefined if it is not a player's, or too long. */
  path(): number[] | undefined {
    const { steps, isSteeredByPlayer, path } = this.state;
    const count = Math.ceil(steps / SAMPLE_STEPS);
    return isSteeredByPlayer && count > 0 && count <= MAX_SAMPLES ? [...path.subarray(0, 2 * count)] : undefined;
  }
}
