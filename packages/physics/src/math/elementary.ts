// Elementary functions that give the same bits on every JavaScript engine, unlike Math.sin. They are those of
// kernels/math, so TypeScript and kernels agree to the last bit. Each is within 1 ulp (sine and cosine of angles beyond
// a million radians within 2). Cost: about 20 ns, half of it for the call.
import { instantiate } from '../kernels/instantiate.ts';
import { KERNELS, type KernelExports } from '../kernels/math.gen.ts';

let made: KernelExports | undefined;

/** Instantiated on first use, with one page of memory for a table. */
function kernels(): KernelExports {
  made ??= instantiate<KernelExports>(KERNELS, 'f64', new WebAssembly.Memory({ initial: 1 }));
  return made;
}

/** Sine of an angle in radians, of any magnitude. */
export function sin(x: number): number {
  return kernels().sine(x);
}

/** Cosine of an angle in radians, of any magnitude. */
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

/** Replaces cells[at] by its power y; a number passed and returned would create garbage. */
export function powInPlace(cells: Float64Array, at: number, y: number): void {
  cells[at] = kernels().power(cells[at], y);
}

/** x to the power y. */
export function pow(x: number, y: number): number {
  return kernels().power(x, y);
}
