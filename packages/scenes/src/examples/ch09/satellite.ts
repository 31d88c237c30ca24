import { atan2, createPhysicsWorld, gaussRadau, powerLaw, rgba, sin, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const EARTH = { x: 400, y: 300 };
const DISTANCE = 200;

export default defineExample({
  id: 'ch09-satellite',
  title: 'A satellite above always the same place',
  chapter: 9,
  tags: ['circular motion', 'rotation', 'satellite'],
  about:
    'The satellite goes round exactly as fast as the Earth turns. Seen from the ground it stands still in the sky, and a dish that points at it need not move. Television satellites do this, 36 000 km high.',
  duration: 40,
  parameters: {
    spin: { label: 'Earth turns with', unit: 'rad/s', initial: 0.4, min: 0.1, max: 1 },
    ratio: { label: 'Satellite, in turns of the Earth', unit: '×', initial: 1, min: 0.5, max: 2 },
  },
  presets: [{ label: 'Twice as fast', values: { ratio: 2 } }],
  build({ spin, ratio }, { integrator = gaussRadau() }) {
    const omega = spin * ratio;
    const circle = powerLaw({ strength: -omega * omega, exponent: 1, centre: EARTH });
    const world = createPhysicsWorld({ capacity: 5, forces: [circle], integrator });
    const earth = spawn(world, {
      position: EARTH,
      velocity: {},
      rotation: 0,
      angularVelocity: spin,
      appearance: { size: 70, shape: 3, color: rgba(0.25, 0.5, 0.95) },
    });
    const satellite = spawn(world, {
      position: { x: EARTH.x + DISTANCE, y: EARTH.y },
      velocity: { y: omega * DISTANCE },
      mass: 1,
      appearance: { size: 9, shape: 2, color: rgba(1, 0.85, 0.4) },
    });
    const direction = () => {
      const { x, y } = positionOf(world, satellite);
      return atan2(y - EARTH.y, x - EARTH.x);
    };
    const aside = () => sin(direction() - world.components.Rotation.angle[earth]);
    return { world, dt: 1 / 60, satellite, aside };
  },
  picture({ world, satellite }) {
    return {
      view: { minX: 130, maxX: 670, minY: 60, maxY: 540 },
      lines: [{ from: EARTH, to: () => positionOf(world, satellite), color: COLORS.ground, width: 1 }],
      trails: [{ body: satellite, length: 500, interval: 2 }],
      arrows: [velocityArrow(world, satellite, 0.7)],
    };
  },
  plots: (plot) => [
    plot('Seen from the ground: sine of the angle from overhead', 'sine', {
      label: 'satellite',
      value: ({ aside }) => aside(),
    }),
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Period, 2π/ω',
      unit: 's',
      exact: ({ spin, ratio }) => (2 * Math.PI) / (spin * ratio),
      tolerance: { relative: 1e-6 },
      at: { event: ({ world, satellite }) => positionOf(world, satellite).y - EARTH.y, from: 1, to: 2 },
    },
    largest(40, 'Largest deviation from overhead in 40 s', { exact: 0, unit: 'rad', absolute: 1e-12 }, ({ aside }) =>
      Math.abs(aside()),
    ),
    at(40, 'Distance after 40 s', { exact: DISTANCE, unit: 'px', relative: 1e-9 }, ({ world, satellite }) =>
      distanceBetween(positionOf(world, satellite), EARTH),
    ),
  ],
  tryThis: [
    'Watch the mark on the Earth: it points at the satellite all the time.',
    'Choose “Twice as fast”: the satellite rises and sets for somebody on the ground.',
  ],
});
