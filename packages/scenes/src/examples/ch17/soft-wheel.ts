import {
  cos,
  createPhysicsWorld,
  createSoftBody,
  planeWalls,
  rgba,
  semiImplicitEuler,
  sin,
  spawn,
  springs,
  uniformGravity,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'slope' | 'pressure' | 'friction'>;

const [GRAVITY, RADIUS, MASS] = [9.81, 1, 20];
/** Nodes of the skin, radius of a node, m, and stiffness of the spring between two, N/m. */
const [NODES, NODE, STIFFNESS] = [64, 0.03, 40_000];
const RADIANS = Math.PI / 180;
/** By which one sees that it turns. */
const COLOURS = Array.from({ length: NODES }, (_, i) => (i % 8 < 4 ? rgba(0.43, 0.72, 1) : rgba(1, 0.7, 0.28)));
/** How long the wheel rolls, s. */
const TIME = 4;

/** A thin ring that rolls has as much energy in its rotation as in its motion, so half of the slope's pull is left. */
const rolled = (slope: number) => (GRAVITY * sin(RADIANS * slope) * TIME * TIME) / 4;
const slid = (slope: number, friction: number) =>
  (GRAVITY * (sin(RADIANS * slope) - friction * cos(RADIANS * slope)) * TIME * TIME) / 2;

export default defineExample({
  id: 'ch17-soft-wheel',
  title: 'A soft wheel',
  chapter: 17,
  tags: ['soft bodies', 'spring', 'rolling', 'friction', 'gas'],
  about:
    'A rubber skin full of air rolls down a slope. Where it touches the ground it is flat, and the air pushes the rest round. Whether it is hard or soft: a ring that rolls without slipping gets half the acceleration of a block that slides without friction. The point of the skin that is followed draws a cycloid.',
  duration: TIME,
  ends: true,
  parameters: {
    slope: { label: 'Slope', unit: '°', initial: 10, min: 0, max: 30 },
    pressure: { label: 'Pressure of the air', unit: 'N/m', initial: 2000, min: 200, max: 3500 },
    friction: { label: 'Coefficient of friction', initial: 0.8, min: 0, max: 1 },
  },
  presets: [
    { label: 'On ice', values: { friction: 0.05 } },
    { label: 'Nearly flat', values: { pressure: 300 } },
  ],
  build({ slope, pressure, friction }: Values, { integrator = semiImplicitEuler }: BuildOptions) {
    const [s, c] = [sin(RADIANS * slope), cos(RADIANS * slope)];
    const forces = [uniformGravity({ y: -GRAVITY }), springs()];
    const world = createPhysicsWorld({ capacity: 300, forces, walls: [planeWalls], integrator });
    spawn(world, { planeWall: { nx: s, ny: c, offset: 0, friction } });
    const { nodes, springs: skin } = createSoftBody(world, {
      centre: { x: s * (RADIUS + NODE), y: c * (RADIUS + NODE) },
      radius: RADIUS,
      detail: NODES,
      mass: MASS,
      stiffness: STIFFNESS,
      damping: 60,
      pressure,
      components: { collider: { radius: NODE, friction, restitution: 0 }, appearance: { color: COLOURS } },
    });
    // The skin is stretched as far as the air needs: the gas pushes a node outwards by p L cos(π/N), two springs hold it.
    const stretch = (pressure * RADIUS * cos(Math.PI / NODES)) / STIFFNESS;
    for (const id of skin) world.components.Spring.length[id] -= stretch;
    const mean = (value: (id: number) => number) => nodes.reduce((sum, id) => sum + value(id), 0) / NODES;
    const downhill = ({ x, y }: { x: number; y: number }) => c * x - s * y;
    const distance = () => mean((id) => downhill(positionOf(world, id)));
    const speed = () => mean((id) => downhill(velocityOf(world, id)));
    return { world, dt: 1 / 960, nodes, distance, speed };
  },
  picture({ nodes }, { slope }) {
    const [s, c] = [sin(RADIANS * slope), cos(RADIANS * slope)];
    const [far, deep] = [60, 40];
    return {
      view: { minX: -2.5, maxX: 10, minY: -3.5, maxY: 3.5 },
      fills: [
        {
          shape: [
            { x: -far * c, y: far * s },
            { x: far * c, y: -far * s },
            { x: far * c, y: -far * s - deep },
            { x: -far * c, y: -far * s - deep },
          ],
          color: COLORS.ground,
        },
      ],
      springs: 'lines',
      trails: [{ body: nodes[NODES / 2], length: 600, interval: 8, color: COLORS.yellow }],
    };
  },
  plots: (plot) => [
    plot('Speed of the wheel', 'v, m/s', {
      label: 'computed',
      value: ({ speed }) => speed(),
      exact: (time, { slope, friction }) => (2 * time * Math.max(rolled(slope), slid(slope, friction))) / (TIME * TIME),
    }),
  ],
  checks: ({ at }) => [
    // The skin is a polygon of 64 corners and damped: a per cent of the energy stays on the way.
    at(TIME, 'Distance down in 4 s, g sin θ t²/4', { exact: rolled(10), unit: 'm', relative: 0.015 }, ({ distance }) =>
      distance(),
    ),
    at(
      TIME,
      'Distance down in 4 s on ice, g (sin θ − μ cos θ) t²/2',
      { exact: slid(10, 0.05), unit: 'm', relative: 5e-3, preset: 'On ice' },
      ({ distance }) => distance(),
    ),
    at(
      TIME,
      'Distance down in 4 s of a wheel that is nearly flat',
      { exact: rolled(10), unit: 'm', relative: 0.015, preset: 'Nearly flat' },
      ({ distance }) => distance(),
    ),
  ],
  tryThis: [
    'Choose “On ice”: with a coefficient of friction below tan θ/2 = 0.09 the wheel slides, and turns hardly at all.',
    'Let air out down to 200 N/m: the wheel is a bag that bulges at both sides, and rolls as fast.',
    'Follow the bright point: each arch of its cycloid begins and ends at rest on the ground.',
  ],
});
