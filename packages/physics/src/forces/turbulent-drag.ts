// Drag in turbulent wind: eddies of many sizes that drift and change, independent of the frame rate.
//
//   F = -(c + k |w|) w,   w = v - u(r, t)        u = mean + Σ aⱼ cos(2π (κⱼ·r + φⱼ + νⱼ t)),   aⱼ ⊥ κⱼ
//
//   c  LinearDrag, kg/s    k  QuadraticDrag, kg/m    u  velocity of the air, m/s
//   κⱼ  wave vector, 1/m   aⱼ  amplitude, m/s    νⱼ  frequency, Hz    φⱼ  phase
//
// Every mode is a transverse wave, so u is free of divergence. Wave numbers form a geometric series from 1/largest to
// 1/smallest eddy with the energies of Kolmogorov's spectrum (aⱼ² ∝ κ^(-2/3) per band), frequencies scale as κ^(2/3),
// and directions, signs and phases come from the seed: Kraichnan, Phys. Fluids 13, 22 (1970); Fung et al., J. Fluid
// Mech. 236, 281 (1992). Directions are drawn at random, then stretched alike, by 1/√modes or so, until the mean square of
// each component is that of the deviation over wide spaces, for any seed, unless fewer than some ten modes share the
// energy. u is a function of position and time, so its statistics cannot depend on the step. List no
// other drag with it. Each mode takes 64 bytes of a world's memory, once. Cost: about 30 operations per body and
// mode, and one square root per body.
import { LinearDrag, QuadraticDrag } from '../components/drag.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkNumber, checkWhole } from '../errors/validate.ts';
import { constant, type Scalar, vec3 } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import { type TableLocation, table } from '../laws/table.ts';
import { cos, pow, sin } from '../math/elementary.ts';
import { createRandom, type Random } from '../math/random.ts';
import { forceMemory, type TakeBytes } from '../memory/force-memory.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { LENGTH_BOUNDS } from './support/bounds.ts';
import { type Wind, windParameter } from './support/wind.ts';

/** Options of `turbulentDrag`. */
export interface TurbulenceOptions {
  /** Mean wind, m/s; default zero. */
  readonly mean?: Wind;
  /** Standard deviation of each component of the wind, m/s, over wide spaces. */
  readonly deviation: number;
  /** Size of the largest eddies, m. */
  readonly largest: number;
  /** Size of the smallest, m; default a thirtieth of the largest. */
  readonly smallest?: number;
  /** Time scale of the largest eddies, s; default their size over the deviation. */
  readonly time?: number;
  /** Number of modes, 1 to 256; default 32. */
  readonly modes?: number;
  /** Seed; default 1. */
  readonly seed?: number;
}

/** A mode: wave vector, 1/m, amplitude, m/s, phase at time 0, in cycles, and frequency, Hz. */
const MODE = ['kx', 'ky', 'kz', 'ax', 'ay', 'az', 'phase', 'frequency'] as const;
type Mode = Readonly<Record<(typeof MODE)[number], Scalar>>;

/**
 * Drag in turbulent wind, with eddies of many sizes that drift and change: F = -(c + k |w|) w, N, with the linear and
 * quadratic drag of each body and its velocity w through the wind. Kraichnan (1970).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step when the world has no room
 */
export function turbulentDrag(options: TurbulenceOptions): Force {
  checkKeys(options, 'turbulentDrag', ['mean', 'deviation', 'largest', 'smallest', 'time', 'modes', 'seed']);
  const spectrum = checkSpectrum(options);
  const { deviation, largest, smallest, time, count } = spectrum;
  return dragIn(spectrum)({ mean: options.mean ?? {}, deviation, largest, smallest, time, modes: count });
}

function dragIn(spectrum: Spectrum) {
  const { of: modesOf, release } = forceMemory((world, take) => drawModes(world, take, spectrum));
  return defineLaw({
    name: 'turbulent drag',
    formula: 'F = -(c + k |w|) w, w = v - u(r, t)',
    source: 'Kraichnan, Phys. Fluids 13, 22 (1970); Fung and others, J. Fluid Mech. 236, 281 (1992).',
    reads: { c: LinearDrag, k: QuadraticDrag },
    // The spectrum's parameters are for display only; the law reads the waves.
    parameters: {
      mean: windParameter,
      deviation: scalar('m/s'),
      largest: scalar('m'),
      smallest: scalar('m'),
      time: scalar('s'),
      modes: scalar(''),
      waves: table(MODE, modesOf),
    },
    force({ position, velocity, time, c, k }, { mean, waves }) {
      const eddies = waves.sum((wave) => {
        const { kx, ky, kz, ax, ay, az } = wave;
        return vec3(ax, ay, az).mul(cosineOfCycles(position.dot(vec3(kx, ky, kz)).add(phaseAt(wave, time))));
      });
      const w = velocity.sub(mean.add(eddies));
      return w.mul(c.add(k.mul(w.length()))).negate();
    },
    prepare: (world) => void modesOf(world),
    releaseMemory: release,
  });
}

/** Reduces the phase to a fraction of a cycle, so that it stays exact in f32 at late times. */
function phaseAt({ phase, frequency }: Mode, time: Scalar): Scalar {
  const cycles = phase.add(frequency.mul(time));
  return cycles.sub(cycles.floor());
}

/**
 * Returns cos(2π t) for t in cycles: reduced to ±½, then its Taylor series to the 16th power, whose last
 * coefficient absorbs most of the next term. Error below 5e-9 in f64, one or two ulp in f32.
 */
function cosineOfCycles(cycles: Scalar): Scalar {
  const square = cycles.sub(cycles.round()).square();
  const series = [
    0.2734560008, -1.71439071109, 7.90353637132, -26.4262567834, 60.2446413719, -85.4568172067, 64.9393940227,
    -19.7392088022, 1,
  ];
  return series.slice(1).reduce((sum, term) => sum.mul(square).add(term), constant(series[0]));
}

type Spectrum = ReturnType<typeof checkSpectrum>;

function checkSpectrum(options: TurbulenceOptions) {
  const number = (key: 'deviation' | 'largest' | 'smallest' | 'time', byDefault?: number) =>
    checkNumber(options[key] ?? byDefault, `turbulentDrag.${key}`, { ...LENGTH_BOUNDS, max: 1e8 });
  const deviation = number('deviation');
  const largest = number('largest');
  const smallest = number('smallest', largest / 30);
  checkNumber(smallest, 'turbulentDrag.smallest', { max: largest });
  const time = number('time', largest / deviation);
  const count = checkWhole(options.modes ?? 32, 'turbulentDrag.modes', 1, 256);
  const { seed = 1 } = options;
  createRandom(seed);
  return { deviation, largest, smallest, time, count, seed };
}

function drawModes(world: PhysicsWorld, take: TakeBytes, spectrum: Spectrum): TableLocation {
  const { deviation, largest, smallest, time, count, seed } = spectrum;
  const at = take(8 * MODE.length * count, 'turbulence');
  const rows = new Float64Array(world.memory.buffer, at, MODE.length * count);
  const random = createRandom(seed);
  const ratios = Array.from({ length: count }, (_, j) => pow(largest / smallest, count === 1 ? 0 : j / (count - 1)));
  const energies = ratios.map((ratio) => pow(ratio, -2 / 3));
  const totalEnergy = energies.reduce((sum, energy) => sum + energy, 0);
  const modes = ratios.map((ratio, j) => {
    // Half the squared amplitude of a wave is its share of the mean square speed, deviation² per axis.
    const amplitude = deviation * Math.sqrt((2 * world.dimensions * energies[j]) / totalEnergy);
    const { wave, polarization } = world.dimensions === 2 ? drawPair2d(random) : drawPair3d(random);
    const number = ratio / largest;
    const phase = random.uniform();
    const frequency = (random.gaussian() * pow(ratio, 2 / 3)) / (2 * Math.PI * time);
    return {
      wave: wave.map((component) => number * component),
      amplitude: polarization.map((component) => amplitude * component),
      phase,
      frequency,
    };
  });
  makeIsotropic(modes, world.dimensions, deviation);
  for (const [j, { wave, amplitude, phase, frequency }] of modes.entries()) {
    rows.set([...wave, ...amplitude, phase, frequency], MODE.length * j);
  }
  return { at, count };
}

/**
 * Makes the mean products of components of the velocity, Σ a aᵀ/2, those of the ensemble: deviation² times the identity.
 * With Σ a aᵀ/2 = deviation² L Lᵀ (Cholesky), amplitudes become L⁻¹ a and wave vectors Lᵀ κ, which keeps a·κ = 0. Few
 * modes that lie near a plane, for which L is far from the identity, stay as they are.
 */
function makeIsotropic(
  modes: readonly { readonly wave: number[]; readonly amplitude: number[] }[],
  dimensions: 2 | 3,
  deviation: number,
): void {
  const factor = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let i = 0; i < dimensions; i++) {
    for (let j = 0; j <= i; j++) {
      let rest = modes.reduce((sum, { amplitude: a }) => sum + a[i] * a[j], 0) / (2 * deviation * deviation);
      for (let k = 0; k < j; k++) rest -= factor[i][k] * factor[j][k];
      if (i === j && rest < 0.25) return;
      factor[i][j] = i === j ? Math.sqrt(rest) : rest / factor[j][j];
    }
  }
  for (const { wave, amplitude } of modes) {
    for (let i = 0; i < 3; i++) {
      for (let k = 0; k < i; k++) amplitude[i] -= factor[i][k] * amplitude[k];
      amplitude[i] /= factor[i][i];
      wave[i] *= factor[i][i];
      for (let k = i + 1; k < 3; k++) wave[i] += factor[k][i] * wave[k];
    }
  }
}

type Pair = { readonly wave: readonly number[]; readonly polarization: readonly number[] };

function drawPair2d(random: Random): Pair {
  const { x, y } = random.onCircle();
  return { wave: [x, y, 0], polarization: [-y, x, 0] };
}

/** Returns a random direction and a random perpendicular one. */
function drawPair3d(random: Random): Pair {
  const { x, y, z } = random.onSphere();
  const side = Math.abs(x) < 0.6 ? [0, z, -y] : [-z, 0, x];
  const length = Math.sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
  const [a, b, c] = side.map((component) => component / length);
  const other = [y * c - z * b, z * a - x * c, x * b - y * a];
  const angle = random.uniform(0, 2 * Math.PI);
  const [sine, cosine] = [sin(angle), cos(angle)];
  return { wave: [x, y, z], polarization: [a, b, c].map((component, i) => component * cosine + other[i] * sine) };
}
