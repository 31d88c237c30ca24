import { buoyancy, createPhysicsWorld, keepState, quadraticDrag, spawn, uniformGravity } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { atanh, tanh } from '../support/hyperbolic.ts';
import { positionOf, speedOf } from '../support/read.ts';

const GRAVITY = 10;
/** Air pushes up with a tenth of this, so that 9 N drive the fall. */
const AIR = 0.1;
const CLOSED = 0.01;
const X = 450;
const DT = 1 / 60;

type Values = ValuesOf<'opening' | 'growth'>;

/** Speed with the parachute closed. */
const closed = (t: number) => 30 * tanh(0.3 * t);
/** It opens at the beginning of a step. */
const stepOf = (opening: number) => Math.ceil((opening - 1e-6) / DT) * DT;
/** Speed after the opening: it falls towards 30/√growth. */
function speedAt(t: number, { opening: wanted, growth }: Values): number {
  const opening = stepOf(wanted);
  if (t <= opening) return closed(t);
  const terminal = 30 / Math.sqrt(growth);
  return terminal / tanh((9 / terminal) * (t - opening) + atanh(terminal / closed(opening)));
}

export default defineExample({
  id: 'ch07-parachute',
  title: 'A skydiver opens a parachute',
  chapter: 7,
  tags: ['drag', 'terminal speed', 'buoyancy'],
  about:
    'The skydiver falls faster until drag k v² balances the weight: at 30 px/s. Opening the parachute makes k nine times as large. Drag is then nine times the weight, brakes the fall hard, and the new balance is at a third of the speed.',
  duration: 50,
  ends: true,
  parameters: {
    opening: { label: 'It opens after', unit: 's', initial: 20, min: 5, max: 50 },
    growth: { label: 'Drag grows by', unit: '×', initial: 9, min: 2, max: 25 },
  },
  build({ opening, growth }, options) {
    const forces = [
      uniformGravity({ y: GRAVITY }),
      buoyancy({ density: AIR, gravity: { y: GRAVITY } }),
      quadraticDrag(),
    ];
    const world = createPhysicsWorld({ capacity: 4, forces, ...options });
    const diver = spawn(world, { position: { x: X, y: 50 }, mass: 1, hull: 1, quadraticDrag: CLOSED, collider: 10 });
    const parachute = { isOpen: false };
    keepState(world, parachute);
    const open = () => {
      parachute.isOpen = true;
      world.components.QuadraticDrag.coefficient[diver] = CLOSED * growth;
    };
    world.phases.input.push(() => {
      if (world.time > opening - 1e-6) open();
    });
    return { world, dt: DT, diver, parachute, open };
  },
  picture({ world, diver, parachute }, { growth }) {
    const at = () => positionOf(world, diver);
    const size = () => (parachute.isOpen ? 30 : 0);
    const rim = (x: number) => () => ({ x: at().x + x * size(), y: at().y - size() });
    const dome = [-1, -0.7, 0, 0.7, 1].map((x) => () => ({
      x: at().x + x * size(),
      y: at().y - size() * (1 + 0.8 * Math.sqrt(1 - x * x)),
    }));
    const drag = () => {
      const speed = speedOf(world, diver);
      return { x: 0, y: -CLOSED * (parachute.isOpen ? growth : 1) * speed * speed };
    };
    return {
      yDown: true,
      view: { minX: 0, maxX: 900, minY: 0, maxY: 900 },
      lines: [
        ...dome.slice(1).map((to, i) => ({ from: dome[i], to, width: 4, color: COLORS.orange })),
        ...[-1, -0.4, 0.4, 1].map((x) => ({ from: rim(x), to: at, width: 1 })),
      ],
      trails: [{ body: diver, length: 1500, interval: 2 }],
      arrows: [
        forceArrow(world, diver, 'weight', () => ({ x: 0, y: GRAVITY }), 8),
        { ...forceArrow(world, diver, 'drag', drag, 8), color: COLORS.yellow },
        velocityArrow(world, diver, 2),
      ],
    };
  },
  actions: { action: { label: 'Open', about: 'open the parachute', key: 'o', press: ({ open }) => open() } },
  pointer: 'action',
  plots: (plot) => [
    plot('Speed', 'v, px/s', { label: 'stepped', value: ({ world, diver }) => speedOf(world, diver), exact: speedAt }),
  ],
  checks: ({ at, largest }) => [
    at(5, 'Speed after 5 s, closed', { exact: 27.154, unit: 'px/s', relative: 1e-3 }, ({ world, diver }) =>
      speedOf(world, diver),
    ),
    largest(
      50,
      'Speed just before it opens',
      { exact: ({ opening }) => closed(stepOf(opening)), unit: 'px/s', relative: 1e-3 },
      ({ world, diver }) => speedOf(world, diver),
    ),
    at(
      21,
      'Speed after 21 s',
      { exact: (values) => speedAt(21, values), unit: 'px/s', relative: 1e-3 },
      ({ world, diver }) => speedOf(world, diver),
    ),
    at(
      50,
      'Speed with the open parachute',
      { exact: (values) => speedAt(50, values), unit: 'px/s', relative: 1e-3 },
      ({ world, diver }) => speedOf(world, diver),
    ),
  ],
  tryThis: [
    'Let the drag grow by 4 instead of 9: the final speed is a half of 30 instead of a third, because it falls with the root of the drag.',
    'Open it yourself within the first second: the drag never exceeds the weight, and there is no jerk.',
  ],
});
