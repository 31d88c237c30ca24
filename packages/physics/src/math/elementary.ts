// Elementary functions that give the same bits on every JavaScript engine, which Math.sin and its like do not. They are
// the kernels' own (kernels/math), so TypeScript and kernels agree to the last bit. Each is within 1 ulp
// (sine and cosine of angles beyond a million radians within 2).
// Cost: some 20 ns, of which half is the call.
import { instantiate } from '../kernels/instantiate.ts';
import { KERNELS, type KernelExports } from '../kernels/math.gen.ts';

let made: KernelExports | undefined;

/** Made at the first use, with a page of memory of its own for a table. */
function kernels(): KernelExports {
  made ??= instantiate<KernelExports>(KERNELS, 'f64', new WebAssembly.Memory({ initial: 1 }));
  return made;
}

/** Sine of an angle in radians, of any size. */
export function sin(x: number): number {
  return kernels().sine(x);
}

/** Cosine of an angle in radians, of any size. */
export function cos(x: number): number {
  return kernels().cosine(x);
}

/** The angle of the vector (x, y) from the x axis, −π to π. */
export function atan2(y: number, x: number): number {
  return kernels().arcTangent2(y, x);
}

/** e to the power x. */
export function exp(x: number): number {
  return kernels().exponential(x);
}

/** Natural logarithm. */
export function log(x: number): number {
  return kernels().logarithm(x);
}

/** cells[at] to the power y, in its place: a number that is handed on and returned becomes garbage. */
export function raise(cells: Float64Array, at: number, y: number): void {
  cells[at] = kernels().power(cells[at], y);
}

/** x to the power y. */
export function pow(x: number, y: number): number {
  return kernels().power(x, y);
}
