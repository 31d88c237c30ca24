import type { EmbeddedModule } from '../kernels/decode.ts';
import { instantiate } from '../kernels/instantiate.ts';
import type { PhysicsWorld } from '../world/types.ts';

/**
 * Instantiates the kernels of a feature for each world on first use. A game that does not import the feature does not
 * contain them: `const kernels = kernelModule<NBodyKernels>(KERNELS)`, then `kernels(world).walk(…)`.
 */
export function kernelModule<Exports>(kernels: EmbeddedModule): (world: PhysicsWorld) => Exports {
  return ({ internal, precision, memory }) => {
    let exports = internal.resources.get(kernels);
    if (exports === undefined) {
      exports = instantiate(kernels, precision, memory);
      internal.resources.set(kernels, exports);
    }
    return exports as Exports;
  };
}
