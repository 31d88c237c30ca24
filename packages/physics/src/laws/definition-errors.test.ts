// Tests that errors of a law are thrown at its definition, with its name and the location.
import { describe, expect, test } from 'vitest';
import { forcesNow } from '../../../../test/support/law-lab.ts';
import { worldState } from '../../../../test/support/worlds.ts';
import {
  type BodySymbols,
  COMPONENTS,
  createPhysicsWorld,
  defineLaw,
  PhysicsError,
  replaceForce,
  type ScalarSymbol,
  scalar,
  spawn,
  step,
  table,
  type VectorSymbol,
  vec3,
} from '../index.ts';

/** Returns the error of a definition that TypeScript would also reject. */
function errorOf(act: () => unknown): PhysicsError {
  try {
    act();
  } catch (error) {
    expect(error).toBeInstanceOf(PhysicsError);
    return error as PhysicsError;
  }
  throw new Error('This was taken.');
}

type Wrong = Readonly<Record<string, Omit<ScalarSymbol, 'shape'> & Omit<VectorSymbol, 'shape'>>>;
const define = (options: object) => defineLaw({ name: 'lift of a wing', ...options } as never);
const withForce = (force: (body: Wrong & BodySymbols, parameters: Wrong) => unknown) => () =>
  define({ reads: { k: COMPONENTS.LinearDrag }, parameters: { p: scalar('') }, force });

/** Leaks symbols from the functions that they belong to. */
const stolen: { row?: ScalarSymbol; parameter?: ScalarSymbol } = {};
const rows = table(['q'], () => ({ at: 0, count: 0 }));

const FORCES: Readonly<Record<string, readonly [act: () => unknown, sentence: RegExp]>> = {
  'returns nothing': [withForce(() => undefined), /must return a vector, got undefined/],
  'returns a number': [withForce(() => 3), /must return a vector, got 3/],
  'returns a scalar': [withForce(({ mass }) => mass), /must return a vector, got a scalar/],
  'returns a condition': [withForce(({ mass }) => mass.less(1)), /must return a vector, got a condition/],
  'returns a promise': [withForce(async ({ velocity }) => velocity), /must return a vector, got an object/],
  'reads an unknown symbol': [withForce((body) => body.speed), /no symbol "speed"\. Valid: .*velocity/],
  'reads an unknown parameter': [
    withForce(({ velocity }, { q }) => velocity.mul(q as never)),
    /no symbol "q"\. Valid: p\./,
  ],
  'multiplies vectors': [
    withForce(({ velocity }) => velocity.mul(velocity as never)),
    /mul takes a scalar or a number, got a vector/,
  ],
  'adds a vector to a scalar': [
    withForce(({ k, velocity }) => vec3(k.add(velocity as never) as never, 0)),
    /add takes a scalar or a number, got a vector/,
  ],
  'adds a scalar to a vector': [
    withForce(({ velocity, mass }) => velocity.add(mass as never)),
    /add takes a vector, got a scalar/,
  ],
  'misspells an axis': [
    withForce(({ velocity }) => velocity.mul((velocity as never as Wrong).w as never)),
    /mul takes a scalar or a number, got undefined/,
  ],
  'compares with >': [
    withForce(({ velocity }) => ((velocity.x as never) > 0 ? velocity : velocity)),
    /select\(condition, a, b\) in place of if/,
  ],
  'adds with +': [
    withForce(({ velocity }) => velocity.mul((velocity.x as never) + 1)),
    /select\(condition, a, b\) in place of if/,
  ],
  'is put into a text': [withForce(({ velocity }) => void `${velocity.x}`), /a symbol of a law is not a number/],
  'recurses infinitely': [
    withForce(function again(body, given): unknown {
      return again(body, given);
    }),
    /recurses infinitely/,
  ],
  throws: [
    withForce(() => {
      throw new Error('no wing');
    }),
    /it threw Error: no wing/,
  ],
  'has a method misspelt': [
    withForce(({ velocity }) => (velocity as never as { plus(): unknown }).plus()),
    /it threw TypeError: .*plus/,
  ],
  'asks for noise of a vector': [
    withForce(({ noise, velocity }) => vec3(noise(velocity as never, 0), 0)),
    /noise takes a scalar or a number, got a vector/,
  ],
  'asks for half a channel': [
    withForce(({ noise }) => vec3(noise(3, 0.5), 0)),
    /noise: channel must be a whole number, got 0.5/,
  ],
  'asks for noise with half a seed': [
    withForce(({ noise }) => vec3(noise(0.5, 0), 0)),
    /noise: seed must be a whole number, got 0.5/,
  ],
  'asks for noise with a seed below 0': [
    withForce(({ noise }) => vec3(noise(-1, 0), 0)),
    /noise: seed must be .*got -1/,
  ],
  'asks for noise with a seed that is none': [
    withForce(({ noise }) => vec3(noise(Number.NaN, 0), 0)),
    /noise: seed must be .*got NaN/,
  ],
  'asks whether the body has a number': [
    withForce(({ has }) => has(3 as never)),
    /has\(component\) must be a component, such as COMPONENTS\.QuadraticDrag or one made by defineComponent, got 3/,
  ],
  'follows one operation with too many': [
    withForce(({ velocity }) => Array.from({ length: 501 }).reduce((v: VectorSymbol) => v.add(velocity), velocity)),
    /nests \d+ operations; at most 500 .*Sum over many terms with a table/,
  ],
};

describe('a force that', () => {
  test.each(Object.keys(FORCES))('%s', (name) => {
    const [act, sentence] = FORCES[name];
    const { message } = errorOf(act);
    expect(message).toMatch(/law "lift of a wing", force/);
    expect(message).toMatch(sentence);
  });
});

const velocity = ({ velocity: v }: BodySymbols) => v;

const OPTIONS: Readonly<Record<string, readonly [act: () => unknown, sentence: RegExp]>> = {
  'no part': [() => define({}), /"lift of a wing" has neither force nor acceleration nor torque/],
  'a potential alone': [
    () => define({ potential: ({ mass }: BodySymbols) => mass }),
    /"lift of a wing" has neither force nor/,
  ],
  'a potential that is a vector': [
    () => define({ force: velocity, potential: velocity }),
    /"lift of a wing", potential must return a scalar, got a vector/,
  ],
  'a torque that is a number': [
    () => define({ torque: () => 1 }),
    /"lift of a wing", torque must return a vector, got 1/,
  ],
  'a force that is no function': [() => define({ force: 3 }), /"lift of a wing", force must be a function, got 3/],
  'a component that is none': [
    () => define({ reads: { k: 3 }, force: velocity }),
    /lift of a wing\.reads must be a component, such as COMPONENTS\.QuadraticDrag or one .*, got 3/,
  ],
  'a name that every law has': [
    () => define({ reads: { mass: COMPONENTS.Charge }, force: velocity }),
    /lift of a wing reads a component as "mass", the name of a symbol that every law has\. Choose another name/,
  ],
  'a parameter that is a number': [
    () => define({ parameters: { k: 3 }, force: velocity }),
    /lift of a wing\.parameters\.k must be a parameter, such as scalar\('N\/m'\), got 3/,
  ],
  'an unknown option': [() => define({ froce: velocity }), /defineLaw has no option "froce"\. Valid: name, .*force/],
  'no name': [() => defineLaw({ force: velocity } as never), /defineLaw: name must be a text, got undefined/],
  'four dimensions': [
    () => define({ dimensions: 4, force: velocity }),
    /lift of a wing\.dimensions must be 2 or 3, got 4/,
  ],
  'a preparation that is no function': [
    () => define({ force: velocity, prepare: 1 }),
    /lift of a wing\.prepare must be a function, got 1/,
  ],
  'a row outside of its sum': [
    () =>
      define({
        parameters: { t: rows },
        force: (
          _: BodySymbols,
          { t }: { t: { sum: (of: (row: { q: ScalarSymbol }) => ScalarSymbol) => ScalarSymbol } },
        ) => {
          t.sum((row) => {
            stolen.row = row.q;
            return row.q;
          });
          return vec3(stolen.row as ScalarSymbol, 0);
        },
      }),
    /"lift of a wing" reads the row of a table outside of its sum/,
  ],
  'a parameter of another law': [
    () => {
      defineLaw({
        name: 'other',
        parameters: { p: scalar('') },
        force: ({ velocity: v }, { p }) => {
          stolen.parameter = p;
          return v;
        },
      });
      define({ force: ({ velocity: v }: BodySymbols) => v.mul(stolen.parameter as ScalarSymbol) });
    },
    /"lift of a wing" reads a parameter of another law/,
  ],
  'nothing at all': [() => defineLaw(undefined as never), /defineLaw must be \{ name, .* \}, got undefined/],
};

describe('a law with', () => {
  test.each(Object.keys(OPTIONS))('%s', (name) => {
    const [act, sentence] = OPTIONS[name];
    expect(errorOf(act).message).toMatch(sentence);
  });
});

describe('the arguments of a law', () => {
  const law = defineLaw({ name: 'pull', parameters: { k: scalar('N', { min: 0 }) }, force: (_, { k }) => vec3(k, 0) });

  test.each([
    [{}, 'E_TYPE', /pull\.k must be a number, got undefined/],
    [{ k: -1 }, 'E_RANGE', /pull\.k must be at least 0, got -1/],
    [{ k: Number.NaN }, 'E_NONFINITE', /pull\.k must be finite, got NaN/],
    [{ k: 1, j: 2 }, 'E_UNKNOWN', /pull has no option "j"\. Valid: k\./],
    [3, 'E_TYPE', /pull must be \{ k \}, got 3/],
  ])('%j is refused, and the world keeps the force it had', (given, code, sentence) => {
    const world = createPhysicsWorld({ capacity: 10, forces: [law({ k: 1 })] });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.1);
    const [before, { forces }] = [worldState(world), { forces: [...world.forces] }];
    const error = errorOf(() => replaceForce(world, law(given as never)));
    expect(error.code).toBe(code);
    expect(error.message).toMatch(sentence);
    expect(world.forces).toEqual(forces);
    expect(worldState(world)).toEqual(before);
  });
});

describe('a law for other dimensions', () => {
  const inSpace = defineLaw({ name: 'corkscrew', dimensions: 3, force: velocity })();
  const inPlane = defineLaw({ name: 'eddy', dimensions: 2, force: velocity })();

  test.each([
    [2, inSpace, /forces\[0\]: law "corkscrew" requires 3 dimensions, but the world has 2/],
    [3, inPlane, /forces\[0\]: law "eddy" requires 2 dimensions, but the world has 3/],
  ] as const)('is refused by a new world of %i dimensions', (dimensions, force, sentence) => {
    expect(errorOf(() => createPhysicsWorld({ dimensions, forces: [force] })).message).toMatch(sentence);
  });

  test('is rejected by replaceForce and by the step before anything moves', () => {
    const old = defineLaw({ name: 'corkscrew', force: velocity })();
    const world = createPhysicsWorld({ capacity: 10, forces: [old] });
    const eid = spawn(world, { position: {}, velocity: { x: 1 }, mass: 1 });
    expect(() => replaceForce(world, inSpace)).toThrow(/requires 3 dimensions/);
    world.forces.push(inSpace);
    expect(() => step(world, 0.1)).toThrow(/world\.forces\[1\]: law "corkscrew" requires 3 dimensions/);
    expect([world.tick, world.components.Position.x[eid]]).toEqual([0, 0]);
    world.forces.pop();
    step(world, 0.1);
    expect(world.tick).toBe(1);
  });

  test('runs in a world of its dimensions', () => {
    for (const [dimensions, force] of [
      [2, inPlane],
      [3, inSpace],
    ] as const) {
      const world = createPhysicsWorld({ capacity: 10, dimensions, forces: [force] });
      const eid = spawn(world, { position: {}, velocity: { x: 3 }, mass: 1 });
      expect(forcesNow(world).x[eid]).toBe(3);
    }
  });
});

describe('many laws at once', () => {
  test('a hundred add up', () => {
    const laws = Array.from({ length: 100 }, (_, i) =>
      defineLaw({ name: `law ${i}`, parameters: { k: scalar('') }, force: (_body, { k }) => vec3(k, k.mul(i)) })({
        k: i + 1,
      }),
    );
    const world = createPhysicsWorld({ capacity: 10, forces: laws });
    const eid = spawn(world, { position: {}, velocity: {}, mass: 1 });
    const { x, y } = forcesNow(world);
    expect([x[eid], y[eid]]).toEqual([5050, laws.reduce((sum, _, i) => sum + i * (i + 1), 0)]);
    step(world, 0.5);
    expect(world.components.Velocity.x[eid]).toBe(2525);
  });

  test('a law that reads the force sees the sum of the laws before it', () => {
    const push = defineLaw({ name: 'push', force: () => vec3(3, 4) })();
    const weight = defineLaw({ name: 'weight', acceleration: () => vec3(0, -2) })();
    const brake = defineLaw({ name: 'brake', force: ({ force }) => force.mul(-0.5) })();
    const world = createPhysicsWorld({ capacity: 10, forces: [push, weight, brake, push] });
    const eid = spawn(world, { position: {}, velocity: {}, mass: 5 });
    const { x, y } = forcesNow(world);
    expect([x[eid], y[eid]]).toEqual([3 - 1.5 + 3, 4 - 10 + 3 + 4]);
  });
});
