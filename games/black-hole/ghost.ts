/** The ghost: a pale ship that flies the player's fastest flight past the same holes, beside the present one. */
import { Container, Graphics } from 'pixi.js';
import { type BestFlight, BestFlights, layoutKey } from './best-flights.ts';
import { PATH_UNIT, SAMPLE_STEPS } from './flight-record.ts';
import type { BlackHoleGame } from './sim.ts';

/** What the goal of a flight means beside the best one; `steps` is how much sooner the flight was. */
export interface Comparison {
  readonly steps: number;
}

export class Ghost {
  readonly container: Container;
  readonly #flights: BestFlights;
  /** The game that is watched, the last step that was seen, and whether the player went back in time or watched a replay. */
  #sim: BlackHoleGame | undefined;
  #tick = 0;
  #isRanked = true;
  /** The layout for which a flight was looked up last, and the flight. */
  #holes: BlackHoleGame['scene']['holes'] | undefined;
  #hasFuel = true;
  #flight: BestFlight | undefined;

  constructor(flights = new BestFlights()) {
    this.#flights = flights;
    const hull = new Graphics().poly([0, -8, 6.4, 6, 0, 3.2, -6.4, 6]).fill({ color: 0xdfe8ff, alpha: 0.4 });
    hull.stroke({ width: 1, color: 0xdfe8ff, alpha: 0.9 });
    this.container = new Container({ children: [hull], visible: false });
  }

  /** Steps of the flight that the ghost repeats; undefined if there is none. */
  get steps(): number | undefined {
    return this.#flight?.steps;
  }

  /** Call it once a frame. @param alpha position of the picture between the last two steps, 0 to 1 */
  update(sim: BlackHoleGame, alpha: number, isShown: boolean): void {
    this.#watch(sim);
    const { container } = this;
    const isFlying = sim.rules.phase === 'flying' && !sim.isReplay && !sim.isDemo && !sim.autopilot;
    container.visible = isShown && isFlying && this.#flight !== undefined;
    if (container.visible) placeOnPath(this.#flight as BestFlight, sim.rules.record.steps - 2 + alpha, container);
  }

  /** Takes the flight that has just reached the goal. @returns how it compares with the best before it, if there was one */
  finish(sim: BlackHoleGame): Comparison | undefined {
    this.#watch(sim);
    const path = sim.rules.record.path();
    if (path === undefined || !this.#isRanked) return undefined;
    const { steps } = sim.rules.record;
    const before = this.#flight;
    this.#flights.offer({ layout: this.#key(sim), steps, path });
    this.#holes = undefined;
    return before && { steps: before.steps - steps };
  }

  /** A game that went back in time or was a replay sets no best flight, as it sets no high score. */
  #watch(sim: BlackHoleGame): void {
    const { tick } = sim.world;
    if (sim !== this.#sim) {
      this.#sim = sim;
      this.#isRanked = true;
    } else if (tick < this.#tick) this.#isRanked = false;
    if (sim.isReplay) this.#isRanked = false;
    this.#tick = tick;
    const { holes } = sim.scene;
    const { fuel } = sim.rules.options;
    if (holes === this.#holes && fuel === this.#hasFuel) return;
    this.#holes = holes;
    this.#hasFuel = fuel;
    this.#flight = this.#flights.find(this.#key(sim));
  }

  #key({ scene, rules }: BlackHoleGame): string {
    return layoutKey(scene.holes, scene.isSteep, rules.options.fuel);
  }
}

/** Puts the ghost where the flight was a number of steps after its start, and turns it along its path. */
function placeOnPath({ path }: BestFlight, steps: number, container: Container): void {
  const last = path.length / 2 - 1;
  const time = Math.max(0, Math.min(last, steps / SAMPLE_STEPS));
  const from = Math.min(Math.max(0, last - 1), Math.floor(time));
  const share = time - from;
  const before = 2 * Math.max(0, from - 1);
  const [a, b] = [2 * from, 2 * Math.min(last, from + 1)];
  const after = 2 * Math.min(last, from + 2);
  const x = between(path[before], path[a], path[b], path[after], share);
  const y = between(path[before + 1], path[a + 1], path[b + 1], path[after + 1], share);
  container.position.set(PATH_UNIT * x, -PATH_UNIT * y);
  const [dx, dy] = [path[b] - path[a], path[b + 1] - path[a + 1]];
  if (dx !== 0 || dy !== 0) container.rotation = Math.atan2(dx, dy);
}

/** Catmull and Rom (1974): a smooth curve through four positions, from the second (`t` = 0) to the third (`t` = 1). */
function between(a: number, b: number, c: number, d: number, t: number): number {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}
