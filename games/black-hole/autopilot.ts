/** An autopilot that plans ahead: it simulates random courses on a copy of the ship and flies the best one found. */
import { createRandom, keepState, markImmutable, type Random } from '@principia/physics';
import { BLACK_HOLE, type BlackHole, isClear } from '@principia/scenes';
import { Flight, type ShipState } from './flight.ts';
import { DIRECTIONS, type Heading, thrustOf } from './heading.ts';

/** A course: headings, and the end time of each in s since the start of the course. */
interface Course {
  readonly headings: (Heading | undefined)[];
  readonly ends: number[];
  value: number;
}

const HEADINGS: readonly (Heading | undefined)[] = ['up', 'up', 'left', 'right', 'down', undefined];
const NONE: Course = markImmutable({ headings: [], ends: [], value: Number.NEGATIVE_INFINITY });
const HORIZON = 9;
const SEARCH_DT = 1 / 40;
/** Seconds between two searches, and courses tried in each. */
const SEARCH_INTERVAL = 0.25;
const CANDIDATES = 24;
/** Indices of the times of a plan. */
const [BEGIN, SEARCH] = [0, 1];

export class Autopilot {
  readonly #scene: BlackHole;
  readonly #random: Random;
  readonly #flight: Flight;
  readonly #craft: ShipState = { x: 0, y: 0, vx: 0, vy: 0 };
  /** The course, and the layout of holes for which it was planned. */
  readonly #plan = { course: NONE, holes: undefined as unknown };
  /**
   * Seconds since the course began and since the last search. A typed array, because snapshots copy it without garbage.
   */
  readonly #since = new Float64Array([0, SEARCH_INTERVAL]);

  constructor(scene: BlackHole, seed: number) {
    this.#scene = scene;
    this.#flight = new Flight(scene.isSteep);
    this.#random = createRandom(seed, 2);
    keepState(scene.world, this.#plan, this.#since, this.#random.state);
  }

  /** Discards the plan and reseeds the generator. */
  begin(seed: number): void {
    Object.assign(this.#plan, { course: NONE, holes: undefined });
    this.#since.set([0, SEARCH_INTERVAL]);
    this.#random.state.set(createRandom(seed, 2).state);
  }

  /** Returns the heading for the next step. */
  steer(dt: number): Heading | undefined {
    const plan = this.#plan;
    const since = this.#since;
    if (plan.holes !== this.#scene.holes) {
      plan.holes = this.#scene.holes;
      plan.course = NONE;
      since[SEARCH] = SEARCH_INTERVAL;
    }
    if (since[SEARCH] >= SEARCH_INTERVAL) this.#search();
    since[SEARCH] += dt;
    since[BEGIN] += dt;
    return headingAt(plan.course, since[BEGIN] - dt);
  }

  /** Compares the rest of the present course with random variations and new courses. */
  #search(): void {
    this.#since[SEARCH] = 0;
    const { world, ship } = this.#scene;
    const { Position, Velocity } = world.components;
    Object.assign(this.#craft, {
      x: Position.x[ship],
      y: Position.y[ship],
      vx: Velocity.x[ship],
      vy: Velocity.y[ship],
    });
    let best = remainder(this.#plan.course, this.#since[BEGIN]);
    best.value = this.#judge(best);
    for (let i = 0; i < CANDIDATES; i++) {
      const course = i % 3 === 0 && best.ends.length > 0 ? this.#vary(best) : this.#draw();
      course.value = this.#judge(course);
      if (course.value > best.value) best = course;
    }
    this.#plan.course = markImmutable(best);
    this.#since[BEGIN] = 0;
  }

  #draw(): Course {
    const course: Course = { headings: [], ends: [], value: 0 };
    for (let end = 0; end < HORIZON; ) {
      end += this.#random.uniform(0.15, 2.5);
      course.headings.push(HEADINGS[this.#random.integer(0, HEADINGS.length - 1)]);
      course.ends.push(end);
    }
    return course;
  }

  /** Returns the same course with one segment changed. */
  #vary({ headings, ends }: Course): Course {
    const course = { headings: [...headings], ends: [...ends], value: 0 };
    const at = this.#random.integer(0, ends.length - 1);
    course.headings[at] = HEADINGS[this.#random.integer(0, HEADINGS.length - 1)];
    course.ends[at] += this.#random.uniform(-0.4, 0.4);
    return course;
  }

  /**
   * Rates a course: an early arrival at the goal is best; otherwise height counts, unless the course ends in a fall.
   */
  #judge(course: Course): number {
    const flight = this.#flight;
    flight.begin(this.#craft, this.#scene.holes, this.#scene.holeTime);
    const thrust = { x: 0, y: 0 };
    let maxHeight = 0;
    let nearSteps = 0;
    let time = 0;
    for (; time < HORIZON && flight.status === 'flying'; time += SEARCH_DT) {
      const heading = headingAt(course, time);
      flight.step(SEARCH_DT, thrustOf(heading && DIRECTIONS[heading], thrust));
      maxHeight = Math.max(maxHeight, flight.y);
      // Close to a hole the motion is chaotic, and small errors of the copy grow.
      if (!isClear(this.#scene.holes, flight.x, flight.y)) nearSteps++;
    }
    const risk = 4 * nearSteps * SEARCH_DT;
    if (flight.status === 'goal') return 1000 - 10 * time - 30 * risk;
    if (flight.status === 'fallen') return -1000 + 10 * time;
    if (flight.status === 'gone') return -300 + 10 * time;
    return (100 * maxHeight) / BLACK_HOLE.goal - risk;
  }
}

function headingAt({ headings, ends }: Course, time: number): Heading | undefined {
  for (let i = 0; i < ends.length; i++) if (time < ends[i]) return headings[i];
  return undefined;
}

/** The remainder of a course after `age` seconds. */
function remainder({ headings, ends }: Course, age: number): Course {
  const from = ends.findIndex((end) => end > age);
  if (from < 0) return { headings: [], ends: [], value: 0 };
  return { headings: headings.slice(from), ends: ends.slice(from).map((end) => end - age), value: 0 };
}
