/** The ship's way in advance, without a world: for the dotted path, and for the autopilot. */
import { BLACK_HOLE, type Hole, holeMu, holePlace } from '@principia/scenes';

/** A ship as far as its flight is concerned. */
export interface Craft {
  x: number;
  y: number;
  vx: number;
  vy: number;
}

/** How a flight stands. */
export type Fate = 'flying' | 'fallen' | 'goal' | 'gone';

/** Where the numbers of a flight are. */
const [X, Y, VX, VY, AX, AY, TIME] = [0, 1, 2, 3, 4, 5, 6];

/** Steps a copy of the ship by velocity Verlet, as the world does, past the holes of one layout. */
export class Flight {
  fate: Fate = 'flying';
  /** Place, velocity, acceleration and time: in an array, where thousands of steps a second leave no garbage. */
  readonly #now = new Float64Array(7);
  readonly #isSteep: boolean;
  #holes: readonly Hole[] = [];
  #mu = new Float64Array(0);
  readonly #place = { x: 0, y: 0 };

  /** @param isSteep the holes pull after Paczyński and Wiita */
  constructor(isSteep = false) {
    this.#isSteep = isSteep;
  }

  /** Sets the copy where the ship is. @param time of the holes on their circles, s */
  begin(craft: Readonly<Craft>, holes: readonly Hole[], time: number): void {
    const now = this.#now;
    now[X] = craft.x;
    now[Y] = craft.y;
    now[VX] = craft.vx;
    now[VY] = craft.vy;
    now[TIME] = time;
    this.fate = 'flying';
    if (this.#holes !== holes) {
      this.#holes = holes;
      this.#mu = Float64Array.from(holes, ({ radius }) => holeMu(radius));
    }
    this.#pull();
  }

  get x(): number {
    return this.#now[X];
  }

  get y(): number {
    return this.#now[Y];
  }

  /** One step under a thrust, m/s². Does nothing once the flight has ended. */
  step(dt: number, thrust: { readonly x: number; readonly y: number }): void {
    if (this.fate !== 'flying') return;
    const now = this.#now;
    now[VX] += 0.5 * dt * (now[AX] + thrust.x);
    now[VY] += 0.5 * dt * (now[AY] + thrust.y);
    now[X] += dt * now[VX];
    now[Y] += dt * now[VY];
    now[TIME] += dt;
    this.#pull();
    now[VX] += 0.5 * dt * (now[AX] + thrust.x);
    now[VY] += 0.5 * dt * (now[AY] + thrust.y);
    if (this.fate !== 'flying') return;
    if (now[Y] > BLACK_HOLE.goal) this.fate = 'goal';
    else if (now[X] < 0 || now[X] > BLACK_HOLE.width || now[Y] < 0) this.fate = 'gone';
  }

  /** Sums the pull of all holes, and notices a fall. */
  #pull(): void {
    const now = this.#now;
    let ax = 0;
    let ay = 0;
    for (let i = 0; i < this.#holes.length; i++) {
      const hole = this.#holes[i];
      const at = hole.orbit === 0 ? hole : holePlace(hole, now[TIME], this.#place);
      const dx = at.x - now[X];
      const dy = at.y - now[Y];
      const square = dx * dx + dy * dy;
      if (square <= hole.radius * hole.radius) this.fate = 'fallen';
      const d = Math.sqrt(square);
      const gap = d - hole.radius;
      const pull = this.#mu[i] / ((this.#isSteep ? gap * gap : square) * d + 1e-9);
      ax += pull * dx;
      ay += pull * dy;
    }
    now[AX] = ax;
    now[AY] = ay;
  }
}
