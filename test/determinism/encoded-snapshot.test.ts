/** A world that takes the encoded snapshot of another goes on as that does, to the bit: every scene, every feature. */
import {
  attractors,
  box,
  constantTorque,
  createEmitter,
  createJoint,
  createPhysicsWorld,
  decodeSnapshot,
  defineComponent,
  despawn,
  encodeSnapshot,
  keepState,
  type PhysicsWorld,
  polygon,
  quadraticDrag,
  realField,
  resource,
  restore,
  revolute,
  rigidBodies,
  semiImplicitEuler,
  snapshot,
  spawn,
  stateHash,
  step,
  uniformGravity,
} from '@principia/physics';
import { SCENES, type Scene, type SceneRun } from '@principia/scenes';
import { describe, expect, it } from 'vitest';

function advance({ world, dt, advance: move }: SceneRun, steps: number): string {
  for (let i = 0; i < steps; i++) {
    if (move === undefined) step(world, dt);
    else move(world);
  }
  return stateHash(world);
}

describe.each(SCENES.map((scene) => [scene.name, scene] as const))('scene %s', (_, scene: Scene) => {
  const { min, initial } = scene.parameters.count;
  const count = Math.max(min, Math.min(60, initial));

  it.each([
    ['f32', 0],
    ['f64', 3],
  ] as const)('goes on in another world in %s, which ran for %i steps before', (precision, before) => {
    const run = scene.create({ count, precision });
    advance(run, 40);
    const bytes = encodeSnapshot(snapshot(run.world));
    const other = scene.create({ count, precision });
    advance(other, before);
    restore(other.world, decodeSnapshot(other.world, bytes));
    expect(stateHash(other.world)).toBe(stateHash(run.world));
    expect(advance(other, 40)).toBe(advance(run, 40));
    expect(other.world.tick).toBe(run.world.tick);
  });
});

const DT = 1 / 60;
const Health = defineComponent({ fields: { value: realField('') } });

class Game {
  score = 0;
  best = -0;
  limit = Number.POSITIVE_INFINITY;
  readonly names = ['a'];
  readonly seen = new Set([1]);
  readonly lives = new Map([['a', { left: 3 }]]);
  readonly samples = new Float64Array(3);
}

/** A world with a game beside it; the level is the part that changes as it is played. */
function makeGame(options: { readonly capacity?: number } = {}) {
  const world = createPhysicsWorld({
    preset: rigidBodies,
    capacity: options.capacity ?? 200,
    components: [Health],
    forces: [uniformGravity(), quadraticDrag()],
  });
  const game = new Game();
  keepState(world, game);
  const emitter = createEmitter(world, { capacity: 30, rate: 60, lifetime: 0.4, mass: 0.01, speed: 2 });
  return { world, game, emitter };
}

function play({ world, game }: ReturnType<typeof makeGame>): number[] {
  spawn(world, { position: { y: -1 }, collider: { shape: box(20, 1) } });
  const triangle = polygon([
    { x: 0, y: 0 },
    { x: 0.6, y: 0 },
    { x: 0, y: 0.5 },
  ]);
  const ids = [0, 1, 2, 3].map((i) =>
    spawn(world, { position: { x: i, y: 1 + i }, collider: { shape: triangle, density: 1 } }),
  );
  despawn(world, ids[1]);
  const later = spawn(world, { position: { x: 1.2, y: 3 }, collider: { radius: 0.3, density: 1 }, quadraticDrag: 0.1 });
  createJoint(world, revolute({ a: ids[2], b: ids[3], anchor: { x: 2.5, y: 3.5 } }));
  for (let i = 0; i < 50; i++) step(world, DT);
  Object.assign(game, { score: Number.NaN, best: 7 });
  game.names.push('b');
  game.seen.add(9);
  game.lives.set('b', { left: 1 });
  game.samples[1] = -0;
  return [...ids, later];
}

describe('a game', () => {
  it('is loaded by a program that built nothing but its empty world', () => {
    const saved = makeGame();
    play(saved);
    const bytes = encodeSnapshot(snapshot(saved.world));
    const loaded = makeGame();
    restore(loaded.world, decodeSnapshot(loaded.world, bytes));
    expect(loaded.game).toEqual(saved.game);
    expect(Object.is(loaded.game.samples[1], -0)).toBe(true);
    for (let i = 0; i < 100; i++) {
      step(saved.world, DT);
      step(loaded.world, DT);
    }
    expect(stateHash(loaded.world)).toBe(stateHash(saved.world));
    // Bodies that come later get the same ids, and the shapes of the level can be used.
    const next = [saved, loaded].map(({ world }) =>
      spawn(world, { position: {}, collider: { shape: box(1, 2), density: 1 } }),
    );
    expect(next[1]).toBe(next[0]);
  });

  it('is written as it was when the snapshot was taken, whatever its world has been given since', () => {
    const saved = makeGame();
    play(saved);
    const [taken, hash] = [snapshot(saved.world), stateHash(saved.world)];
    const { world } = saved;
    const emit = [...world.phases.emit];
    step(world, DT);
    world.forces.pop();
    world.integrator = semiImplicitEuler;
    world.phases.emit.length = 0;
    world.phases.input.push(() => {});
    keepState(world, { later: 1 });
    const bytes = encodeSnapshot(taken);
    const loaded = makeGame();
    restore(loaded.world, decodeSnapshot(loaded.world, bytes));
    expect(stateHash(loaded.world)).toBe(hash);
    restore(world, taken);
    expect(world.phases.emit).toEqual(emit);
    for (let i = 0; i < 50; i++) for (const each of [world, loaded.world]) step(each, DT);
    expect(stateHash(loaded.world)).toBe(stateHash(world));
  });

  it('is loaded over another level, and leaves nothing of it', () => {
    const saved = makeGame();
    const bytes = encodeSnapshot(snapshot(saved.world));
    const played = makeGame();
    play(played);
    restore(played.world, decodeSnapshot(played.world, bytes));
    expect(played.game).toEqual(saved.game);
    play(saved);
    play(played);
    expect(stateHash(played.world)).toBe(stateHash(saved.world));
  });

  it('is encoded again to the same bytes', () => {
    const saved = makeGame();
    play(saved);
    const bytes = encodeSnapshot(snapshot(saved.world));
    const loaded = makeGame();
    const decoded = decodeSnapshot(loaded.world, bytes);
    expect(encodeSnapshot(decoded).length).toBe(bytes.length);
    restore(loaded.world, decoded);
    restore(loaded.world, decoded);
    expect(stateHash(loaded.world)).toBe(stateHash(saved.world));
  });
});

describe('81 what is no snapshot of such a world is refused, and the world stays as it is', () => {
  const saved = makeGame();
  play(saved);
  const bytes = encodeSnapshot(snapshot(saved.world));

  const refuse = (world: PhysicsWorld, given: unknown, message: RegExp) => {
    const before = stateHash(world);
    expect(() => decodeSnapshot(world, given as Uint8Array)).toThrow(message);
    expect(stateHash(world)).toBe(before);
  };

  it('other bytes', () => {
    const { world } = makeGame();
    for (const given of [undefined, 'PRIN', [1, 2], new Uint8Array(0), new Uint8Array(100), new Uint32Array(9)]) {
      refuse(world, given, /E_TYPE.*not an encoded snapshot/);
    }
    for (const at of [0, 9, 13, 40, bytes.length >> 1, bytes.length - 9]) {
      const changed = bytes.slice();
      changed[at] ^= 16;
      refuse(world, changed, /E_TYPE.*not an encoded snapshot/);
    }
    refuse(world, bytes.subarray(0, bytes.length - 1), /bytes were lost or changed/);
  });

  it('bytes of a world that was made otherwise', () => {
    refuse(makeGame({ capacity: 300 }).world, bytes, /differs in capacity: 200 saved, 300 here/);
    const other = makeGame();
    other.world.forces.push(constantTorque({ z: 1 }));
    refuse(other.world, bytes, /differs in forces/);
    refuse(createPhysicsWorld({ capacity: 200, precision: 'f32' }), bytes, /differs in precision/);
    refuse(createPhysicsWorld({ capacity: 200, seed: 2 }), bytes, /differs in seed: 1 saved, 2 here/);
  });

  it('a world without what the saved one had beside it', () => {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      capacity: 200,
      components: [Health],
      forces: [uniformGravity(), quadraticDrag()],
    });
    createEmitter(world, { capacity: 30, rate: 60, lifetime: 0.4, mass: 0.01, speed: 2 });
    refuse(
      world,
      bytes,
      /E_TYPE.*differs in the number of objects passed to keepState: 1 saved, 0 here. Pass keepState as many/,
    );
  });

  it('a world that keeps other objects', () => {
    const keeping = (...objects: object[]) => {
      const world = createPhysicsWorld({ capacity: 5 });
      keepState(world, ...objects);
      return world;
    };
    const points = { points: 7 };
    const table = new Float64Array(3);
    const taken = encodeSnapshot(snapshot(keeping(points, { lives: 3 }, table)));
    const number = /E_TYPE.*differs in the number of objects passed to keepState: 3 saved/;
    refuse(keeping({ points: 0 }), taken, number);
    refuse(keeping({ points: 0 }, { lives: 0 }, new Float64Array(3), { coins: 5 }), taken, number);
    const kind = (i: number) => new RegExp(`E_TYPE.*differs in object\\[${i}\\] of those passed to keepState`);
    refuse(keeping({ lives: 0 }, { points: 0 }, new Float64Array(3)), taken, kind(0));
    refuse(keeping({ points: 0 }, new Map(), new Float64Array(3)), taken, kind(1));
    refuse(keeping({ points: 0 }, { lives: 0 }, new Float64Array(4)), taken, kind(2));
    refuse(keeping({ points: 0 }, { lives: 0 }, new Float32Array(3)), taken, kind(2));
    // What comes and goes later does not count, and an object that is passed twice is one.
    const state: Record<string, number> = { points: 0 };
    const world = keeping(state, state, { lives: 0 }, new Float64Array(3));
    state.bonus = 1;
    restore(world, decodeSnapshot(world, taken));
    expect(state).toEqual(points);
  });

  it('state of one’s own without a name', () => {
    const { world } = makeGame();
    resource(() => ({ points: 0 }))(world);
    expect(() => encodeSnapshot(snapshot(world))).toThrow(/E_UNKNOWN.*resource\(create, \{ name/);
    expect(() => encodeSnapshot({ time: 0, tick: 0, bytes: 0 })).toThrow(/E_TYPE/);
  });
});

it('state of one’s own with a name is found by it', () => {
  const score = resource(() => ({ points: 0 }), { name: 'score of the test' });
  const [a, b] = [createPhysicsWorld({ forces: [attractors()] }), createPhysicsWorld({ forces: [attractors()] })];
  score(a).points = 5;
  restore(b, decodeSnapshot(b, encodeSnapshot(snapshot(a))));
  expect(score(b).points).toBe(5);
});

it('reads bytes wherever they begin in the memory of a message, also as a Buffer of Node', () => {
  const make = () => createPhysicsWorld({ preset: rigidBodies, capacity: 10 });
  const world = make();
  spawn(world, { position: { y: 1 }, collider: { radius: 1, density: 1 } });
  const bytes = encodeSnapshot(snapshot(world));
  for (const header of [0, 1, 4, 8, 13]) {
    const message = Buffer.alloc(header + bytes.length + 5);
    message.set(bytes, header);
    const other = make();
    restore(other, decodeSnapshot(other, message.subarray(header, header + bytes.length)));
    expect(stateHash(other)).toBe(stateHash(world));
  }
});
