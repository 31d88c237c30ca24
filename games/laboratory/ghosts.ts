/** Runs of the same example beside the one on display: with other integrators, or with slightly other values. */
import { bodies, destroyWorld, restore, type Snapshot, snapshot, step } from '@principia/physics';
import type { ExampleRun, Point } from '@principia/scenes/examples';

/** Steps between two snapshots, which rewinding needs. */
const SNAPSHOT_STEPS = 30;
const MAX_SNAPSHOTS = 60;
/** Milliseconds that ghosts may take to catch up in a frame. */
const BUDGET = 12;
/** Points of a drawn path. */
const MAX_PATH = 600;
/** Bodies of a ghost that are drawn. */
const MAX_BODIES = 40;

/** A run beside the one on display. */
export class Ghost {
  readonly label: string;
  readonly color: number;
  readonly run: ExampleRun;
  /** Ids of the bodies that move. */
  readonly bodies: readonly number[];
  /** Path of the first body with a trail. */
  readonly path: Point[] = [];
  readonly #snapshots: Snapshot[] = [];

  constructor(label: string, color: number, run: ExampleRun) {
    this.label = label;
    this.color = color;
    this.run = run;
    const { world } = run;
    const { ids, count } = bodies(world);
    const moving = Array.from(ids.subarray(0, count)).filter((id) => world.components.Mass.value[id] > 0);
    this.bodies = moving.slice(0, MAX_BODIES);
    this.#snapshots.push(snapshot(world));
  }

  /** Steps or rewinds to a step of the run on display. @param deadline milliseconds of `performance.now()` */
  follow(tick: number, deadline: number): void {
    const { world, dt } = this.run;
    if (world.tick > tick) this.#rewindTo(tick);
    while (world.tick < tick && performance.now() < deadline) {
      step(world, dt);
      this.#record();
    }
  }

  destroy(): void {
    destroyWorld(this.run.world);
  }

  #record(): void {
    const { world, picture } = this.run;
    const followed = picture.trails?.[0]?.body;
    if (followed !== undefined) {
      const { x, y, z } = world.components.Position;
      this.path.push({ x: x[followed], y: y[followed], z: z[followed] });
      if (this.path.length > MAX_PATH) this.path.shift();
    }
    if (world.tick % SNAPSHOT_STEPS !== 0) return;
    // The first snapshot stays: it is the beginning.
    const spare = this.#snapshots.length >= MAX_SNAPSHOTS ? this.#snapshots.splice(1, 1)[0] : undefined;
    this.#snapshots.push(snapshot(world, spare));
  }

  #rewindTo(tick: number): void {
    const list = this.#snapshots;
    while (list.length > 1 && (list.at(-1) as Snapshot).tick > tick) list.pop();
    restore(this.run.world, list.at(-1) as Snapshot);
    this.path.length = 0;
  }
}

/** All runs beside the one on display. */
export class Ghosts {
  readonly members: readonly Ghost[];

  constructor(members: readonly Ghost[]) {
    this.members = members;
  }

  /** Brings all to a step of the run on display; a slow machine lets them lag behind. */
  follow(tick: number): void {
    const deadline = performance.now() + BUDGET;
    for (const ghost of this.members) ghost.follow(tick, deadline);
  }

  destroy(): void {
    for (const ghost of this.members) ghost.destroy();
  }
}
