import { expect, it } from 'vitest';
import { checkValue, initialValues, numberSetting, parseValue, switchSetting } from './settings.ts';

const count = numberSetting({ unit: '', initial: 5, min: 1, max: 100, integer: true }, { label: 'Balls' });
const gravity = numberSetting({ unit: 'm/s²', initial: 9.8, min: 0, max: 30 }, { label: 'Gravity', max: 20 });
const trails = switchSetting('Trails', false, { key: 't' });
const shape = { kind: 'choice', label: 'Shape', initial: 'ball', choices: { Ball: 'ball', Box: 'box' } } as const;

it('starts with the initial values, the limits being those of the panel', () => {
  expect(initialValues({ count, gravity, trails, shape })).toEqual({
    count: 5,
    gravity: 9.8,
    trails: false,
    shape: 'ball',
  });
  expect(gravity.max).toBe(20);
});

it.each([
  ['count', count, 7],
  ['gravity', gravity, 0],
  ['trails', trails, true],
  ['shape', shape, 'box'],
] as const)('takes a value of %s that fits', (name, setting, value) => {
  expect(checkValue(name, setting, value)).toBe(value);
});

it.each([
  ['count', count, 1.5, 'count must be a whole number from 1 to 100, but it was 1.5.'],
  ['count', count, 101, 'count must be a whole number from 1 to 100, but it was 101.'],
  ['count', count, Number.NaN, 'but it was NaN.'],
  ['gravity', gravity, '3', 'gravity must be a number from 0 to 20 m/s², but it was “3”.'],
  ['trails', trails, 1, 'trails must be on or off, but it was 1.'],
  ['shape', shape, 'ring', 'shape must be ball or box, but it was “ring”.'],
] as const)('says in a sentence why %s does not take a value', (name, setting, value, sentence) => {
  expect(() => checkValue(name, setting, value)).toThrow(sentence);
});

it('reads words of an address', () => {
  expect(parseValue('count', count, '12')).toBe(12);
  expect(parseValue('gravity', gravity, '1e1')).toBe(10);
  expect(['', '1', 'on', 'TRUE'].map((text) => parseValue('trails', trails, text))).toEqual([true, true, true, true]);
  expect(['0', 'off', 'no'].map((text) => parseValue('trails', trails, text))).toEqual([false, false, false]);
  expect(parseValue('shape', shape, 'box')).toBe('box');
});

it.each(['', ' ', 'abc', '5x', 'Infinity', 'NaN'])('takes “%s” for no number', (text) => {
  expect(() => parseValue('count', count, text)).toThrow('count must be a whole number');
});
