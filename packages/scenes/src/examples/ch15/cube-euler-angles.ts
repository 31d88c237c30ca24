import { cos, exp, powerLaw, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf } from '../support/read.ts';
import { point } from '../support/space.ts';
import { cubeLines, turningCube } from '../support/turning-cube.ts';

const CENTRE = { x: 0, y: 0, z: -500 };
type Values = ValuesOf<'stiffness' | 'torque'>;

export default defineExample({
  id: 'ch15-cube-euler-angles',
  title: 'A cube that swings and turns',
  chapter: 15,
  tags: ['3D', 'rotation', 'spring'],
  about:
    'A spring pulls the cube into the depth and back, and a torque turns it at the same time. Neither motion knows of the other: forces move the centre, torques turn the body about it. The cube swings with the period 2π √(m/k) and spins up as if it stood still.',
  dimensions: 3,
  duration: 30,
  parameters: {
    stiffness: { label: 'Stiffness of the spring', unit: 'N/m', initial: 0.2, min: 0.05, max: 1 },
    torque: { label: 'Torque', unit: 'N m', initial: 1, min: 0, max: 3 },
  },
  presets: [{ label: 'Swing only', values: { torque: 0 } }],
  build({ stiffness, torque }: Values, { integrator = velocityVerlet }: BuildOptions) {
    const forces = [powerLaw({ strength: -stiffness, exponent: 1, centre: CENTRE })];
    return turningCube({ torque: { x: torque, y: 0 }, drag: 0.5, inertia: 1, pushTime: 1e6, forces, integrator });
  },
  picture: (run) => ({
    view: { minX: -180, maxX: 180, minY: -130, maxY: 130, minZ: -1050, maxZ: 60 },
    camera: { eye: point(500, 260, 700), target: point(0, 0, -500) },
    lines: [
      ...cubeLines(run),
      { from: point(0, 0, -1000), to: point(0, 0, 0), color: COLORS.ground },
      { from: () => CENTRE, to: () => positionOf(run.world, run.cube), color: COLORS.yellow },
    ],
    dots: [{ at: CENTRE, color: COLORS.white }],
  }),
  plots: (plot) => [
    plot('Place in the depth', 'z, px', {
      label: 'stepped',
      value: ({ world, cube }) => positionOf(world, cube).z,
      exact: (t, { stiffness }) => -500 + 500 * cos(Math.sqrt(stiffness) * t),
    }),
    plot('Angular velocity', 'ω, rad/s', {
      label: 'stepped',
      value: ({ world, cube }) => world.components.AngularVelocity.x[cube],
      exact: (t, { torque }) => 2 * torque * (1 - exp(-t / 2)),
    }),
  ],
  checks: ({ at }) => [
    {
      label: 'Period of the swing, 2π √(m/k)',
      unit: 's',
      exact: ({ stiffness }) => (2 * Math.PI) / Math.sqrt(stiffness),
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, cube }) => positionOf(world, cube).z + 500, from: 1, to: 2 },
    },
    at(
      30,
      'Angular velocity in the end, τ/k',
      { exact: ({ torque }) => 2 * torque, unit: 'rad/s', absolute: 1e-4 },
      ({ world, cube }) => world.components.AngularVelocity.x[cube],
    ),
    at(
      2,
      'Angular velocity after 2 s, 63 % of that',
      { exact: ({ torque }) => 2 * torque * (1 - exp(-1)), unit: 'rad/s', relative: 1e-3 },
      ({ world, cube }) => world.components.AngularVelocity.x[cube],
    ),
  ],
  tryThis: [
    'Take the torque away: the swing stays exactly as it was.',
    'Make the spring five times as stiff: the cube swings √5 = 2.2 times as fast.',
  ],
});
