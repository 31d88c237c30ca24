// The composed systems of `particles` against one hand-fused SIMD kernel (bench/kernels) on columns laid out the same.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { MAX_POSITION, MAX_SPEED, type PhysicsWorld, type Precision } from '@principia/physics';
import type { Particles, SceneRun } from '@principia/scenes';
import type { Peer } from './peer';

type FusedStep = (columns: number, setting: number, first: number, last: number) => number;

/** Columns the kernel reads or writes, in the order of its class. */
function columnAddresses({ addresses, previousAddresses }: PhysicsWorld): number[] {
  const { Position, Velocity, Mass, QuadraticDrag, Collider } = addresses;
  const previous = previousAddresses.Position;
  return [
    ...[Position.x, Position.y, Position.z],
    ...[Velocity.x, Velocity.y, Velocity.z],
    ...[previous.x, previous.y, previous.z],
    ...[Mass.value, QuadraticDrag.coefficient, Collider.radius, Collider.restitution],
  ];
}

/** A peer on a copy of the columns at the same addresses, so that both lie in the cache alike. */
export async function fusedSimd(run: SceneRun): Promise<Peer> {
  const { world } = run;
  const memory = new WebAssembly.Memory({ initial: world.memory.buffer.byteLength / 65536 });
  const bytes = world.rows * realBytes(world.precision);
  for (const address of columnAddresses(world)) {
    new Uint8Array(memory.buffer, address, bytes).set(new Uint8Array(world.memory.buffer, address, bytes));
  }
  const Real = world.precision === 'f32' ? Float32Array : Float64Array;
  return {
    name: 'hand-fused SIMD kernel',
    step: await fusedStep(run as Particles, memory),
    positions: (axis) => new Real(memory.buffer, world.addresses.Position[axis], world.rows),
  };
}

/** The fused step of a `particles` world on `memory`, which may be the world's own. */
export async function fusedStep(
  { world, dt, gravity, side, restitution }: Particles,
  memory: WebAssembly.Memory,
): Promise<() => void> {
  const kernel = await instantiate(world.precision, memory);
  const step = (world.dimensions === 2 ? kernel.fused2d : kernel.fused3d) as FusedStep;
  // Semi-implicit Euler has no stages: their columns are free for the kernel's two tables.
  const { x: columns, y: setting } = world.scratch.at.stage1;
  new Uint32Array(memory.buffer, columns, 13).set(columnAddresses(world));
  const Real = world.precision === 'f32' ? Float32Array : Float64Array;
  new Real(memory.buffer, setting, 9).set([
    ...[0, side],
    ...[0, -gravity, 0],
    ...[restitution, MAX_POSITION, MAX_SPEED, dt],
  ]);
  const last = Math.ceil((world.lastId + 1) / 16) * 16;
  return () => {
    if (step(columns, setting, 0, last) !== 1) throw new Error('The fused kernel found a value out of range.');
  };
}

async function instantiate(precision: Precision, memory: WebAssembly.Memory): Promise<WebAssembly.Exports> {
  // The address is computed so that bundlers leave the compiler out of the bundle.
  const compiler = pathToFileURL(resolve('bench/kernels/compile.mjs')).href;
  const { referenceKernel } = await import(/* @vite-ignore */ compiler);
  const module = new WebAssembly.Module(await referenceKernel(precision));
  return new WebAssembly.Instance(module, { env: { memory } }).exports;
}

function realBytes(precision: Precision): number {
  return precision === 'f32' ? 4 : 8;
}
