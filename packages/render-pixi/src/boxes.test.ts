import { SHAPES, TrailHistory } from '@principia/render-core';
import { expect, it } from 'vitest';
import { createTestBodySource, type TestBodySource } from '../../../test/support/body-source.ts';
import { addBodies, addTrails, type Box } from './boxes.ts';

const NOTHING: Box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };

function move(source: TestBodySource, id: number, x: number, y: number): void {
  source.previousPosition.x[id] = source.position.x[id];
  source.previousPosition.y[id] = source.position.y[id];
  source.position.x[id] = x;
  source.position.y[id] = y;
  source.versions.pose++;
}

const sidesOf = ({ minX, minY, maxX, maxY }: Box) => [minX, minY, maxX, maxY];

it('holds the bodies that are drawn, at both ends of the last step, from an origin', () => {
  const source = createTestBodySource(1024, 2, 'f64');
  source.show([1, 2, 3, 4]);
  source.radius[1] = 2;
  source.size[1] = 1;
  move(source, 1, 1000, 5);
  move(source, 1, 1010, 5);
  source.size[2] = 0.001;
  source.position.x[2] = source.previousPosition.x[2] = 1020;
  source.radius[4] = 3;
  source.shape[4] = SHAPES.box;
  source.position.x[4] = source.previousPosition.x[4] = 1005;
  const box = { ...NOTHING };
  addBodies(box, source, { originX: 1000, originY: 2 }, 0.5, 0.25);
  // Body 3 has no size and is not drawn; the corners of body 4 reach √2 (3 + 0.25) m from its centre.
  const corner = Math.SQRT2 * 3.25;
  expect(sidesOf(box)).toEqual([-1.25, -2 - corner, 20.75, 3 + 1.25]);
});

it('holds the points of trails that are drawn, and those of no body that is gone', () => {
  for (const listed of [false, true]) {
    const source = createTestBodySource(1024, 2, 'f64');
    source.show([5, 7]);
    const history = new TrailHistory({ source, length: 3, ...(listed ? { bodies: [7, 5] } : {}) });
    for (const x of [-100, 1, 2, 3]) {
      move(source, 5, x, 10);
      move(source, 7, 50, x);
      history.record();
    }
    const both = { ...NOTHING };
    addTrails(both, history, 0.5);
    expect(sidesOf(both)).toEqual([0.5, 0.5, 50.5, 10.5]);
    source.show([5]);
    history.record();
    const one = { ...NOTHING };
    addTrails(one, history, 0.5);
    expect(sidesOf(one)).toEqual([1.5, 9.5, 3.5, 10.5]);
  }
});
