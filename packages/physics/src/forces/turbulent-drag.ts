// Drag in turbulent wind: eddies of many sizes that drift and change, the same for every frame rate.
//
//   F = -(c + k |w|) w,   w = v - u(r, t)        u = mean + Σ aⱼ cos(2π (κⱼ·r + φⱼ + νⱼ t)),   aⱼ ⊥ κⱼ
//
//   c  LinearDrag, kg/s    k  QuadraticDrag, kg/m    u  velocity of the air, m/s
//   κⱼ  wave vector, 1/m   aⱼ  amplitude, m/s    νⱼ  frequency, Hz    φⱼ  phase
//
// Every mode is a wave across its own direction, so u has no divergence anywhere. Wave numbers run by equal ratios from
// 1/largest to 1/smallest eddy with the energies of Kolmogorov's spectrum (aⱼ² ∝ κ^(-2/3) a band), frequencies go as
// κ^(2/3), and directions, signs and phases come from the seed: Kraichnan, Phys. Fluids 13, 22 (1970); Fung and others,
// J. Fluid Mech. 236, 281 (1992). u is a function of place and time, not of the step: its statistics cannot depend on
// the frame rate. List no other drag beside it. Each mode takes 56 bytes of a world's memory, once.
// Cost: some 3 ns a body and mode in f32, 7 ns in f64.
import { checkKeys, checkNumber, checkWhole } from '../faults/validate';
import { cos, pow, sin } from '../math/elementary';
import { createRandom, type Random } from '../math/random';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import type { PhysicsWorld } from '../world';
import { LENGTHS } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { type Wind, windState } from './wind';

export interface TurbulenceOptions {
  /** Mean wind, m/s; default none. */
  readonly mean?: Wind;
  /** Standard deviation of each component of the wind, m/s. */
  readonly deviation: number;
  /** Size of the largest eddies, m. */
  readonly largest: number;
  /** Size of the smallest, m; default a thirtieth of the largest. */
  readonly smallest?: number;
  /** Time in which the largest eddies change, s; default their size over the deviation. */
  readonly time?: number;
  /** Waves, 1 to 256; default 32. */
  readonly modes?: number;
  /** Default 1. */
  readonly seed?: number;
}

/** Numbers of one mode, kernels/forces/turbulence.ts: wave vector, amplitude, phase now. */
const MODE = 7;

interface Modes {
  readonly at: number;
  readonly table: Float64Array;
  /** Phase at time 0 and frequency of each mode. */
  readonly phases: Float64Array;
  time: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN; E_CAPACITY from a step when the world has no room */
export function turbulentDrag(options: TurbulenceOptions): Force {
  checkKeys(options, 'turbulentDrag', ['mean', 'deviation', 'largest', 'smallest', 'time', 'modes', 'seed']);
  const spectrum = checkSpectrum(options);
  const mean = windState(options.mean ?? {}, 'turbulentDrag.mean');
  const modesOf = resource((world) => drawModes(world, spectrum));
  return {
    name: 'turbulent drag',
    equation: 'F = -(c + k |w|) w, w = v - u(r, t)',
    parameters: {
      deviation: { unit: 'm/s', value: spectrum.deviation },
      largest: { unit: 'm', value: spectrum.largest },
      smallest: { unit: 'm', value: spectrum.smallest },
      time: { unit: 's', value: spectrum.time },
      modes: { unit: '', value: spectrum.count },
    },
    reads: ['Position', 'Velocity', 'LinearDrag', 'QuadraticDrag'],
    local: true,
    accumulate(world, first, last, time) {
      const modes = modesOf(world);
      movePhases(modes, time);
      const w = mean.at(world, time);
      const { x, y, z } = world.scratch.at.force;
      const linear = world.addresses.LinearDrag.coefficient;
      const quadratic = world.addresses.QuadraticDrag.coefficient;
      const wz = world.dimensions === 3 ? w.z : 0;
      const kernels = lawKernels(world);
      kernels.turbulentDrag(x, y, z, linear, quadratic, modes.at, spectrum.count, w.x, w.y, wz, first, last);
    },
  };
}

type Spectrum = ReturnType<typeof checkSpectrum>;

function checkSpectrum(options: TurbulenceOptions) {
  const number = (key: 'deviation' | 'largest' | 'smallest' | 'time', byDefault?: number) =>
    checkNumber(options[key] ?? byDefault, `turbulentDrag.${key}`, { ...LENGTHS, max: 1e8 });
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

function drawModes(world: PhysicsWorld, spectrum: Spectrum): Modes {
  const { deviation, largest, smallest, time, count, seed } = spectrum;
  const { arena } = world.internal;
  const at = allocate(arena, count * MODE * 8, 'turbulence');
  const table = new Float64Array(arena.memory.buffer, at, count * MODE);
  const phases = new Float64Array(2 * count);
  const random = createRandom(seed);
  const ratios = Array.from({ length: count }, (_, j) => pow(largest / smallest, count === 1 ? 0 : j / (count - 1)));
  const energies = ratios.map((ratio) => pow(ratio, -2 / 3));
  const whole = energies.reduce((sum, energy) => sum + energy, 0);
  for (let j = 0; j < count; j++) {
    // Half a wave's amplitude squared is its share of the mean square speed, deviation² for each axis.
    const amplitude = deviation * Math.sqrt((2 * world.dimensions * energies[j]) / whole);
    const { wave, across } = world.dimensions === 2 ? plane(random) : space(random);
    const number = ratios[j] / largest;
    for (let axis = 0; axis < 3; axis++) {
      table[j * MODE + axis] = number * wave[axis];
      table[j * MODE + 3 + axis] = amplitude * across[axis];
    }
    phases[2 * j] = random.uniform();
    phases[2 * j + 1] = (random.gaussian() * pow(ratios[j], 2 / 3)) / (2 * Math.PI * time);
  }
  return { at, table, phases, time: Number.NaN };
}

type Pair = { readonly wave: readonly number[]; readonly across: readonly number[] };

function plane(random: Random): Pair {
  const { x, y } = random.onCircle();
  return { wave: [x, y, 0], across: [-y, x, 0] };
}

/** A direction, and one across it: the cross product with any axis not along it, turned by a random angle. */
function space(random: Random): Pair {
  const { x, y, z } = random.onSphere();
  const side = Math.abs(x) < 0.6 ? [0, z, -y] : [-z, 0, x];
  const length = Math.sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
  const [a, b, c] = side.map((part) => part / length);
  const other = [y * c - z * b, z * a - x * c, x * b - y * a];
  const angle = random.uniform(0, 2 * Math.PI);
  const [turned, rest] = [sin(angle), cos(angle)];
  return { wave: [x, y, z], across: [a, b, c].map((part, i) => part * rest + other[i] * turned) };
}

/** Whole turns are left out, so that phases stay exact in f32 however late it is. */
function movePhases(modes: Modes, time: number): void {
  if (modes.time === time) return;
  modes.time = time;
  const { table, phases } = modes;
  for (let j = 0; j < phases.length; j += 2) {
    const turns = phases[j] + phases[j + 1] * time;
    table[(j / 2) * MODE + 6] = turns - Math.floor(turns);
  }
}
