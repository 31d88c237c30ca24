// A net stretched between two posts and struck: springs along the meshes, free nodes with random velocities. Without
// damping its energy stays what it is.
import { createPhysicsWorld, semiImplicitEuler, spawnMany, springs as springForces } from '@principia/physics';
import { countOf, defineScene, type Setup } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Edge of a mesh, m. */
const MESH = 0.1;
/** Natural length of a spring by the edge of a mesh: the net is taut. */
const SLACK = 0.8;

/** A net of springs stretched between two posts and struck. */
export const springs = defineScene({
  name: 'springs',
  description: 'a net of springs stretched between two posts and struck',
  precision: 'f32',
  parameters: {
    count: countOf('springs', 100_000, 4_000_000),
    stiffness: { about: 'stiffness of a spring', unit: 'N/m', initial: 50, min: 0, max: 500 },
    damping: { about: 'damping of a spring', unit: 'N s/m', initial: 0, min: 0, max: 0.5 },
    mass: { about: 'mass of a node', unit: 'kg', initial: 0.01, min: 0.01, max: 1000 },
    speed: { about: 'largest initial speed of a node along an axis', unit: 'm/s', initial: 0.5, min: 0, max: 10 },
  },
  build(setup) {
    const { dimensions, precision, seed, parameters } = setup;
    const net = meshes(parameters.count);
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: net.nodes + parameters.count,
      integrator: semiImplicitEuler,
      forces: [springForces()],
    });
    const ids = spawnNodes(world, net, setup);
    const { stiffness, damping, count } = parameters;
    const end = (nodes: Uint32Array) => nodes.map((node) => ids[node]);
    spawnMany(
      world,
      count,
      { spring: { a: end(net.a), b: end(net.b), stiffness, damping, length: SLACK * MESH } },
      setup.progress,
    );
    const loses = damping > 0 ? { losesEnergy: 'the springs are damped' } : {};
    return { world, dt: 1 / 480, ...loses };
  },
});

interface Net {
  /** Nodes of a row. */
  readonly width: number;
  readonly nodes: number;
  /** Nodes each spring joins. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
}

/** Row by row, each node joined to the one before it and the one above it, until there are `count` springs. */
function meshes(count: number): Net {
  const width = Math.max(3, Math.ceil(Math.sqrt(count / 2)) + 1);
  const a = new Uint32Array(count);
  const b = new Uint32Array(count);
  let node = 0;
  for (let made = 0; made < count; node++) {
    if (node % width > 0 && made < count) {
      a[made] = node - 1;
      b[made++] = node;
    }
    if (node >= width && made < count) {
      a[made] = node - width;
      b[made++] = node;
    }
  }
  return { width, nodes: node, a, b };
}

/** Makes the bodies, the two outer columns without mass because the posts hold them; returns the id of each node. */
function spawnNodes(
  world: ReturnType<typeof createPhysicsWorld>,
  { width, nodes }: Net,
  { dimensions, seed, parameters }: Setup<'mass' | 'speed'>,
): Uint32Array {
  const isHeld = (node: number) => node % width === 0 || node % width === width - 1;
  const all = Array.from({ length: nodes }, (_, node) => node);
  const held = all.filter(isHeld);
  const free = all.filter((node) => !isHeld(node));
  const place = (list: readonly number[]) => ({
    x: Float64Array.from(list, (node) => (node % width) * MESH),
    y: Float64Array.from(list, (node) => -Math.floor(node / width) * MESH),
  });
  const uniform = seededUniforms(seed, free.length);
  const push = () => uniform(-parameters.speed, parameters.speed);
  const ids = new Uint32Array(nodes);
  const heldIds = spawnMany(world, held.length, { position: place(held), velocity: {} });
  const freeIds = spawnMany(world, free.length, {
    position: place(free),
    velocity: { x: push(), y: push(), ...(dimensions === 3 ? { z: push() } : {}) },
    mass: parameters.mass,
  });
  held.forEach((node, i) => {
    ids[node] = heldIds[i];
  });
  free.forEach((node, i) => {
    ids[node] = freeIds[i];
  });
  return ids;
}
