/** A player that looks ahead: tries courses on a copy of the ship and flies the best one it knows. */
import { createRandom, keepState, markImmutable, type Random } from '@principia/physics';
import { BLACK_HOLE, type BlackHole, isClear } from '@principia/scenes';
import { type Craft, Flight } from './flight.ts';
import { type Heading, thrustOf } from './heading.ts';

/** A course: headings, and when each ends, s from the course's begin. */
interface Course {
  readonly headings: (Heading | undefined)[];
  readonly ends: number[];
  value: number;
}

const HEADINGS: readonly (Heading | undefined)[] = ['up', 'up', 'left', 'right', 'down', undefined];
const NONE: Course = markImmutable({ headings: [], ends: [], value: Number.NEGATIVE_INFINITY });
const HORIZON = 9;
const LOOK_DT = 1 / 40;
/** Seconds between two searches, and courses tried in each. */
const PATIENCE = 0.25;
const TRIES = 24;
/** Where the times of a plan are. */
const [BEGIN, SEARCH] = [0, 1];

export class Autopilot {
  readonly #scene: BlackHole;
  readonly #random: Random;
  readonly #flight: Flight;
  readonly #craft: Craft = { x: 0, y: 0, vx: 0, vy: 0 };
  /** The course, and past which holes. */
  readonly #plan = { course: NONE, holes: undefined as unknown };
  /** Since when it is flown, and was searched for, s: in cells, which snapshots copy without garbage. */
  readonly #since = new Float64Array([0, PATIENCE]);

  constructor(scene: BlackHole, seed: number) {
    this.#scene = scene;
    this.#flight = new Flight(scene.isSteep);
    this.#random = createRandom(seed, 2);
    keepState(scene.world, this.#plan, this.#since, this.#random.state);
  }

  /** Forgets its plans. */
  begin(seed: number): void {
    Object.assign(this.#plan, { course: NONE, holes: undefined });
    this.#since.set([0, PATIENCE]);
    this.#random.state.set(createRandom(seed, 2).state);
  }

  /** The heading for the step to come. */
  steer(dt: number): Heading | undefined {
    const plan = this.#plan;
    const since = this.#since;
    if (plan.holes !== this.#scene.holes) {
      plan.holes = this.#scene.holes;
      plan.course = NONE;
      since[SEARCH] = PATIENCE;
    }
    if (since[SEARCH] >= PATIENCE) this.#search();
    since[SEARCH] += dt;
    since[BEGIN] += dt;
    return headingAt(plan.course, since[BEGIN] - dt);
  }

  /** Tries the rest of the present course, and others. */
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
    let best = rest(this.#plan.course, this.#since[BEGIN]);
    best.value = this.#judge(best);
    for (let i = 0; i < TRIES; i++) {
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

  /** The same course with one piece changed. */
  #vary({ headings, ends }: Course): Course {
    const course = { headings: [...headings], ends: [...ends], value: 0 };
    const at = this.#random.integer(0, ends.length - 1);
    course.headings[at] = HEADINGS[this.#random.integer(0, HEADINGS.length - 1)];
    course.ends[at] += this.#random.uniform(-0.4, 0.4);
    return course;
  }

  /** How good a course is: the goal, the sooner the better; else height, if it does not end in a fall. */
  #judge(course: Course): number {
    const flight = this.#flight;
    flight.begin(this.#craft, this.#scene.holes, this.#scene.holeTime);
    let top = 0;
    let clear = 0;
    let time = 0;
    for (; time < HORIZON && flight.fate === 'flying'; time += LOOK_DT) {
      flight.step(LOOK_DT, thrustOf(headingAt(course, time)));
      top = Math.max(top, flight.y);
      // Whatever comes close is chaos: small errors of the copy grow there.
      if (!isClear(this.#scene.holes, flight.x, flight.y)) clear++;
    }
    const risk = 4 * clear * LOOK_DT;
    if (flight.fate === 'goal') return 1000 - 10 * time - 30 * risk;
    if (flight.fate === 'fallen') return -1000 + 10 * time;
    if (flight.fate === 'gone') return -300 + 10 * time;
    return (100 * top) / BLACK_HOLE.goal - risk;
  }
}

function headingAt({ headings, ends }: Course, time: number): Heading | undefined {
  for (let i = 0; i < ends.length; i++) if (time < ends[i]) return headings[i];
  return undefined;
}

/** What is left of a course after `age` seconds. */
function rest({ headings, ends }: Course, age: number): Course {
  const from = ends.findIndex((end) => end > age);
  if (from < 0) return { headings: [], ends: [], value: 0 };
  return { headings: headings.slice(from), ends: ends.slice(from).map((end) => end - age), value: 0 };
}
