/** Every public function with a destroyed world, with an invalid world, and with unknown keys. */
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import * as physics from '@principia/physics';
import {
  clearFaults,
  createEmitter,
  createPhysicsWorld,
  createRunner,
  destroyWorld,
  localSystem,
  on,
  resetProfile,
  resource,
  rgba,
  spawn,
  startProfile,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { assertRefused, assertWorldAlive, ball, groundWorld, refusal } from '../support/worlds.ts';

const folder = fileURLToPath(new URL('../../packages/physics/src', import.meta.url));
const sources = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts') && !path.endsWith('.test.ts'))
  .map((path) => readFileSync(`${folder}/${path}`, 'utf8'))
  .join('\n');

type AnyFunction = (...args: unknown[]) => unknown;

/** Returns the public functions whose first parameter is declared as `parameter`, so that none is missing here. */
function publicFunctions(parameter: string): [string, AnyFunction][] {
  return Object.entries(physics).flatMap(([name, value]): [string, AnyFunction][] => {
    const declared = new RegExp(`export function ${name}(<[^(]*>)?\\(\\s*${parameter}\\b`).test(sources);
    return typeof value === 'function' && declared ? [[name, value as AnyFunction]] : [];
  });
}

/** `destroyWorld` can be called twice, which has its own test. */
const onWorlds = publicFunctions('world: PhysicsWorld').filter(([name]) => name !== 'destroyWorld');
const onEmitters = publicFunctions('emitter: Emitter');
onWorlds.push(['a resource', resource(() => ({ count: 0 })) as AnyFunction]);

describe('61 use after destroy', () => {
  it('61 the list of functions is complete', () => {
    const names = onWorlds.map(([name]) => name);
    expect(names).toEqual(
      expect.arrayContaining(['spawn', 'spawnMany', 'step', 'stateHash', 'on', 'bodies', 'energy']),
    );
    expect(onEmitters.map(([name]) => name)).toContain('setEmitter');
  });

  it.each(onWorlds)('61 %s gives E_DESTROYED', (_, call) => {
    const world = groundWorld();
    ball(world, 0, 1);
    destroyWorld(world);
    // The world is validated before the other arguments.
    expect(refusal(() => call(world)).code).toBe('E_DESTROYED');
  });

  it.each(onEmitters)('61 %s gives E_DESTROYED on an emitter of a destroyed world', (_, call) => {
    const world = groundWorld();
    const emitter = createEmitter(world, { capacity: 10 });
    destroyWorld(world);
    expect(refusal(() => call(emitter)).code).toBe('E_DESTROYED');
  });

  it.each(onWorlds)('%s refuses an invalid world with E_TYPE', (_, call) => {
    for (const bad of [undefined, null, {}, 5]) expect(refusal(() => call(bad)).code).toBe('E_TYPE');
  });
});

describe('arguments', () => {
  it('spawn refuses an invalid description of a body and lists the valid keys', () => {
    const world = groundWorld();
    ball(world, 0, 1);
    for (const bad of [null, undefined, 5, 'ball', [], () => 0]) {
      assertRefused(world, () => spawn(world, bad as never), { code: 'E_TYPE' });
    }
    assertRefused(world, () => spawn(world, { radius: 1 } as never), {
      code: 'E_UNKNOWN',
      field: 'radius',
      hint: /position, velocity, mass/,
    });
    assertRefused(world, () => spawn(world, { position: { X: 1 } } as never), {
      code: 'E_UNKNOWN',
      field: 'X',
      hint: /x, y, z/,
    });
    assertRefused(world, () => spawn(world, { position: 5 } as never), { code: 'E_TYPE', field: 'position' });
    assertRefused(world, () => spawn(world, { mass: 'heavy' } as never), { code: 'E_TYPE', field: 'mass' });
    assertRefused(world, () => spawn(world, { position: {}, kinematic: true } as never), {
      code: 'E_TYPE',
      field: 'kinematic',
      hint: /write kinematic: \{\}/,
    });
    assertWorldAlive(world);
  });

  it.each([
    [{ capacity: 0 }, 'E_RANGE', 'capacity'],
    [{ capacity: 1.5 }, 'E_RANGE', 'capacity'],
    [{ capacity: '5' }, 'E_TYPE', 'capacity'],
    [{ capacity: NaN }, 'E_NONFINITE', 'capacity'],
    [{ seed: -1 }, 'E_RANGE', 'seed'],
    [{ dimensions: 4 }, 'E_RANGE', 'dimensions'],
    [{ precision: 'f16' }, 'E_RANGE', 'precision'],
    [{ onFault: 'ignore' }, 'E_RANGE', 'onFault'],
    [{ arenaBytes: -1 }, 'E_RANGE', 'arenaBytes'],
    [{ gravity: 5 }, 'E_UNKNOWN', 'gravity'],
    [null, 'E_TYPE', 'createPhysicsWorld'],
    [5, 'E_TYPE', 'createPhysicsWorld'],
  ])('a world with options %o is refused with %s', (options, code, field) => {
    expect(refusal(() => createPhysicsWorld(options as never))).toMatchObject({ code, field });
  });

  it('on refuses unknown events and invalid handlers', () => {
    const world = groundWorld();
    expect(refusal(() => on(world, 'colision' as never, () => {}))).toMatchObject({
      code: 'E_UNKNOWN',
      hint: expect.stringMatching(/contact, wallContact, fault/),
    });
    expect(refusal(() => on(world, '__proto__' as never, () => {})).code).toBe('E_UNKNOWN');
    expect(refusal(() => on(world, 'fault', undefined as never)).code).toBe('E_TYPE');
  });

  it('small functions refuse invalid arguments', () => {
    const world = groundWorld();
    expect(refusal(() => startProfile(world, performance as never)).code).toBe('E_TYPE');
    expect(refusal(() => localSystem('mine', undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => clearFaults(undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => resetProfile(undefined as never)).code).toBe('E_TYPE');
    expect(refusal(() => resource(5 as never)).code).toBe('E_TYPE');
    expect(refusal(() => rgba(NaN, 0, 0)).code).toBe('E_NONFINITE');
    expect(refusal(() => createRunner(world, 5 as never)).code).toBe('E_TYPE');
    expect(refusal(() => physics.angularMomentum(world, { x: NaN })).code).toBe('E_NONFINITE');
  });

  it('an error names the problem, the field, the value and a remedy', () => {
    const error = refusal(() => spawn(groundWorld(), { mass: 0 }));
    expect(error).toMatchObject({ name: 'PhysicsError', code: 'E_RANGE', field: 'mass', value: 0 });
    expect(error.message).toBe(
      'E_RANGE: mass must be greater than 0, got 0. For a body that forces do not move, omit Mass.',
    );
  });
});
