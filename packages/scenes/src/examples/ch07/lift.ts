import { cos, createPhysicsWorld, lift, rgba, rungeKutta4, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { positionOf, speedOf, velocityOf } from '../support/read.ts';

export default defineExample({
  id: 'ch07-lift',
  title: 'Lift alone flies a loop',
  chapter: 7,
  tags: ['lift', 'circular motion'],
  about:
    'Lift acts at right angles to the flight, and grows with the square of the speed: k v². Without weight and drag a glider with a fixed wing flies a circle. Its radius m/k does not depend on the speed, because a circle too needs a force that grows as v².',
  duration: 12,
  parameters: {
    wing: { label: 'Lift coefficient k', unit: 'kg/m', initial: 0.5, min: 0.1, max: 1 },
    speed: { label: 'Speed', unit: 'm/s', initial: 10, min: 1, max: 20 },
    mass: { label: 'Mass', unit: 'kg', initial: 1, min: 0.5, max: 2 },
  },
  presets: [{ label: 'Half as fast', values: { speed: 5 } }],
  build({ wing, speed, mass }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [lift()], integrator });
    const appearance = { size: 0.15, color: rgba(0.5, 0.8, 1) };
    const glider = spawn(world, { position: {}, velocity: { x: speed }, mass, lift: wing, appearance });
    /** Curvature of the path times m v²: the force across it, from where the glider is on its circle. */
    const across = () => {
      const { x, y } = positionOf(world, glider);
      const radius = (x * x + y * y) / (2 * y);
      return (mass * speedOf(world, glider) * speedOf(world, glider)) / radius;
    };
    return { world, dt: 1 / 960, glider, across };
  },
  picture({ world, glider }, { wing, mass }) {
    const radius = mass / wing;
    const circle = (a: number) => ({ x: radius * sin(a), y: radius * (1 - cos(a)) });
    const force = () => {
      const [{ x, y }, speed] = [velocityOf(world, glider), speedOf(world, glider)];
      return { x: -wing * speed * y, y: wing * speed * x };
    };
    return {
      view: { minX: -1.6 * radius, maxX: 1.6 * radius, minY: -0.5 * radius, maxY: 2.5 * radius },
      curves: [{ points: pointsOf(circle, 0, 2 * Math.PI), color: COLORS.ground, dashed: true, label: 'radius m/k' }],
      trails: [{ body: glider, length: 300, interval: 4 }],
      arrows: [forceArrow(world, glider, 'lift', force, 0.02), velocityArrow(world, glider, 0.08)],
    };
  },
  plots: (plot) => [
    plot('Height', 'y, m', {
      label: 'stepped',
      value: ({ world, glider }) => positionOf(world, glider).y,
      exact: (t, { wing, speed, mass }) => (mass / wing) * (1 - cos((wing * speed * t) / mass)),
    }),
  ],
  checks: ({ at, largest }) => [
    at(
      0.5,
      'Lift after 0.5 s, from the curve of the path: k v²',
      {
        exact: ({ wing, speed }) => wing * speed * speed,
        // Where it is back at the start, a place tells nothing of its circle.
        holds: ({ wing, speed, mass }) => cos((wing * speed) / (2 * mass)) < 0.9 || wing * speed < mass,
        unit: 'N',
        relative: 1e-6,
      },
      ({ across }) => across(),
    ),
    at(
      10,
      'Speed after 10 s: lift does no work',
      { exact: ({ speed }) => speed, unit: 'm/s', relative: 1e-6 },
      ({ world, glider }) => speedOf(world, glider),
    ),
    largest(
      10,
      'Diameter of the loop, 2 m/k',
      {
        exact: ({ wing, mass }) => (2 * mass) / wing,
        // It has flown half of the loop by then.
        holds: ({ wing, speed, mass }) => (10 * speed * wing) / mass >= Math.PI,
        unit: 'm',
        relative: 1e-3,
      },
      ({ world, glider }) => positionOf(world, glider).y,
    ),
  ],
  tryThis: [
    'Choose “Half as fast”: the loop is the same, and takes twice as long.',
    'Double k: the loop becomes half as wide.',
  ],
});
