import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { createCameraPath } from './camera-path.ts';

const KEYS = [
  { time: 1, eye: { x: 0, y: 0, z: 9 }, target: { x: 0, y: 0 } },
  { time: 3, eye: { x: 4, y: 1 }, target: { x: 1, y: 0 } },
  { time: 4, eye: { x: 9, y: 0, z: -5 }, target: { x: 5, y: 2 } },
];

function at(time: number, keys = KEYS) {
  const [eye, target] = [new Vector3(), new Vector3()];
  createCameraPath(keys).at(time, eye, target);
  return [eye.toArray(), target.toArray()];
}

it('passes through every key at its time, and stands still before and after', () => {
  for (const { time, eye, target } of KEYS) {
    expect(at(time)[0]).toEqual([eye.x, eye.y, eye.z ?? 0].map((value) => expect.closeTo(value, 9)));
    expect(at(time)[1]).toEqual([target.x, target.y, 0].map((value) => expect.closeTo(value, 9)));
  }
  expect(at(-5)).toEqual(at(1));
  expect(at(99)).toEqual(at(4));
});

it('goes straight, at even speed, between two keys', () => {
  const [first, second] = at(2, KEYS.slice(0, 2));
  expect(first).toEqual([2, 0.5, 4.5].map((value) => expect.closeTo(value, 9)));
  expect(second).toEqual([0.5, 0, 0].map((value) => expect.closeTo(value, 9)));
});

it('does not jump', () => {
  for (let time = 0.5; time < 4.5; time += 0.01) {
    const [[a], [b]] = [at(time), at(time + 0.01)];
    expect(Math.hypot(...a.map((value, i) => value - b[i]))).toBeLessThan(0.2);
  }
});

it('refuses keys that are no path', () => {
  expect(() => createCameraPath(KEYS.slice(0, 1))).toThrow('needs two keys or more with increasing times');
  expect(() => createCameraPath([KEYS[1], KEYS[0]])).toThrow('the times are 3, 1');
});
