import { atan2, cos, sin } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const degrees = (angle: number) => (angle * 180) / Math.PI;
/** The angle whose tangent is y/x: it cannot tell a point from the opposite one. */
const simple = (y: number, x: number) => degrees(atan2(y / x, 1));

export default defineExample({
  id: 'ch03-inverse-trig',
  title: 'In which direction is it?',
  chapter: 3,
  tags: ['angles', 'vectors'],
  about:
    'The dot circles round, and the computer shall say at which angle it is. The inverse of the tangent only knows the quotient y/x, and that is the same for a point and the one opposite: its arrow (red) never points to the left. The function atan2 looks at both signs, and its arrow (green) follows the dot in all four quarters.',
  duration: 12,
  parameters: {
    rate: { label: 'Angle per second', unit: 'rad/s', initial: 0.6, min: 0.1, max: 3 },
    start: { label: 'Angle at the start', unit: 'rad', initial: 0.2, min: -3, max: 3 },
  },
  build({ rate, start }) {
    const world = emptyWorld();
    const at = () => ({ x: cos(start + rate * world.time), y: sin(start + rate * world.time) });
    const byBoth = () => degrees(atan2(at().y, at().x));
    const byQuotient = () => simple(at().y, at().x);
    return { world, dt: 1 / 60, at, byBoth, byQuotient };
  },
  picture({ at, byBoth, byQuotient }) {
    const pointing = (angle: () => number, length: number) => () => ({
      x: length * cos((angle() * Math.PI) / 180),
      y: length * sin((angle() * Math.PI) / 180),
    });
    const circle = pointsOf((angle) => ({ x: cos(angle), y: sin(angle) }), 0, 2 * Math.PI);
    return {
      view: { minX: -1.7, maxX: 1.7, minY: -1.2, maxY: 1.2 },
      curves: [{ points: circle, color: COLORS.grey }],
      lines: [
        { from: { x: -1.4, y: 0 }, to: { x: 1.4, y: 0 }, color: COLORS.ground },
        { from: { x: 0, y: -1.2 }, to: { x: 0, y: 1.2 }, color: COLORS.ground },
      ],
      arrows: [
        { label: 'atan', from: { x: 0, y: 0 }, vector: pointing(byQuotient, 0.6), color: COLORS.red },
        { label: 'atan2', from: { x: 0, y: 0 }, vector: pointing(byBoth, 0.85), color: COLORS.green },
      ],
      dots: [{ at, radius: 9 }],
      labels: [
        { at: { x: -1.65, y: 1.05 }, text: () => `atan2 ${byBoth().toFixed(0)}°, atan ${byQuotient().toFixed(0)}°` },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Angle that is found',
      'angle, °',
      { label: 'atan', value: ({ byQuotient }) => byQuotient() },
      { label: 'atan2', value: ({ byBoth }) => byBoth() },
    ),
  ],
  checks: ({ at }) => [
    at(0, 'The angle whose tangent is 1', { exact: 45, unit: '°', absolute: 1e-12 }, () => simple(1, 1)),
    at(0, 'Direction of the point (−2, −2) by atan2', { exact: -135, unit: '°', absolute: 1e-12 }, () =>
      degrees(atan2(-2, -2)),
    ),
    at(0, 'Direction of the point (−2, −2) by the quotient, 180° off', { exact: 45, unit: '°', absolute: 1e-12 }, () =>
      simple(-2, -2),
    ),
  ],
  tryThis: [
    'Watch the moment in which the dot crosses the upright line: the red arrow jumps to the other side.',
    'Watch the plot: atan2 jumps only once in a turn, from 180° to −180°, which is the same direction.',
  ],
});
