// A run of the bench: creates the scene, steps it alternately with its peers, and measures the cost.
import { destroyWorld, energy, INTEGRATORS, startProfile, stateHash, step, stopProfile } from '@principia/physics';
import type { SceneRun } from '@principia/scenes';
import type { RunRequest } from './arguments.ts';
import { measureCreation } from './creation.ts';
import { measureSteps } from './measure.ts';
import { garbageBytesPerStep } from './memory.ts';
import { applyVariant, variantParameters } from './particles-variants.ts';
import { peersOf } from './peers/all.ts';
import { warmUp } from './peers/warm-up.ts';
import { startProgress } from './progress.ts';
import { compareWithReference } from './reference.ts';
import { echo, type Result, thisMachine } from './result.ts';
import { measureScaling, type ScalingPoint } from './scaling.ts';
import { summarise } from './statistics.ts';

/** Bodies of the small world that is stepped first, if the scene can have so few. */
const FEW = 64;

/** The result, and every timed step of ours for the report. */
export interface Outcome {
  readonly result: Result;
  readonly series: Float64Array;
}

export async function runBench(request: RunRequest): Promise<Outcome> {
  const { scene, count, dimensions, precision, seed, steps, warmup, parameters, variant } = request;
  const scheme = request.integrator === undefined ? {} : { integrator: INTEGRATORS[request.integrator].create() };
  const making = startProgress('creating', count);
  const options = { dimensions, precision, seed, ...scheme, ...parameters, ...variantParameters(variant) };
  const create = () => scene.create({ ...options, count, progress: making.update });
  const { creation, run: made } = measureCreation(create, count, request.peers);
  const run = applyVariant(made, variant);
  making.end();
  const advance = stepOf(run);
  const few = Math.min(count, Math.max(FEW, scene.parameters.count.min));
  const practice = applyVariant(scene.create({ ...options, count: few }), variant);
  await warmUp(stepOf(practice));
  destroyWorld(practice.world);
  const makers = request.peers ? peersOf(scene.name) : [];

  const stepping = startProgress('stepping', steps);
  let energyBefore = 0;
  const onTimed = () => {
    energyBefore = energy(run.world).total;
  };
  const measured = await measureSteps(run, advance, makers, { steps, warmup, progress: stepping.update, onTimed });
  stepping.end();

  // The measurements below read or advance the state after the steps, so the hash is computed first.
  const hash = stateHash(run.world);
  const drift = (energy(run.world).total - energyBefore) / Math.abs(energyBefore);
  const stretch = run.stretch?.(run.world) ?? null;
  const ours = summarise(measured.ours);
  // Garbage is measured over many steps, after which bodies may be at rest and phases may cost less.
  const profile = phaseTimes(run, advance);
  const result: Result = {
    ...echo(request, run.world),
    msPerStep: ours,
    nsPerBodyStep: (ours.median * 1e6) / count,
    createMs: creation.ms,
    bytes: creation.bytes,
    hash,
    energyDrift: Number.isFinite(drift) ? drift : null,
    energyNote: run.losesEnergy ?? null,
    rmsForceError: run.forceError?.(run.world) ?? null,
    stretch,
    errorKm: run.errorKm?.() ?? null,
    reference: run.reference === undefined ? null : compareWithReference(run.reference()),
    garbageBytesPerStep: garbageBytesPerStep(advance),
    profile,
    peers: measured.peers.map(({ name, ratio }) => ({ name, msPerStep: ratio * ours.median, ratio })),
    scaling: scalingAt(request.scaling ?? [], (some) =>
      applyVariant(scene.create({ ...options, count: some }), variant),
    ),
    create: creation,
    date: new Date().toISOString(),
    machine: thisMachine(),
  };
  return { result, series: measured.ours };
}

function scalingAt(counts: readonly number[], create: (count: number) => SceneRun): ScalingPoint[] {
  const scaling = startProgress('scaling', counts.length);
  const points = measureScaling(create, counts, stepOf, scaling.update);
  scaling.end();
  return points;
}

function stepOf({ world, dt, advance }: SceneRun): () => void {
  return advance === undefined ? () => step(world, dt) : () => advance(world);
}

/** Mean time of each phase over further steps, because reading the clock would slow the timed steps. */
function phaseTimes({ world }: SceneRun, advance: () => void): Record<string, number> {
  const STEPS = 20;
  for (let s = 0; s < 2; s++) advance();
  const { times } = startProfile(world, () => performance.now());
  for (let s = 0; s < STEPS; s++) advance();
  stopProfile(world);
  return Object.fromEntries(Object.entries(times).map(([phase, ms]) => [phase, ms / STEPS]));
}
