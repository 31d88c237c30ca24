import { PhysicsError } from '../errors/physics-error.ts';

/**
 * Compiles a module synchronously.
 * @throws PhysicsError E_TYPE if the page forbids it
 */
export function compileBytes(bytes: Uint8Array<ArrayBuffer>): WebAssembly.Module {
  try {
    return new WebAssembly.Module(bytes);
  } catch (cause) {
    const isForbidden = cause instanceof Error && /Content Security Policy|unsafe-eval|disallowed/i.test(cause.message);
    if (!isForbidden) throw cause;
    const error = new PhysicsError('E_TYPE', 'this page forbids compiling WebAssembly, which every world needs.', {
      field: 'WebAssembly',
      hint: "Add 'wasm-unsafe-eval' to script-src of its Content-Security-Policy.",
    });
    error.cause = cause;
    throw error;
  }
}
