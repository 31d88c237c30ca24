import { bodies, type PhysicsWorld } from '@principia/physics';

/** Ids of the bodies of a source: a list that stays, or a function that is asked at each picture, such as one that returns a query. */
export type BodyChoice = ArrayLike<number> | (() => ArrayLike<number>);

/** The bodies of a world that are in a list, in ascending order. Makes garbage only when they have changed. */
export class ChosenBodies {
  readonly #world: PhysicsWorld;
  readonly #wanted: () => ArrayLike<number>;
  /** Of a list that stays, the generations that its bodies had: another that takes the id of one is not in it. */
  readonly #generations: readonly number[] | undefined;
  /** What was wanted last. */
  #last: readonly number[] = [];
  #membership = Number.NaN;
  #restored = Number.NaN;
  #ids = new Uint32Array(0);
  /** Number of the ids. */
  count = 0;
  /** Grows when the ids change. */
  version = 0;

  /** @throws Error when an id of a list is none */
  constructor(world: PhysicsWorld, choice: BodyChoice) {
    this.#world = world;
    if (typeof choice === 'function') {
      this.#wanted = choice;
      return;
    }
    const list = Array.from(choice);
    const wrong = list.findIndex((id) => !(Number.isInteger(id) && id > 0 && id < world.rows));
    if (wrong >= 0) {
      const range = `from 1 to ${world.rows - 1}`;
      throw new Error(`worldSource: bodies[${wrong}] must be an entity id ${range}, got ${list[wrong]}`);
    }
    const { generations } = world.internal;
    this.#generations = list.map((id) => generations[id]);
    this.#wanted = () => list;
  }

  get ids(): Uint32Array {
    return this.#ids;
  }

  /** Brings ids, count and version up to date. */
  refresh(): this {
    const wanted = this.#wanted();
    const { membership, restored } = this.#world.versions;
    if (membership === this.#membership && restored === this.#restored && isSame(wanted, this.#last)) return this;
    this.#membership = membership;
    this.#restored = restored;
    this.#last = Array.from(wanted);
    const { generations } = this.#world.internal;
    const kept = this.#generations;
    const chosen = new Set(kept === undefined ? this.#last : this.#last.filter((id, i) => generations[id] === kept[i]));
    const { ids, count } = bodies(this.#world);
    this.#ids = ids.slice(0, count).filter((id) => chosen.has(id));
    this.count = this.#ids.length;
    this.version++;
    return this;
  }
}

function isSame(a: ArrayLike<number>, b: readonly number[]): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < b.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
