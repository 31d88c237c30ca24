import { SHAPES } from '@principia/render-core';
import { Ray, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { createTestBodySource, type TestBodySource } from '../../../test/support/body-source.ts';
import { pickBody } from './body-picker.ts';

const towards = (x: number, y: number, z = 10) => new Ray(new Vector3(x, y, z), new Vector3(0, 0, -1));

function balls(places: [id: number, x: number, y: number, z: number][], dimensions: 2 | 3 = 3): TestBodySource {
  const source = createTestBodySource(1024, dimensions);
  for (const [id, x, y, z] of places) {
    for (const { x: px, y: py, z: pz } of [source.position, source.previousPosition]) {
      px[id] = x;
      py[id] = y;
      pz[id] = z;
    }
    source.radius[id] = 1;
  }
  source.show(places.map(([id]) => id));
  return source;
}

test('the nearest of the bodies the ray meets, and how far its surface is', () => {
  const source = balls([
    [4, 0, 0, 0],
    [9, 0, 0, 3],
    [20, 5, 0, 0],
  ]);
  const result = { id: -1, distance: 0 };
  expect(pickBody(source, towards(0, 0), { result })).toBe(9);
  expect(result).toEqual({ id: 9, distance: 6 });
  expect(pickBody(source, towards(0.6, 0), { result })).toBe(9);
  expect(result.distance).toBeCloseTo(7 - 0.8, 12);
  expect(pickBody(source, towards(5.5, 0))).toBe(20);
});

test('none beside, behind, inside or without a radius', () => {
  const source = balls([[1, 0, 0, 0]]);
  expect(pickBody(source, towards(1.01, 0))).toBe(0);
  expect(pickBody(source, towards(0, 0, -5))).toBe(0);
  expect(pickBody(source, towards(0, 0, 0.5))).toBe(0);
  source.radius[1] = 0;
  expect(pickBody(source, towards(0, 0))).toBe(0);
  source.size[1] = 2;
  expect(pickBody(source, towards(1.9, 0))).toBe(1);
});

test('slack widens bodies with their distance', () => {
  const source = balls([[1, 0, 0, 0]]);
  expect(pickBody(source, towards(1.4, 0), { slack: 0.05 })).toBe(1);
  expect(pickBody(source, towards(1.4, 0), { slack: 0.03 })).toBe(0);
});

test('alpha looks where the body is drawn between two steps', () => {
  const source = balls([[1, 4, 0, 0]]);
  source.previousPosition.x[1] = 0;
  expect(pickBody(source, towards(2, 0), { alpha: 0.5 })).toBe(1);
  expect(pickBody(source, towards(2, 0), { alpha: 1 })).toBe(0);
});

test('a 2D world lies in the plane z = 0 whatever its z column holds', () => {
  const result = { id: 0, distance: 0 };
  pickBody(balls([[1, 0, 0, 7]], 2), towards(0, 0), { result });
  expect(result).toEqual({ id: 1, distance: 9 });
});

test('a box is met at its faces, turned as it is', () => {
  const source = balls([[1, 0, 0, 0]]);
  source.shape[1] = SHAPES.box;
  const result = { id: 0, distance: 0 };
  expect(pickBody(source, towards(0.99, 0.99), { result })).toBe(1);
  expect(result.distance).toBeCloseTo(9, 9);
  expect(pickBody(source, towards(1.3, 0))).toBe(0);
  // An eighth of a turn about z brings an edge to x = √2; one about x, an edge to z = √2.
  const turn = { s: Math.sin(Math.PI / 8), c: Math.cos(Math.PI / 8) };
  source.orientation.z[1] = turn.s;
  source.orientation.w[1] = turn.c;
  expect(pickBody(source, towards(1.3, 0))).toBe(1);
  expect(pickBody(source, towards(0.99, 0.99))).toBe(0);
  source.orientation.z[1] = 0;
  source.orientation.x[1] = turn.s;
  expect(pickBody(source, towards(0, 0), { result })).toBe(1);
  expect(result.distance).toBeCloseTo(10 - Math.SQRT2, 6);
});

test('a box of a 2D world turns by its angle', () => {
  const source = balls([[1, 0, 0, 0]], 2);
  source.shape[1] = SHAPES.box;
  source.angle[1] = Math.PI / 4;
  source.previousAngle[1] = Math.PI / 4;
  expect(pickBody(source, towards(1.3, 0))).toBe(1);
  expect(pickBody(source, towards(0.99, 0.99))).toBe(0);
});
