import { tmpdir } from 'node:os';
import { resolve } from 'node:path';
import { SCENES } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { ArgumentError, helpText, type RunRequest, readArguments, sceneList } from './arguments.ts';

const run = (...args: string[]) => readArguments(args) as RunRequest;

test('everything but the scene has a default', () => {
  const request = run('particles');
  expect(request.kind).toBe('run');
  expect(request.scene.name).toBe('particles');
  expect(request).toMatchObject({ steps: 200, warmup: 20, dimensions: 2, precision: 'f32', seed: 1, peers: false });
  expect(request.count).toBe(request.scene.parameters.count.initial);
  expect(request.json).toBeUndefined();
});

test('every option is read', () => {
  const text =
    '--count 1e3 --steps 7 --warmup 2 --dimensions 3 --precision f64 --seed 9 --peers --json a.json --html b.html';
  const request = run(...text.split(' '), 'springs');
  expect(request).toMatchObject({ count: 1000, steps: 7, warmup: 2, dimensions: 3, precision: 'f64', seed: 9 });
  expect(request.peers).toBe(true);
  expect(request.json).toBe(resolve('a.json'));
  expect(request.html).toBe(resolve('b.html'));
});

test('parameters of the scene are options', () => {
  expect(run('nbody-tree', '--relative-error', '0.01', '--falloff', '1').parameters).toEqual({
    relativeError: 0.01,
    falloff: 1,
  });
  expect(run('particles').parameters).toEqual({});
  expect(() => run('particles', '--relative-error', '0.01')).toThrow('The scene particles has no --relative-error.');
  expect(() => run('nbody-tree', '--relative-error', '9')).toThrow('--relative-error must be a number from 0 to 0.1');
  expect(() => run('nbody-tree', '--falloff', '1.5')).toThrow('--falloff must be a whole number from 1 to 2');
});

test('particles may rest, and feel more laws', () => {
  expect(run('particles').variant).toEqual({ resting: false, laws: 2 });
  expect(run('particles', '--resting', '--laws', '5').variant).toEqual({ resting: true, laws: 5 });
  expect(() => run('particles', '--laws', '4')).toThrow('--laws must be 2 or 3 or 5 or 8, not "4".');
  expect(() => run('gas', '--resting')).toThrow('Only the scene particles has --resting.');
  expect(() => run('gas', '--laws', '2')).toThrow('Only the scene particles has --laws.');
});

test('counts to measure the growth at are two numbers, and precision is the scene’s own', () => {
  expect(run('nbody-tree', '--scaling', '1e4-1e6').scaling).toEqual([10_000, 32_000, 100_000, 320_000, 1_000_000]);
  expect(run('nbody-tree').scaling).toBeUndefined();
  expect(run('solar-system').precision).toBe('f64');
  for (const text of ['1e4', '5-3', '1e4-9e9', '1-2-3', 'a-b']) {
    expect(() => run('nbody-tree', '--scaling', text)).toThrow(/--scaling must be two counts such as 2-4000000/);
  }
});

test('a short run has a short warm-up', () => {
  expect(run('particles', '--steps', '5').warmup).toBe(1);
  expect(run('particles', '--steps', '1').warmup).toBe(0);
});

describe('one sentence says what is wrong and what would be right', () => {
  const names = SCENES.map(({ name }) => name).join(', ');
  test.each([
    [[], `Name the scene to measure: ${names}.`],
    [['particels'], `There is no scene "particels": the scenes are ${names}.`],
    [['particles', 'springs'], /Only one scene.*one of particles/],
    [['particles', '--cuont', '5'], /'--cuont'.*the options are --count, .*--help\.$/],
    [['particles', '--count'], /--count.*the options are/],
    [['particles', '--peers=yes'], /--peers.*the options are/],
    [['particles', '--count', '0'], '--count must be a whole number from 1 to 8000000, not "0".'],
    [['particles', '--count', 'many'], /--count must be a whole number from 1 to .*, not "many"\./],
    [['particles', '--count', '1.5'], /--count must be a whole number/],
    [['particles', '--count', '1e99'], /--count must be a whole number/],
    [['particles', '--count', ''], /--count must be a whole number.*not ""/],
    [['particles', '--steps', '-3'], /--steps.*the options are/],
    [['particles', '--steps=-3'], /--steps must be a whole number from 1/],
    [['particles', '--steps', '5', '--warmup', '5'], '--warmup must be a whole number from 0 to 4, not "5".'],
    [['particles', '--steps', '2', '--peers'], '--peers needs at least 5 timed steps here, and 2 are left.'],
    [['particles', '--dimensions', '4'], '--dimensions must be 2 or 3, not "4".'],
    [['particles', '--precision', 'f16'], '--precision must be f32 or f64, not "f16".'],
    [['particles', '--seed', '-1'], /--seed/],
    [['particles', '--json', 'no/such/folder/a.json'], /--json must be a file in a folder that exists/],
    [['particles', '--html', tmpdir()], /--html must be a file in a folder that exists/],
  ] as const)('%j', (args, message) => {
    expect(() => readArguments(args)).toThrow(ArgumentError);
    expect(() => readArguments(args)).toThrow(message);
    try {
      readArguments(args);
    } catch (error) {
      expect((error as Error).message).not.toContain('\n');
    }
  });
});

test('help and the list name every scene, and win over the rest', () => {
  for (const { name, description } of SCENES) {
    expect(sceneList()).toContain(name);
    expect(helpText()).toContain(description);
  }
  expect(readArguments(['--help', 'nonsense']).kind).toBe('help');
  expect(readArguments(['--list']).kind).toBe('list');
});
