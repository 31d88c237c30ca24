import { createPhysicsWorld, spawn, step } from '@principia/physics';
import { worldSource } from '@principia/render-core';
import { expect, it } from 'vitest';
import { pickBody2D } from './pick.ts';

const world = createPhysicsWorld({ capacity: 10 });
const still = spawn(world, { position: { x: 0 }, collider: 1 });
const above = spawn(world, { position: { x: 1.5 }, collider: 1 });
const moving = spawn(world, { position: { x: 10 }, velocity: { x: 4 }, collider: 0.5 });
spawn(world, { position: { x: 30 } });
step(world, 1);
const source = worldSource(world);
const pick = (x: number, y: number, slack = 0, alpha = 1) => pickBody2D(source, alpha, x, y, slack);

it('finds the body under a point, the upper of two', () => {
  expect(pick(-0.5, 0.5)).toBe(still);
  expect(pick(0.75, 0)).toBe(above);
  expect(pick(0, 1.1)).toBe(0);
  expect(pick(30, 0, 0.5)).toBe(0);
});

it('looks where the body is drawn, between two steps', () => {
  expect([0, 0.5, 1].map((alpha) => pick(12, 0, 0, alpha))).toEqual([0, moving, 0]);
});

it('takes the nearest one where nothing is hit, within the slack', () => {
  expect(pick(0, 1.1, 0.2)).toBe(still);
  expect(pick(2.6, 0, 0.2)).toBe(above);
  expect(pick(4, 0, 1)).toBe(0);
  expect(pick(0.75, 0.9, 1)).toBe(above);
});
