import { PhysicsError } from '../errors/physics-error.ts';
import { compileBytes } from './compile-bytes.ts';
import { KERNELS, type KernelExports } from './core.gen.ts';
import { decodeHex, type EmbeddedModule } from './decode.ts';

/** Precision of all columns of a world: single or double. */
export type Precision = 'f32' | 'f64';
export type { KernelExports };

/** Compiled modules of this process, by their text. */
const compiled = new Map<string, WebAssembly.Module>();

/**
 * Instantiates the kernels of every world.
 * @throws PhysicsError E_RANGE for a precision omitted from the bundle
 */
export function instantiateKernels(precision: Precision, memory: WebAssembly.Memory): KernelExports {
  return instantiate<KernelExports>(KERNELS, precision, memory);
}

/**
 * Returns the functions of one build of a module by name. Compilation is synchronous and happens once per process and
 * build.
 * @throws PhysicsError E_RANGE for a precision omitted from the bundle
 */
export function instantiate<Exports>(
  kernels: EmbeddedModule,
  precision: Precision,
  memory: WebAssembly.Memory,
): Exports {
  const text = kernels[precision];
  if (text === '') throw leftOut(precision);
  let module = compiled.get(text);
  if (module === undefined) {
    module = compileBytes(decodeHex(text));
    compiled.set(text, module);
  }
  return new WebAssembly.Instance(module, { env: { memory } }).exports as Exports;
}

function leftOut(precision: Precision): PhysicsError {
  const available = precision === 'f32' ? 'f64' : 'f32';
  return new PhysicsError(
    'E_RANGE',
    `precision must be '${available}' here, got '${precision}': the export condition principia-${available} left the kernels for ${precision} out of this bundle.`,
    {
      field: 'precision',
      value: precision,
      hint: `Create the world with precision: '${available}', or build without the condition principia-${available}.`,
    },
  );
}
