// The elementary functions that fused loops import: those of kernels/math, so that laws and TypeScript get the same
// bits.
import { instantiate } from '../kernels/instantiate.ts';
import { KERNELS, type KernelExports } from '../kernels/math.gen.ts';
import type { PhysicsWorld } from '../world/types.ts';

const functions = new WeakMap<WebAssembly.Memory, Readonly<Record<string, unknown>>>();

/** The functions by the names of the operations. */
export function mathImports({ memory, precision }: PhysicsWorld): Readonly<Record<string, unknown>> {
  let made = functions.get(memory);
  if (made === undefined) {
    const kernels = instantiate<KernelExports>(KERNELS, precision, memory);
    const { sine, cosine, exponential, logarithm, power, arcTangent2, noise } = kernels;
    made = { sin: sine, cos: cosine, exp: exponential, log: logarithm, pow: power, atan2: arcTangent2, noise };
    functions.set(memory, made);
  }
  return made;
}
