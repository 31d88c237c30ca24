// Cases 20 and 21 for integrators, walls and networks: each option that is NaN, of a wrong type or unknown is
// refused.
import { readdirSync, readFileSync } from 'node:fs';
import * as physics from '@principia/physics';
import { createPhysicsWorld, PhysicsError } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { LAW_RECORDS } from '../support/law-records.ts';
import { refusal, worldState } from '../support/worlds.ts';

type Maker = (...args: unknown[]) => unknown;

/** Valid options of each function. Laws have a list of their own. */
const GOOD: Record<string, object> = {
  boris: { field: { z: 1 } },
  dormandPrince: {},
  gaussRadau: {},
  implicitEuler: {},
  softStep: {},
  revolute: { a: 1, b: 2, anchor: {} },
  distance: { a: 1, b: 2 },
  prismatic: { a: 1, b: 2, anchor: {}, axis: { x: 1 } },
  weld: { a: 1, b: 2, anchor: {} },
  wheel: { a: 1, b: 2, anchor: {} },
  motorJoint: { b: 2, maxForce: 1, maxTorque: 1 },
  mouseJoint: { b: 2, target: {}, maxForce: 1 },
  pulley: { a: 1, b: 2, pulleyA: {}, pulleyB: {} },
  gear: { a: 1, b: 2, ratio: 1 },
  filterJoint: { a: 1, b: 2 },
  wisdomHolman: {},
  xpbd: {},
  boxWalls: { min: { x: -1 }, max: { x: 1 } },
  gusts: { spread: { x: 1 }, interval: 1 },
  correlatedGusts: { deviation: { x: 1 }, time: 1 },
};

/** Valid options of the functions that create something in a world. */
const GOOD_IN_WORLD: Record<string, object> = {
  createRope: { from: {}, to: { x: 1 }, nodes: 3, mass: 1 },
  createCloth: { corner: {}, columns: 3, rows: 3, spacing: 1, mass: 1 },
  createSoftBody: { centre: {}, radius: 1, mass: 1, stiffness: 1, pressure: 1 },
  createEmitter: { capacity: 5 },
  explode: { impulse: 1, radius: 1 },
  createRunner: {},
  replaceBoxWalls: { min: { x: -1 }, max: { x: 1 } },
};

const folder = 'packages/physics/src';
const sources = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts') && !path.endsWith('.test.ts'))
  .map((path) => readFileSync(`${folder}/${path}`, 'utf8'))
  .join('\n');

/** Exported functions that take options, alone or after a world. */
function makers(pattern: string): string[] {
  const laws = LAW_RECORDS.map(({ maker }) => maker);
  const found = [
    ...sources.matchAll(new RegExp(`export function (\\w+)\\(${pattern}options: \\w+( = \\{\\})?\\)`, 'g')),
  ];
  return found.map(([, name]) => name).filter((name) => name in physics && !laws.includes(name));
}

function check(call: (options: object) => unknown, good: object): void {
  const { code, hint = '' } = refusal(() => call({ ...good, colour: 1 }));
  expect(code).toBe('E_UNKNOWN');
  for (const key of hint.replace(/^Valid: |\.$/g, '').split(', ')) {
    let thrown: unknown = `${key}: nothing was thrown`;
    try {
      call({ ...good, [key]: Number.NaN });
    } catch (error) {
      thrown = error;
    }
    expect(thrown).toBeInstanceOf(PhysicsError);
  }
}

describe('20, 21', () => {
  it('the lists contain every function with options', () => {
    const rest = ['createPhysicsWorld'];
    expect(Object.keys(GOOD).toSorted()).toEqual(
      makers('')
        .filter((name) => !rest.includes(name))
        .toSorted(),
    );
    expect(Object.keys(GOOD_IN_WORLD).toSorted()).toEqual(makers('world: PhysicsWorld, ').toSorted());
  });

  it.each(Object.entries(GOOD))('%s', (name, good) => {
    const make = (physics as unknown as Record<string, Maker>)[name];
    expect(make(good)).toBeDefined();
    check(make, good);
  });

  it.each(Object.entries(GOOD_IN_WORLD))('%s does not change the world', (name, good) => {
    const make = (physics as unknown as Record<string, Maker>)[name];
    const world = createPhysicsWorld({ dimensions: name === 'createCloth' ? 3 : 2, capacity: 200 });
    const before = worldState(world);
    check((options) => make(world, options), good);
    expect(worldState(world)).toEqual(before);
  });
});

it('what is refused is a PhysicsError with a code', () => {
  expect(refusal(() => physics.boxWalls({ min: { x: Number.NaN } }))).toBeInstanceOf(PhysicsError);
});
