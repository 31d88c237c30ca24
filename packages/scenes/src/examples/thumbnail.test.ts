import { expect, test } from 'vitest';
import graph from './ch03/trig-animation.ts';
import example from './ch05/floating-ball.ts';
import { thumbnail } from './thumbnail.ts';

test('draws the bodies, the regions and the paths of an example as SVG, the same each time', () => {
  const picture = thumbnail(example);
  expect(picture).toMatch(/^<svg [^>]*viewBox="0 0 240 150">.*<\/svg>$/);
  expect(picture.match(/<circle/g)).toHaveLength(2);
  expect(picture).toContain('fill-opacity="0.45"');
  expect(picture).toMatch(/<path d="M[^"]*" fill="none"/);
  expect(thumbnail(example)).toBe(picture);
});

test('draws curves and dots of a graph within the picture', () => {
  const numbers = [...thumbnail(graph).matchAll(/[ML]([\d.]+) ([\d.]+)/g)];
  expect(numbers.length).toBeGreaterThan(100);
  expect(Math.max(...numbers.map(([, x]) => Number(x)))).toBeLessThanOrEqual(240);
  expect(Math.max(...numbers.map(([, , y]) => Number(y)))).toBeLessThanOrEqual(150);
});
