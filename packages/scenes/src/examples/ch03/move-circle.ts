import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf } from '../support/functions.ts';
import { emptyWorld, lengthOf } from '../support/read.ts';

/** x grows by 0.002 in each of 60 ticks a second. */
const SPEED = 0.12;
const lowerHalf = (x: number) => -Math.sqrt(Math.max(0, 1 - x * x));

export default defineExample({
  id: 'ch03-move-circle',
  title: 'Half a circle, the wrong way',
  chapter: 3,
  tags: ['functions', 'circle', 'animation'],
  about:
    'From x² + y² = 1 follows y = −√(1 − x²), the lower half of a circle. The dot moves evenly to the right, but not evenly along the circle: where the circle is steep it has a long distance to go for each bit of x. A function has one y for each x, so it cannot go round at all.',
  duration: 2 / SPEED,
  ends: true,
  parameters: { radius: { label: 'Radius', initial: 1, min: 0.5, max: 1.2 } },
  build({ radius }) {
    const world = emptyWorld();
    const x = () => Math.min(1, -1 + SPEED * world.time);
    const at = () => ({ x: radius * x(), y: radius * lowerHalf(x()) });
    // Distance that the dot has moved in the last tick, as a speed.
    const speed = () => {
      const before = Math.max(-1, x() - SPEED / 60);
      return 60 * radius * lengthOf({ x: x() - before, y: lowerHalf(x()) - lowerHalf(before) });
    };
    return { world, dt: 1 / 60, x, at, speed };
  },
  picture: ({ at }, { radius }) => ({
    graph: { x: { label: 'x', step: 0.5 }, y: { label: 'y', step: 0.5 } },
    view: { minX: -2, maxX: 2, minY: -1.25, maxY: 1.25 },
    curves: [{ points: graphOf((x) => radius * lowerHalf(x / radius), -radius, radius, 1000), color: COLORS.red }],
    lines: [{ from: { x: 0, y: 0 }, to: at, color: COLORS.grey, width: 1 }],
    dots: [{ at, color: COLORS.blue, radius: 8 }],
  }),
  plots: (plot) => [
    plot('Speed along the circle', 'speed, 1/s', { label: 'speed', value: ({ speed }) => Math.min(1, speed()) }),
  ],
  checks: ({ at, largest }) => [
    largest(
      2 / SPEED,
      'Largest x² + y² of the dot',
      { exact: ({ radius }) => radius * radius, absolute: 1e-12 },
      ({ at }) => at().x * at().x + at().y * at().y,
    ),
    at(
      1 / SPEED,
      'Speed at the bottom, x = 0',
      { exact: ({ radius }) => radius * SPEED, unit: '1/s', relative: 1e-5 },
      ({ speed }) => speed(),
    ),
    // The last tick is centred a thousandth before 0.6, where the speed is 0.2 % smaller.
    at(
      1.6 / SPEED,
      'Speed at x = 0.6, larger by 1/√(1 − 0.36) = 1.25',
      { exact: ({ radius }) => 1.25 * radius * SPEED, unit: '1/s', relative: 2e-3 },
      ({ speed }) => speed(),
    ),
  ],
  tryThis: [
    'Watch the dot at both ends: it falls like a stone, although x grows as slowly as everywhere.',
    'Compare it with “Round and round with sine and cosine”, one example back, where the dot goes round evenly.',
  ],
});
