/** Predicts the ship's flight without a world, for the dotted path and the autopilot. */
import { BLACK_HOLE, type Hole, holeMu, holePosition } from '@principia/scenes';

/** Position and velocity of a ship, m and m/s. */
export interface ShipState {
  x: number;
  y: number;
  vx: number;
  vy: number;
}

/** Whether the flight goes on or how it ended. */
export type FlightStatus = 'flying' | 'fallen' | 'goal' | 'gone';

/** Indices into the state of a flight. */
const [X, Y, VX, VY, AX, AY, TIME] = [0, 1, 2, 3, 4, 5, 6];

/** Steps a copy of the ship by velocity Verlet, as the world does, past the holes of one layout. */
export class Flight {
  status: FlightStatus = 'flying';
  /** Position, velocity, acceleration and time. A typed array: thousands of steps a second then allocate nothing. */
  readonly #state = new Float64Array(7);
  readonly #isSteep: boolean;
  #holes: readonly Hole[] = [];
  #mu = new Float64Array(0);
  readonly #holePosition = { x: 0, y: 0 };

  /** @param isSteep uses the Paczyński–Wiita potential */
  constructor(isSteep = false) {
    this.#isSteep = isSteep;
  }

  /** Starts the flight from the ship's state. @param time of the moving holes on their orbits, s */
  begin(craft: Readonly<ShipState>, holes: readonly Hole[], time: number): void {
    const state = this.#state;
    state[X] = craft.x;
    state[Y] = craft.y;
    state[VX] = craft.vx;
    state[VY] = craft.vy;
    state[TIME] = time;
    this.status = 'flying';
    if (this.#holes !== holes) {
      this.#holes = holes;
      this.#mu = Float64Array.from(holes, ({ radius }) => holeMu(radius));
    }
    this.#updateAcceleration();
  }

  get x(): number {
    return this.#state[X];
  }

  get y(): number {
    return this.#state[Y];
  }

  /** Takes one step under a thrust acceleration, m/s². Does nothing once the flight has ended. */
  step(dt: number, thrust: { readonly x: number; readonly y: number }): void {
    if (this.status !== 'flying') return;
    const state = this.#state;
    state[VX] += 0.5 * dt * (state[AX] + thrust.x);
    state[VY] += 0.5 * dt * (state[AY] + thrust.y);
    state[X] += dt * state[VX];
    state[Y] += dt * state[VY];
    state[TIME] += dt;
    this.#updateAcceleration();
    state[VX] += 0.5 * dt * (state[AX] + thrust.x);
    state[VY] += 0.5 * dt * (state[AY] + thrust.y);
    if (this.status !== 'flying') return;
    if (state[Y] > BLACK_HOLE.goal) this.status = 'goal';
    else if (state[X] < 0 || state[X] > BLACK_HOLE.width || state[Y] < 0) this.status = 'gone';
  }

  /** Sums the gravity of all holes and detects a fall. */
  #updateAcceleration(): void {
    const state = this.#state;
    let ax = 0;
    let ay = 0;
    for (let i = 0; i < this.#holes.length; i++) {
      const hole = this.#holes[i];
      const at = hole.orbit === 0 ? hole : holePosition(hole, state[TIME], this.#holePosition);
      const dx = at.x - state[X];
      const dy = at.y - state[Y];
      const square = dx * dx + dy * dy;
      if (square <= hole.radius * hole.radius) this.status = 'fallen';
      const d = Math.sqrt(square);
      const gap = d - hole.radius;
      const pull = this.#mu[i] / ((this.#isSteep ? gap * gap : square) * d + 1e-9);
      ax += pull * dx;
      ay += pull * dy;
    }
    state[AX] = ax;
    state[AY] = ay;
  }
}
