// Warnings about springs that do nothing, and about networks of springs that steps cannot follow.
import { bitOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import { longestStep, type NetworkSpring, networkRates, networkSpring } from '../math/spring-network.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { firstRow } from './first-row.ts';

export function warnAboutSprings(world: PhysicsWorld, dt: number): void {
  if (world.internal.counts.Spring === 0) return;
  const isSolved =
    world.integrator.solvesSprings === true || world.forces.some(({ name }) => name.startsWith('springs'));
  if (!isSolved) {
    warnOnce(world, {
      message: 'Spring has no effect, because neither a force nor the integrator of this world solves springs.',
      hint: 'Add springs() to `forces`, or take the integrator xpbd() for springs of any stiffness.',
    });
  }
  warnAboutStiffNetworks(world, dt);
  if (world.internal.breaksSprings || firstRow(world, (id) => world.components.Spring.breakForce[id] > 0) === 0) return;
  warnOnce(world, {
    message: 'springs with a `breakForce` do not break, because no system of this world breaks springs.',
    hint: 'Add the system: world.phases.finish.push(breakSprings).',
  });
}

const KEY = 'stiff network';

/** The step, s, and the sum of all rates, with which the network of a world was last found to be calm. */
const calm = new WeakMap<PhysicsWorld, { readonly sum: number; readonly dt: number }>();

/**
 * The force `springs` refuses each spring that is too stiff for the step by itself. A network of them oscillates faster: by how
 * much depends on where its nodes are. So a network above the bound that holds everywhere is looked at as it is now.
 */
function warnAboutStiffNetworks(world: PhysicsWorld, dt: number): void {
  const { isStable, solvesSprings, solvesWalls } = world.integrator;
  if (isStable === undefined || solvesSprings === true || !world.forces.some(({ name }) => name === 'springs')) return;
  if (world.internal.warned.has(KEY)) return;
  const network = listNetwork(world);
  const rates = networkRates(network);
  if (rates.stiffness.every((each, i) => isStable(each * dt * dt, rates.damping[i] * dt))) return;
  // Where springs tear, or other bodies come and go, it is not looked at again.
  const sum = rates.stiffness.reduce((a, b) => a + b, 0) + rates.damping.reduce((a, b) => a + b, 0);
  const before = calm.get(world);
  if (before !== undefined && sum <= before.sum && dt <= before.dt) return;
  const { node, stiffness, damping } = fastestMode(world, network, dt);
  if (isStable(stiffness * dt * dt, damping * dt)) {
    calm.set(world, { sum, dt });
    return;
  }
  const other = solvesWalls === true ? 'more sub-steps or joints with springs' : 'the integrator xpbd()';
  const warning = {
    message: `the springs around body ${node} are together too stiff or too strongly damped for steps of ${dt} s, though each by itself is not: they gain energy without bound.`,
    hint: `Use steps of at most ${longestStep(world.integrator, network, dt)} s, softer springs, heavier bodies or ${other}.`,
  };
  warnOnce(world, warning, KEY);
}

/** A string is slack where it is shorter than this part of its length. */
const TAUT = 0.999;

/** Lists the springs that act: those with two living ends, and of strings those that are not slack. */
function listNetwork(world: PhysicsWorld): NetworkSpring[] {
  const { Spring } = world.components;
  const { members, generations } = world.internal;
  const [spring, position] = [bitOf('Spring'), bitOf('Position')];
  const isAlive = (id: number, generation: number) =>
    id > 0 && id < world.rows && (members[id] & position) !== 0 && generations[id] === generation;
  const network: NetworkSpring[] = [];
  for (let id = 1; id <= world.lastId; id++) {
    if ((members[id] & spring) === 0) continue;
    const [a, b] = [Spring.a[id], Spring.b[id]];
    if (a === b || !isAlive(a, Spring.aGeneration[id]) || !isAlive(b, Spring.bGeneration[id])) continue;
    if (Spring.tensionOnly[id] !== 0 && lengthBetween(world, a, b) < TAUT * Spring.length[id]) continue;
    network.push(networkSpring(world, id, a, b));
  }
  return network;
}

function lengthBetween({ components }: PhysicsWorld, a: number, b: number): number {
  const { x, y, z } = components.Position;
  const [dx, dy, dz] = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}

interface Mode {
  /** The body that moves most. */
  readonly node: number;
  /** ω², 1/s². */
  readonly stiffness: number;
  /** γ, 1/s. */
  readonly damping: number;
}

/** Within a few per cent of the fastest oscillation, for networks of any size. */
const ITERATIONS = 40;

/**
 * Finds the oscillation that steps lose first, by power iteration: the largest eigenvalue of K dt² + 2 C dt in a small displacement,
 * scaled by the roots of the masses. Its Rayleigh quotients are never above the truth.
 */
function fastestMode(world: PhysicsWorld, network: readonly NetworkSpring[], dt: number): Mode {
  const { gradients, pushes } = linearize(world, network, dt);
  let now = noise(3 * (world.lastId + 1));
  let next = new Float64Array(now.length);
  for (let n = 0; n < ITERATIONS; n++) {
    normalize(now);
    next.fill(0);
    network.forEach(({ a, b }, i) => {
      const push = pushes[i] * stretchOf(gradients, now, i, a, b);
      for (let k = 0; k < 3; k++) {
        next[3 * a + k] += push * gradients[6 * i + k];
        next[3 * b + k] += push * gradients[6 * i + 3 + k];
      }
    });
    [now, next] = [next, now];
  }
  normalize(now);
  let [stiffness, damping] = [0, 0];
  network.forEach((spring, i) => {
    const stretch = stretchOf(gradients, now, i, spring.a, spring.b);
    stiffness += spring.stiffness * stretch * stretch;
    damping += spring.damping * stretch * stretch;
  });
  return { node: mostMoved(now), stiffness, damping };
}

/** The derivatives of the length of each spring with respect to its ends, over the roots of their masses, and its k dt² + 2 c dt. */
function linearize(world: PhysicsWorld, network: readonly NetworkSpring[], dt: number) {
  const gradients = new Float64Array(6 * network.length);
  const { x, y, z } = world.components.Position;
  network.forEach(({ a, b, inverseA, inverseB }, i) => {
    const d = lengthBetween(world, a, b);
    const direction = d > 0 ? [(x[b] - x[a]) / d, (y[b] - y[a]) / d, (z[b] - z[a]) / d] : [1, 0, 0];
    for (let k = 0; k < 3; k++) {
      gradients[6 * i + k] = -Math.sqrt(inverseA) * direction[k];
      gradients[6 * i + 3 + k] = Math.sqrt(inverseB) * direction[k];
    }
  });
  const pushes = Float64Array.from(network, ({ stiffness, damping }) => (stiffness * dt + 2 * damping) * dt);
  return { gradients, pushes };
}

function stretchOf(gradients: Float64Array, at: Float64Array, spring: number, a: number, b: number): number {
  let stretch = 0;
  for (let k = 0; k < 3; k++) {
    stretch += gradients[6 * spring + k] * at[3 * a + k] + gradients[6 * spring + 3 + k] * at[3 * b + k];
  }
  return stretch;
}

/** Returns numbers from -1 to 1 without a pattern, always the same. */
function noise(length: number) {
  let seed = 1;
  return Float64Array.from({ length }, () => {
    seed = (Math.imul(seed, 1664525) + 1013904223) | 0;
    return seed / 0x80000000;
  });
}

function normalize(vector: Float64Array): void {
  let square = 0;
  for (const value of vector) square += value * value;
  const scale = square > 0 ? 1 / Math.sqrt(square) : 0;
  for (let i = 0; i < vector.length; i++) vector[i] *= scale;
}

function mostMoved(vector: Float64Array): number {
  let [body, most] = [0, 0];
  vector.forEach((value, i) => {
    if (Math.abs(value) > most) [body, most] = [Math.floor(i / 3), Math.abs(value)];
  });
  return body;
}
