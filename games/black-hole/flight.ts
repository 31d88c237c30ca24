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

/** Steps a copy of the ship by velocity Verlet, as the world does, past the holes of one layout. */
export class Flight {
  readonly craft: Craft = { x: 0, y: 0, vx: 0, vy: 0 };
  fate: Fate = 'flying';
  time = 0;
  readonly #isSteep: boolean;
  #holes: readonly Hole[] = [];
  #mu: number[] = [];
  readonly #place = { x: 0, y: 0 };
  #ax = 0;
  #ay = 0;

  /** @param isSteep the holes pull after Paczyński and Wiita */
  constructor(isSteep = false) {
    this.#isSteep = isSteep;
  }

  /** Sets the copy where the ship is. @param time of the holes on their circles, s */
  begin(craft: Readonly<Craft>, holes: readonly Hole[], time: number): void {
    Object.assign(this.craft, craft);
    this.fate = 'flying';
    this.time = time;
    if (this.#holes !== holes) {
      this.#holes = holes;
      this.#mu = holes.map(({ radius }) => holeMu(radius));
    }
    this.#pull();
  }

  /** One step under a thrust of (`tx`, `ty`) m/s². Does nothing once the flight has ended. */
  step(dt: number, tx: number, ty: number): void {
    if (this.fate !== 'flying') return;
    const { craft } = this;
    const vx = craft.vx + 0.5 * dt * (this.#ax + tx);
    const vy = craft.vy + 0.5 * dt * (this.#ay + ty);
    craft.x += dt * vx;
    craft.y += dt * vy;
    this.time += dt;
    this.#pull();
    craft.vx = vx + 0.5 * dt * (this.#ax + tx);
    craft.vy = vy + 0.5 * dt * (this.#ay + ty);
    if (this.fate !== 'flying') return;
    if (craft.y > BLACK_HOLE.goal) this.fate = 'goal';
    else if (craft.x < 0 || craft.x > BLACK_HOLE.width || craft.y < 0) this.fate = 'gone';
  }

  /** Sums the pull of all holes, and notices a fall. */
  #pull(): void {
    const { craft } = this;
    let ax = 0;
    let ay = 0;
    for (let i = 0; i < this.#holes.length; i++) {
      const hole = this.#holes[i];
      const at = hole.orbit === 0 ? hole : holePlace(hole, this.time, this.#place);
      const dx = at.x - craft.x;
      const dy = at.y - craft.y;
      const square = dx * dx + dy * dy;
      if (square <= hole.radius * hole.radius) this.fate = 'fallen';
      const d = Math.sqrt(square);
      const gap = d - hole.radius;
      const pull = this.#mu[i] / ((this.#isSteep ? gap * gap : square) * d + 1e-9);
      ax += pull * dx;
      ay += pull * dy;
    }
    this.#ax = ax;
    this.#ay = ay;
  }
}
