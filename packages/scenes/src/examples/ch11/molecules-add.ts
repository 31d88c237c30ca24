import { createRandom, energy, keepState } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { addMolecule, GAS_ROOM, gasWorld } from '../support/gas.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const MAX_COUNT = 60;
/** Radius of a molecule that the reader places, px. */
const PLACED_RADIUS = 12;
/** Attempts to find a free place. */
const MAX_TRIES = 200;

export default defineExample({
  id: 'ch11-molecules-add',
  title: 'Blow gas into a box',
  chapter: 11,
  tags: ['collision', 'gas', 'energy'],
  about:
    'Every two seconds another molecule comes in, and you can add more yourself. The energy of the gas grows by exactly what each brings along, and by nothing else. The more there are, the sooner each meets the next.',
  duration: 60,
  parameters: {
    pause: { label: 'A new molecule every', unit: 's', initial: 2, min: 0.2, max: 10 },
    speed: { label: 'Largest speed', unit: 'px/s', initial: 40, min: 5, max: 200 },
  },
  presets: [{ label: 'Hot gas', values: { speed: 200 } }],
  build({ pause, speed }, { seed, ...options }) {
    const world = gasWorld({ capacity: MAX_COUNT + 8, ...options });
    const random = createRandom(seed);
    const gas = { ids: [] as number[], brought: 0, due: pause };
    keepState(world, random.state, gas);
    const { Collider } = world.components;
    const add = () => {
      if (gas.ids.length >= MAX_COUNT) return;
      const radius = random.uniform(5, 20);
      const velocity = { x: random.uniform(-speed, speed), y: random.uniform(-speed, speed) };
      for (let i = 0; i < MAX_TRIES; i++) {
        const at = { x: random.uniform(radius, 700 - radius), y: random.uniform(radius, 500 - radius) };
        if (gas.ids.some((id) => distanceBetween(positionOf(world, id), at) <= radius + Collider.radius[id] + 5))
          continue;
        gas.ids.push(addMolecule(world, at, velocity, radius));
        gas.brought += 0.005 * radius * radius * radius * (velocity.x * velocity.x + velocity.y * velocity.y);
        return;
      }
    };
    /** Adds one that the reader throws, unless it would be in a wall or in another one. */
    const place = (at: Point, velocity: Point) => {
      const { minX, maxX, minY, maxY } = GAS_ROOM;
      const isInside = Math.min(at.x - minX, maxX - at.x, at.y - minY, maxY - at.y) > PLACED_RADIUS;
      const isFree = gas.ids.every(
        (id) => distanceBetween(positionOf(world, id), at) > PLACED_RADIUS + Collider.radius[id],
      );
      if (gas.ids.length >= MAX_COUNT || !isInside || !isFree) return;
      const id = addMolecule(world, at, velocity, PLACED_RADIUS);
      gas.ids.push(id);
      gas.brought += (world.components.Mass.value[id] * (velocity.x * velocity.x + velocity.y * velocity.y)) / 2;
    };
    for (let i = 0; i < 5; i++) add();
    const dt = 1 / 60;
    world.phases.input.push(() => {
      if (world.time < gas.due - dt / 2) return;
      gas.due += pause;
      add();
    });
    return { world, dt, gas, add, place };
  },
  picture() {
    const { minX, maxX, minY, maxY } = GAS_ROOM;
    const corners = [
      { x: minX, y: minY },
      { x: maxX, y: minY },
      { x: maxX, y: maxY },
      { x: minX, y: maxY },
    ];
    return {
      view: { minX: -15, maxX: 715, minY: -15, maxY: 515 },
      lines: corners.map((from, i) => ({ from, to: corners[(i + 1) % 4], color: COLORS.grey })),
    };
  },
  actions: { action: { label: 'Add', about: 'add a molecule', key: 'a', press: ({ add }) => add() } },
  pointer: {
    about: 'place a molecule there, and throw it by a drag',
    aims: true,
    release: ({ place }, at, from) => place(from, { x: at.x - from.x, y: at.y - from.y }),
  },
  plots: (plot) => [
    plot(
      'Energies',
      'E, kg px²/s²',
      { label: 'of the gas', value: ({ world }) => energy(world).kinetic },
      { label: 'brought along', value: ({ gas }) => gas.brought },
    ),
    plot('Molecules', 'number', { label: 'in the box', value: ({ gas }) => gas.ids.length }),
  ],
  checks: ({ at }) => [
    at(
      30.5,
      'Molecules after 30.5 s: 5, and one every two seconds',
      { exact: 20, absolute: 0 },
      ({ gas }) => gas.ids.length,
    ),
    at(
      45,
      'Energy of the gas by what all molecules brought along',
      { exact: () => 1, relative: 1e-9 },
      ({ world, gas }) => energy(world).kinetic / gas.brought,
    ),
  ],
  tryThis: [
    'Hold the key that adds molecules until the box is full: it takes sixty.',
    'Press the picture and drag: a molecule flies off as you drew, a pixel a second for each pixel.',
    'Let them come every 0.2 s: the two lines of the first plot stay one.',
  ],
});
