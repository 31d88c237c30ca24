import { constantTorque, createPhysicsWorld, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { placeOn, spokes, star } from '../support/outline.ts';
import { distanceBetween } from '../support/read.ts';

const [INNER, OUTER, DENSITY] = [40, 50, 0.01];
const SIDES = 72;

const massOf = (density: number) => density * Math.PI * (OUTER * OUTER - INNER * INNER);
const inertiaOf = (density: number) => (massOf(density) * (OUTER * OUTER + INNER * INNER)) / 2;

export default defineExample({
  id: 'ch09-wheel-shape',
  title: 'A wheel with spokes',
  chapter: 9,
  tags: ['drawing', 'rotation', 'moment of inertia'],
  about:
    'A rim from 40 to 50 px and spokes at equal angles make a wheel. As all of the rim is far from the axle, it is hard to set in rotation: its moment of inertia is m (R² + r²)/2, nearly twice that of a full disc of the same mass. A torque turns it faster and faster.',
  duration: 6,
  parameters: {
    spokes: { label: 'Spokes', initial: 10, min: 2, max: 24, integer: true },
    torque: { label: 'Torque', unit: 'kg px²/s²', initial: 15_000, min: -40_000, max: 40_000 },
  },
  build({ torque, spokes: count }: ValuesOf<'spokes' | 'torque'>, options) {
    const world = createPhysicsWorld({ capacity: 2, forces: [constantTorque({ z: torque })], ...options });
    const [mass, inertia] = [massOf(DENSITY), inertiaOf(DENSITY)];
    const wheel = spawn(world, { position: {}, velocity: {}, rotation: 0, angularVelocity: 0, mass, inertia });
    return { world, dt: 1 / 60, wheel, tips: star(count, INNER), rate: torque / inertia };
  },
  picture({ world, wheel, tips }) {
    const ring = (radius: number) => {
      const points = star(SIDES, radius);
      return points.map((_, i) => ({
        from: () => placeOn(world, wheel, points[i]),
        to: () => placeOn(world, wheel, points[(i + 1) % SIDES]),
        color: COLORS.white,
        width: 3,
      }));
    };
    return {
      view: { minX: -90, maxX: 90, minY: -65, maxY: 65 },
      lines: [...ring(INNER), ...ring(OUTER), ...spokes(world, wheel, tips, { color: COLORS.blue, width: 3 })],
      dots: [{ at: () => placeOn(world, wheel, { x: (INNER + OUTER) / 2, y: 0 }), radius: 6, color: COLORS.orange }],
    };
  },
  plots: (plot) => [
    plot('Angular velocity', 'ω, rad/s', {
      label: 'wheel',
      value: ({ world, wheel }) => world.components.AngularVelocity.z[wheel],
    }),
  ],
  checks: ({ at }) => [
    at(
      0,
      'Distance of the tips of two neighbouring spokes, 2 r sin(π/n)',
      { exact: 20 * (Math.sqrt(5) - 1), unit: 'px', absolute: 5e-5 },
      ({ tips }) => distanceBetween(tips[0], tips[1]),
    ),
    at(
      6,
      'Angular velocity after 6 s, torque · t/I',
      { exact: (15_000 * 6) / inertiaOf(DENSITY), unit: 'rad/s', relative: 1e-9 },
      ({ world, wheel }) => world.components.AngularVelocity.z[wheel],
    ),
  ],
  tryThis: ['Find the number of spokes at which the wheel seems to stand still or to turn backwards at some speed.'],
});
