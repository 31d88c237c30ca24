/** The sound of impacts: a ball whose velocity jumped has met something, and the jump says how hard. */
import type { BouncingBalls } from '@principia/scenes';
import type { Synth } from '@principia/shell';

/** With more balls than this, single impacts cannot be told apart. */
const MAX_BALLS = 3000;
/** Change of velocity that is heard at all, and at full loudness, m/s. */
const [FAINTEST, LOUDEST] = [0.9, 9];
/** Sounds started in one frame at most: those of the hardest impacts. */
const PER_FRAME = 3;
/** Frequency of a ball of 10 cm, Hz; smaller balls sound higher. */
const PITCH = 420;

export class Impacts {
  readonly #sim: BouncingBalls;
  readonly #synth: Synth;
  /** Velocities at the last frame: x, y, z of each ball. */
  readonly #last: Float32Array;
  /** The hardest impacts of a frame: change of velocity and position along x. */
  readonly #hardest = new Float64Array(2 * PER_FRAME);
  #tick = -1;

  constructor(sim: BouncingBalls, synth: Synth) {
    this.#sim = sim;
    this.#synth = synth;
    this.#last = new Float32Array(3 * Math.min(MAX_BALLS, sim.balls.length));
  }

  /** Plays the impacts since the last frame. */
  update(): void {
    const { world, balls } = this.#sim;
    if (balls.length > MAX_BALLS || !this.#synth.isAudible) return;
    // A rewind or a pause is silent.
    const isNext = world.tick > this.#tick && world.tick <= this.#tick + 10;
    this.#tick = world.tick;
    this.#hardest.fill(0);
    this.#compare(isNext);
    if (isNext) this.#play();
  }

  #compare(isNext: boolean): void {
    const { world, balls } = this.#sim;
    const { Velocity, Position } = world.components;
    const last = this.#last;
    for (let i = 0; i < balls.length; i++) {
      const id = balls[i];
      const x = Velocity.x[id] - last[3 * i];
      const y = Velocity.y[id] - last[3 * i + 1];
      const z = Velocity.z[id] - last[3 * i + 2];
      const square = x * x + y * y + z * z;
      if (isNext && square > FAINTEST * FAINTEST) this.#note(Math.sqrt(square), Position.x[id]);
      last[3 * i] = Velocity.x[id];
      last[3 * i + 1] = Velocity.y[id];
      last[3 * i + 2] = Velocity.z[id];
    }
  }

  /** Keeps an impact in place of the weakest one. */
  #note(jump: number, x: number): void {
    const list = this.#hardest;
    let weakest = 0;
    for (let i = 2; i < list.length; i += 2) if (list[i] < list[weakest]) weakest = i;
    if (jump <= list[weakest]) return;
    list[weakest] = jump;
    list[weakest + 1] = x;
  }

  #play(): void {
    const { room, radius } = this.#sim;
    for (let i = 0; i < this.#hardest.length; i += 2) {
      const jump = this.#hardest[i];
      if (jump === 0) continue;
      const loudness = 0.35 * Math.min(1, jump / LOUDEST) ** 1.5;
      const pan = (2 * (this.#hardest[i + 1] - room.min.x)) / (room.max.x - room.min.x) - 1;
      const frequency = Math.min(2400, PITCH * (0.1 / radius) ** 0.7) * (1 + 0.03 * (jump % 3));
      this.#synth.tone({ frequency: 1.5 * frequency, to: frequency, loudness, seconds: 0.12, pan: 0.8 * pan });
    }
  }
}
