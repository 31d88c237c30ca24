import { createRandom, energy, keepState, wallContacts } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { addMolecule, GAS_ROOM, gasWorld } from '../support/gas.ts';
import { distanceBetween, positionOf, speedOf } from '../support/read.ts';

const MAX_COUNT = 150;
/** Length of the walls, px, and the area between them, px². */
const [PERIMETER, AREA] = [2 * (700 + 500), 700 * 500];

export default defineExample({
  id: 'ch11-molecules',
  title: 'A gas of hard balls',
  chapter: 11,
  tags: ['collision', 'gas', 'temperature', 'energy'],
  about:
    'Balls of different mass fly about in a box and hit each other and the walls, without loss. The heavy ones become slow and the light ones fast, until on average each has the same energy. That average is what we call temperature, and it is the same for all kinds of molecules in a gas.',
  duration: 300,
  parameters: {
    count: { label: 'Molecules', initial: 10, min: 2, max: MAX_COUNT, integer: true },
    speed: { label: 'Largest speed at the start', unit: 'px/s', initial: 50, min: 5, max: 200 },
    size: { label: 'Size of the molecules', unit: '×', initial: 1, min: 0.1, max: 1 },
  },
  presets: [
    { label: 'A hundred molecules', values: { count: 100, speed: 200 } },
    { label: 'A nearly ideal gas', values: { count: 150, speed: 200, size: 0.1 } },
  ],
  build({ count, speed, size }, { seed, ...options }) {
    const world = gasWorld({ capacity: MAX_COUNT + 8, ...options });
    const random = createRandom(seed);
    const draw = () => random.uniform(-speed, speed);
    const ids: number[] = [];
    while (ids.length < count) {
      // Half of the molecules are light, the others heavy, and none starts in another.
      const radius = size * (ids.length % 2 === 0 ? random.uniform(5, 9) : random.uniform(12, count > 40 ? 16 : 25));
      const at = { x: random.uniform(radius, 700 - radius), y: random.uniform(radius, 500 - radius) };
      const { radius: radii } = world.components.Collider;
      const isFree = ids.every((id) => distanceBetween(positionOf(world, id), at) > radius + radii[id]);
      if (isFree) ids.push(addMolecule(world, at, { x: draw(), y: draw() }, radius));
    }
    const { Mass } = world.components;
    const kinetic = (id: number) => (Mass.value[id] * speedOf(world, id) * speedOf(world, id)) / 2;
    /** Mean energy of the light (0) or heavy (1) molecules. */
    const mean = (parity: number) => {
      const half = ids.filter((_, i) => i % 2 === parity);
      return half.reduce((sum, id) => sum + kinetic(id), 0) / half.length;
    };
    const overlap = () => {
      const { radius } = world.components.Collider;
      let worst = 0;
      for (const [i, a] of ids.entries()) {
        for (const b of ids.slice(i + 1)) {
          const gap = distanceBetween(positionOf(world, a), positionOf(world, b)) - radius[a] - radius[b];
          worst = Math.max(worst, -gap);
        }
      }
      return worst;
    };
    const start = energy(world).kinetic;
    // What the walls have pushed so far, N s; the pressure is that by their length and the time.
    const walls = { impulse: 0 };
    keepState(world, walls);
    world.phases.events.push(() => {
      const { count: hits, impulse } = wallContacts(world);
      for (let i = 0; i < hits; i++) walls.impulse += impulse[i];
    });
    const pressure = () => walls.impulse / (PERIMETER * Math.max(world.time, 1 / 60));
    return { world, dt: 1 / 60, ids, mean, overlap, pressure, start };
  },
  picture({ ids }) {
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
      trails: [{ body: ids[0], length: 400, color: COLORS.yellow }],
    };
  },
  plots: (plot) => [
    plot(
      'Mean energy',
      'E, kg px²/s²',
      { label: 'light', value: ({ mean }) => mean(0) },
      { label: 'heavy', value: ({ mean }) => mean(1) },
    ),
  ],
  checks: ({ at, largest, mean }) => [
    at(
      60,
      'Change of the whole energy in 60 s',
      { exact: 0, absolute: 1e-9 },
      ({ world, start }) => energy(world).kinetic / start - 1,
    ),
    largest(60, 'Deepest overlap in 60 s', { exact: 0, unit: 'px', absolute: 1 }, ({ overlap }) => overlap()),
    mean(
      300,
      'Mean energy of the light ones by that of all, over 300 s',
      { exact: 1, relative: 0.1, preset: 'A hundred molecules' },
      ({ mean }) => (2 * mean(0)) / (mean(0) + mean(1)),
    ),
    // In two dimensions k T is the mean energy of a molecule, so that N k T is the energy of all.
    at(
      300,
      'Pressure on the walls in 300 s by N k T/A',
      { exact: 1, relative: 0.05, preset: 'A nearly ideal gas' },
      ({ pressure, start }) => (pressure() * AREA) / start,
    ),
  ],
  tryThis: [
    'Follow the yellow trail: a molecule moves in straight lines from one collision to the next, and never knows where it goes.',
    'Choose “A hundred molecules”: the two lines of the plot meet within seconds.',
  ],
});
