import { cpus } from 'node:os';
import type { PhysicsWorld } from '@principia/physics';
import type { Stretch } from '@principia/scenes';
import type { RunRequest } from './arguments.ts';
import type { Creation } from './creation.ts';
import type { Variant } from './particles-variants.ts';
import type { ReferenceResult } from './reference.ts';
import type { ScalingPoint } from './scaling.ts';
import type { Summary } from './statistics.ts';

/** What a run of the bench found; `--json` writes it as it stands. Times in milliseconds unless named otherwise. */
export interface Result {
  readonly scene: string;
  readonly count: number;
  readonly steps: number;
  readonly dimensions: 2 | 3;
  readonly precision: 'f32' | 'f64';
  /** Of the scene `particles`: whether all rest on the floor, and how many laws act on each. */
  readonly variant: Variant;
  readonly msPerStep: Summary;
  readonly nsPerBodyStep: number;
  readonly createMs: number;
  /** What the world takes in memory. */
  readonly bytes: number;
  /** Of the state after all steps. */
  readonly hash: string;
  /** Relative change of the total energy over the timed steps; null where there is none. */
  readonly energyDrift: number | null;
  /** RMS relative error of forces that are approximated; null where they are exact. */
  readonly rmsForceError: number | null;
  /** How far what keeps its length is from it after the last step; null where nothing has to. */
  readonly stretch: Stretch | null;
  /** Distance from where each body should be, km, by body and time; null where that is not known. */
  readonly errorKm: Readonly<Record<string, Readonly<Record<string, number>>>> | null;
  /** Against a scheme that is next to exact; null where there is none. */
  readonly reference: ReferenceResult | null;
  /** Milliseconds a step spends in each phase. */
  readonly profile: Readonly<Record<string, number>>;
  readonly peers: readonly PeerResult[];
  /** The cost at other counts; empty unless asked for. */
  readonly scaling: readonly ScalingPoint[];
  readonly create: Creation;
  readonly garbageBytesPerStep: number;
  readonly warmup: number;
  readonly seed: number;
  /** Why energy is meant to change; null where it should be kept. */
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
