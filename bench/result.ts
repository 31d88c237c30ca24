import { cpus } from 'node:os';
import type { PhysicsWorld } from '@principia/physics';
import type { Stretch } from '@principia/scenes';
import type { RunRequest } from './arguments.ts';
import type { Creation } from './creation.ts';
import type { Variant } from './particles-variants.ts';
import type { ReferenceResult } from './reference.ts';
import type { ScalingPoint } from './scaling.ts';
import type { Summary } from './statistics.ts';

/** The result of a bench run; `--json` writes it unchanged. Times are in ms unless stated otherwise. */
export interface Result {
  readonly scene: string;
  readonly count: number;
  readonly steps: number;
  readonly dimensions: 2 | 3;
  readonly precision: 'f32' | 'f64';
  /** Options of the scene `particles`: whether all bodies rest on the floor, and the number of laws. */
  readonly variant: Variant;
  readonly msPerStep: Summary;
  readonly nsPerBodyStep: number;
  readonly createMs: number;
  /** Memory of the world. */
  readonly bytes: number;
  /** Hash of the state after all steps. */
  readonly hash: string;
  /** Relative change of the total energy over the timed steps; null if the energy is zero. */
  readonly energyDrift: number | null;
  /** RMS relative error of approximated forces; null if forces are exact. */
  readonly rmsForceError: number | null;
  /** Relative stretch of inextensible threads after the last step; null if there are none. */
  readonly stretch: Stretch | null;
  /** Distance of each body from its true position, km, by body and time; null if unknown. */
  readonly errorKm: Readonly<Record<string, Readonly<Record<string, number>>>> | null;
  /** Comparison with a nearly exact integrator; null if there is none. */
  readonly reference: ReferenceResult | null;
  /** Milliseconds per step in each phase. */
  readonly profile: Readonly<Record<string, number>>;
  readonly peers: readonly PeerResult[];
  /** The cost at other counts; empty unless requested. */
  readonly scaling: readonly ScalingPoint[];
  readonly create: Creation;
  readonly garbageBytesPerStep: number;
  readonly warmup: number;
  readonly seed: number;
  /** Why energy is not conserved; null if it is. */
  readonly energyNote: string | null;
  readonly date: string;
  readonly machine: Machine;
}

/**
 * `ratio` is their median time over ours in the steps taken in turns: above 1 we are faster. `msPerStep` puts it to the
 * scale of our median of all steps, so that one table compares everybody.
 */
export interface PeerResult {
  readonly name: string;
  readonly msPerStep: number;
  readonly ratio: number;
}

export interface Machine {
  readonly node: string;
  readonly platform: string;
  readonly cpu: string;
  readonly cores: number;
}

export function thisMachine(): Machine {
  const all = cpus();
  const { platform, arch, version } = process;
  return { node: version, platform: `${platform} ${arch}`, cpu: all[0]?.model.trim() ?? '', cores: all.length };
}

/** What the request says, as the result repeats it, and what the scene made of it: some are always in space. */
export function echo(
  { scene, count, steps, warmup, seed, variant }: RunRequest,
  { dimensions, precision }: PhysicsWorld,
) {
  return { scene: scene.name, count, steps, warmup, dimensions, precision, seed, variant };
}
