// How fast a network of springs can oscillate, and the steps that follow it.
//
//   ω² <= max over springs of  S_a/m_a + S_b/m_b        S: sum of the stiffnesses at a node, m: its mass
//
// Gershgorin's bound of K x = ω² M x, whatever the directions of the springs: exact for a single spring and for a long
// chain. Dampings obey the same bound.
import type { Integrator, PhysicsWorld } from '../world/types.ts';

export interface NetworkSpring {
  readonly id: number;
  readonly a: number;
  readonly b: number;
  /** N/m. */
  readonly stiffness: number;
  /** N s/m. */
  readonly damping: number;
  /** Inverse masses of the ends, 1/kg; 0 for an anchor. */
  readonly inverseA: number;
  readonly inverseB: number;
}

/** Reads a spring between two bodies. */
export function networkSpring({ components }: PhysicsWorld, id: number, a: number, b: number): NetworkSpring {
  const { Spring, Mass } = components;
  const [stiffness, damping] = [Spring.stiffness[id], Spring.damping[id]];
  return { id, a, b, stiffness, damping, inverseA: inverseMass(Mass.value[a]), inverseB: inverseMass(Mass.value[b]) };
}

/** 1/kg; 0 for an anchor. */
export function inverseMass(mass: number): number {
  return mass > 0 ? 1 / mass : 0;
}

/** Bounds at each spring of a network: of ω², 1/s², and of γ, 1/s. */
export interface NetworkRates {
  readonly stiffness: Float64Array;
  readonly damping: Float64Array;
}

export function networkRates(network: readonly NetworkSpring[]): NetworkRates {
  const rows = network.reduce((most, { a, b }) => Math.max(most, a, b), 0) + 1;
  const [k, c] = [new Float64Array(rows), new Float64Array(rows)];
  for (const { a, b, stiffness, damping } of network) {
    k[a] += stiffness;
    k[b] += stiffness;
    c[a] += damping;
    c[b] += damping;
  }
  const boundsOf = (sums: Float64Array) =>
    Float64Array.from(network, ({ a, b, inverseA, inverseB }) => sums[a] * inverseA + sums[b] * inverseB);
  return { stiffness: boundsOf(k), damping: boundsOf(c) };
}

/** Returns a step, s, of at most `dt` with which the integrator keeps the whole network bounded, with two digits, rounded down. */
export function longestStep({ isStable }: Integrator, network: readonly NetworkSpring[], dt: number): number {
  let longest = dt;
  const rates = networkRates(network);
  for (let i = 0; i < network.length; i++) {
    const [stiffness, damping] = [rates.stiffness[i], rates.damping[i]];
    const isBounded = (step: number) => isStable?.(stiffness * step * step, damping * step) !== false;
    if (isBounded(longest)) continue;
    let [stable, unstable] = [0, longest];
    // As many halvings as a double has exponents that matter here: the stiffest spring takes steps of 1e-15 s.
    for (let n = 0; n < 80; n++) {
      const middle = (stable + unstable) / 2;
      if (isBounded(middle)) stable = middle;
      else unstable = middle;
    }
    longest = stable;
  }
  return longest < dt ? roundDown(longest) : longest;
}

/** Returns the largest number of two digits that is not above `value`. */
function roundDown(value: number): number {
  const [digits, exponent] = value.toExponential(1).split('e');
  const nearest = Number(`${digits}e${exponent}`);
  return nearest > value ? Number(`${(Number(digits) * 10 - 1) / 10}e${exponent}`) : nearest;
}
