// Tests that structure and layout determine when code is compiled, and values do not.
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { forcesNow, lawOf } from '../../../../test/support/law-lab.ts';
import { steps, worldState } from '../../../../test/support/worlds.ts';
import {
  COMPONENTS,
  columnsOf,
  createPhysicsWorld,
  defineComponent,
  defineForce,
  defineLaw,
  type Force,
  linearDrag,
  PhysicsError,
  type PhysicsWorldOptions,
  quadraticDrag,
  realField,
  replaceForce,
  scalar,
  semiImplicitEuler,
  spawn,
  step,
  uniformGravity,
  vec3,
  vectorOverTime,
} from '../index.ts';

let compilations = 0;
const Module = WebAssembly.Module;

beforeEach(() => {
  compilations = 0;
  vi.spyOn(WebAssembly, 'Module').mockImplementation(function (this: unknown, bytes: BufferSource) {
    compilations++;
    return new Module(bytes);
  } as never);
});
afterEach(() => void vi.restoreAllMocks());

/** Counts the modules that a call compiles. */
function countOf(act: () => void): number {
  const before = compilations;
  act();
  return compilations - before;
}

/** Makes structures unique, because the process caches them. */
let unlike = 0;
function pushLaw() {
  const odd = 1000 + unlike++;
  return defineLaw({ name: 'push', parameters: { k: scalar('N') }, force: (_body, { k }) => vec3(k.mul(odd), k) });
}

function worldWith(forces: readonly Force[], options: PhysicsWorldOptions = {}) {
  const world = createPhysicsWorld({ capacity: 10, forces, ...options });
  const eid = spawn(world, { position: {}, velocity: { x: 1, y: 2 }, mass: 1, quadraticDrag: 0.3 });
  return { world, eid };
}

describe('compilation', () => {
  test('the first step compiles, the next ones do not', () => {
    const { world } = worldWith([pushLaw()({ k: 1 })]);
    expect(countOf(() => step(world, 0.1))).toBeGreaterThan(0);
    expect(countOf(() => steps(world, 3))).toBe(0);
  });

  test('another value of a parameter takes effect without compilation', () => {
    const push = pushLaw();
    const { world, eid } = worldWith([push({ k: 1 })]);
    step(world, 0.1);
    const before = world.components.Velocity.y[eid];
    expect(
      countOf(() => {
        replaceForce(world, push({ k: 7 }));
        step(world, 0.1);
      }),
    ).toBe(0);
    expect(world.components.Velocity.y[eid] - before).toBeCloseTo(0.7, 12);
  });

  test('a world with the same laws and layout does not compile', () => {
    const push = pushLaw();
    const first = worldWith([push({ k: 1 }), linearDrag()]);
    step(first.world, 0.1);
    const second = worldWith([push({ k: 2 }), linearDrag()]);
    expect(countOf(() => step(second.world, 0.1))).toBe(0);
    expect(second.world.components.Velocity.y[second.eid]).toBeCloseTo(2.2, 12);
  });

  test.each([
    ['precision', { precision: 'f32' }],
    ['number of dimensions', { dimensions: 3 }],
    ['integrator', { integrator: semiImplicitEuler }],
    ['capacity', { capacity: 5000 }],
  ] as const)('another %s needs another loop', (_, options) => {
    const push = pushLaw();
    const first = worldWith([push({ k: 1 })]);
    step(first.world, 0.1);
    const second = worldWith([push({ k: 1 })], options);
    expect(countOf(() => step(second.world, 0.1))).toBeGreaterThan(0);
  });

  test('an additional force needs another loop, and its removal does not', () => {
    const push = pushLaw();
    const { world } = worldWith([push({ k: 1 })]);
    step(world, 0.1);
    world.forces.push(uniformGravity());
    expect(countOf(() => step(world, 0.1))).toBeGreaterThan(0);
    world.forces.pop();
    expect(countOf(() => step(world, 0.1))).toBe(0);
  });

  test('constant vectors, zero axes and functions of time have separate code and correct results', () => {
    const odd = 1000 + unlike++;
    const wind = defineLaw({
      name: 'wind',
      parameters: { w: vectorOverTime('m/s') },
      force: (_body, { w }) => w.mul(odd),
    });
    const pushOf = (given: Parameters<typeof wind>[0]) => {
      const { world, eid } = worldWith([wind(given)]);
      const { x, y } = forcesNow(world, 2);
      return [x[eid] / odd, y[eid] / odd];
    };
    expect(pushOf({ w: { x: 1, y: 2 } })).toEqual([1, 2]);
    expect(pushOf({ w: { x: 3 } })).toEqual([3, 0]);
    expect(pushOf({ w: (t) => ({ x: t, y: -t }) })).toEqual([2, -2]);
    expect(pushOf({ w: { y: 5 } })).toEqual([0, 5]);
    expect(pushOf({ w: { x: 4, y: 5 } })).toEqual([4, 5]);
  });

  test('custom columns at other addresses are read correctly', () => {
    const [Heat, Glow] = [0, 1].map(() => defineComponent({ fields: { value: realField('') } }));
    const law = lawOf({
      reads: { heat: Heat, glow: Glow },
      force: (body: Record<string, never>) => vec3(body.heat, body.glow),
    });
    for (const components of [
      [Heat, Glow],
      [Glow, Heat],
    ]) {
      const { world, eid } = worldWith([law], { components });
      columnsOf(world, Heat).value[eid] = 3;
      columnsOf(world, Glow).value[eid] = 4;
      const { x, y } = forcesNow(world);
      expect([x[eid], y[eid]]).toEqual([3, 4]);
    }
  });
});

describe('a user law', () => {
  const own = defineLaw({
    name: 'my own drag',
    reads: { k: COMPONENTS.QuadraticDrag },
    parameters: { w: vectorOverTime('m/s', { default: {} }) },
    force: ({ velocity, k }, { w }) => {
      const u = velocity.sub(w);
      return u.mul(k.mul(u.length())).negate();
    },
  });

  test.each(['f32', 'f64'] as const)(
    'with the formula of quadraticDrag gives the same bits, %s, and shares its code',
    (precision) => {
      const [given, mine] = [quadraticDrag({ x: 0.3 }), own({ w: { x: 0.3 } })].map((force) =>
        worldWith([force], { precision }),
      );
      step(given.world, 0.1);
      expect(countOf(() => step(mine.world, 0.1))).toBe(0);
      for (let i = 0; i < 100; i++) for (const { world } of [given, mine]) step(world, 0.1);
      expect(worldState(mine.world)).toEqual(worldState(given.world));
      expect(mine.world.components.Velocity.x[mine.eid]).not.toBe(1);
    },
  );
});

describe('a page that forbids WebAssembly compilation', () => {
  /** This mimics Chromium. */
  class Forbidden {
    constructor() {
      const policy = 'violates the following Content Security policy directive';
      throw new WebAssembly.CompileError(
        `WebAssembly.Module(): Compiling or instantiating WebAssembly module ${policy}`,
      );
    }
  }

  test.each([
    ['one loop', []],
    ['segments', [defineForce({ name: 'nothing', accumulate() {} })]],
  ])('gets an error that says what to add, and nothing moved: %s', (_, others) => {
    const { world, eid } = worldWith([pushLaw()({ k: 1 }), ...others]);
    const before = worldState(world);
    vi.spyOn(WebAssembly, 'Module').mockImplementation(Forbidden as never);
    let thrown: unknown;
    try {
      step(world, 0.1);
    } catch (error) {
      thrown = error;
    }
    expect(thrown).toBeInstanceOf(PhysicsError);
    const { message, cause, field } = thrown as PhysicsError;
    expect(message).toMatch(/this page forbids compiling WebAssembly/);
    expect(message).toMatch(/Add 'wasm-unsafe-eval' to script-src of its Content-Security-Policy\.$/);
    expect(field).toBe('WebAssembly');
    expect(cause).toBeInstanceOf(WebAssembly.CompileError);
    expect(worldState(world)).toEqual(before);
    vi.restoreAllMocks();
    step(world, 0.1);
    expect(world.components.Velocity.y[eid]).toBeCloseTo(2.1, 12);
  });
});
