// The systems of `particles` as one SIMD kernel fused by hand (bench/kernels). It does all of their work on its own
// columns, at addresses that suit it best.
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { MAX_POSITION, MAX_SPEED, type PhysicsWorld, type Precision } from '@principia/physics';
import type { Particles, SceneRun } from '@principia/scenes';
import type { Peer } from './peer.ts';
import { warmUp } from './warm-up.ts';

/** The exports of the kernel. */
interface Kernel {
  reserve(): void;
  columnAt(index: number): number;
  configure(
    low: number,
    high: number,
    gravity: number,
    restitution: number,
    maxPosition: number,
    maxSpeed: number,
    dt: number,
  ): void;
  fused2d(first: number, last: number): number;
  fused3d(first: number, last: number): number;
}

/** A peer that also exposes the previous positions. */
export interface FusedPeer extends Peer {
  readonly previous: Peer['positions'];
}

/** Rows on which the kernel is warmed up. */
const ROWS = 1024;

export async function fusedSimd(run: SceneRun): Promise<FusedPeer> {
  const { world, dt, gravity, side, restitution } = run as Particles;
  const memory = new WebAssembly.Memory({ initial: 2 });
  const kernel = await instantiate(world.precision, memory);
  kernel.reserve();
  kernel.configure(0, side, gravity, restitution, MAX_POSITION, MAX_SPEED, dt);
  const last = Math.ceil((world.lastId + 1) / 16) * 16;
  const Real = world.precision === 'f32' ? Float32Array : Float64Array;
  const step = world.dimensions === 2 ? kernel.fused2d : kernel.fused3d;
  const columns = columnsOf(world).map((_, index) => new Real(memory.buffer, kernel.columnAt(index), last));
  const fill = () => {
    for (const [index, values] of columnsOf(world).entries()) columns[index].set(values.subarray(0, last));
  };
  fill();
  await warmUp(() => step(0, Math.min(last, ROWS)));
  fill();
  return {
    name: 'hand-fused SIMD kernel',
    step() {
      if (step(0, last) !== 1) throw new Error('The fused kernel found a value out of range.');
    },
    positions: (axis) => columns[AXES.indexOf(axis)],
    previous: (axis) => columns[6 + AXES.indexOf(axis)],
  };
}

const AXES = ['x', 'y', 'z'];

/** The columns in the order of the kernel. */
function columnsOf({ components, previous }: PhysicsWorld) {
  const { Position, Velocity, Mass, QuadraticDrag, Collider } = components;
  return [
    Position.x,
    Position.y,
    Position.z,
    Velocity.x,
    Velocity.y,
    Velocity.z,
    previous.Position.x,
    previous.Position.y,
    previous.Position.z,
    Mass.value,
    QuadraticDrag.coefficient,
    Collider.radius,
  ];
}

async function instantiate(precision: Precision, memory: WebAssembly.Memory): Promise<Kernel> {
  // The path is computed so that bundlers leave the compiler out of the bundle.
  const compiler = pathToFileURL(resolve('bench/kernels/compile.mjs')).href;
  const { referenceKernel } = await import(/* @vite-ignore */ compiler);
  const module = new WebAssembly.Module(await referenceKernel(precision));
  return new WebAssembly.Instance(module, { env: { memory } }).exports as unknown as Kernel;
}
