/** Every exported function gets hostile arguments: it throws a PhysicsError or accepts them, and the world continues. */
import * as physics from '@principia/physics';
import { createEmitter, createPhysicsWorld, PhysicsError, type PhysicsWorld, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';

type Call = (...args: unknown[]) => unknown;

const hostile = (): unknown[] => [
  undefined,
  null,
  Number.NaN,
  Number.NEGATIVE_INFINITY,
  -1,
  0,
  1.5,
  1e300,
  2 ** 53,
  '',
  'x',
  true,
  Symbol('x'),
  5n,
  [],
  [Number.NaN, null],
  {},
  { x: 'a', y: null },
  Object.create(null),
  Object.freeze({}),
  () => undefined,
  new Map(),
  new Float64Array(2),
  new Date(0),
  { length: 1e9 },
  { name: 'x', run: 5, accumulate: 'y', advance: null },
];

function makeWorld(): PhysicsWorld {
  const world = createPhysicsWorld({ capacity: 50, preset: physics.particleContacts, onWarning: () => {} });
  for (const x of [0, 0.3]) spawn(world, { position: { x }, mass: 1, collider: 0.2 });
  return world;
}

/** Numeric functions treat what is no number as `Math` does: symbols and BigInts throw a TypeError. */
const NUMERIC = ['sin', 'cos', 'exp', 'log', 'pow', 'atan2'];

/** Factories and functions; classes are for errors. */
const functions = Object.entries(physics).filter(
  ([name, value]) => typeof value === 'function' && !/^[A-Z]/.test(name) && !NUMERIC.includes(name),
) as [string, Call][];

/** What a call threw that is no PhysicsError. */
function wrongError(call: () => unknown): string | undefined {
  try {
    call();
  } catch (error) {
    const errors = error instanceof AggregateError ? error.errors : [error];
    const wrong = errors.find((each) => !(each instanceof PhysicsError));
    if (wrong !== undefined) return String(wrong);
  }
  return undefined;
}

describe.each(functions)('%s', (name, call) => {
  it('throws nothing but PhysicsErrors', () => {
    const wrong = new Set<string>();
    let world = makeWorld();
    const attempt = (...args: unknown[]) => {
      if (world.state === 'destroyed') world = makeWorld();
      const error = wrongError(() => call(...args));
      if (error !== undefined) wrong.add(`${name}(${args.map(describeArgument).join(', ')}): ${error}`);
    };
    attempt();
    for (const a of hostile()) {
      attempt(a);
      attempt(world, a);
      attempt(world, 1, a);
      attempt(world, a, {});
      attempt(createEmitter(makeWorld(), { capacity: 3 }), a);
      attempt(world, { x: 1 }, a);
    }
    expect([...wrong].slice(0, 5)).toEqual([]);
    if (world.state === 'destroyed') return;
    expect(wrongError(() => step(world, 0.01))).toBeUndefined();
    expect(world.tick).toBeGreaterThan(0);
  });
});

function describeArgument(argument: unknown): string {
  if (typeof argument === 'object' && argument !== null) return argument.constructor?.name ?? 'object';
  return String(argument);
}
