import type { IUniform, Material, WebGLProgramParametersWithUniforms } from 'three';

/** Uniforms by name, shared by every material that draws the same bodies. */
export type Uniforms = Record<string, IUniform>;

const patched = new WeakSet<Material>();

/**
 * Lets `change` rewrite the shaders of one of three's materials and gives them `uniforms`. What the application itself
 * does in `onBeforeCompile` comes first.
 *
 * @param key names the rewriting: three shares programs between materials whose key and settings are equal
 * @throws Error when it is no material, or was rewritten before
 */
export function patchMaterial(
  material: Material,
  uniforms: Uniforms,
  key: string,
  change: (shader: WebGLProgramParametersWithUniforms) => void,
): void {
  if (typeof material?.customProgramCacheKey !== 'function') {
    const given = Array.isArray(material) ? 'an array: all bodies have the same' : String(material);
    throw new Error(`material must be one material of three, such as new MeshStandardMaterial(), got ${given}`);
  }
  if (patched.has(material)) {
    throw new Error('this material draws the bodies of another mesh: give each its own, such as material.clone()');
  }
  patched.add(material);
  const before = material.onBeforeCompile;
  const keyBefore = material.customProgramCacheKey();
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    Object.assign(shader.uniforms, uniforms);
    change(shader);
  };
  material.customProgramCacheKey = () => `${key} ${keyBefore}`;
}

/**
 * Replaces shader chunks by name.
 *
 * @throws Error when `text` has lost one of the `required` chunks, since a silent miss would draw nonsense
 */
export function replaceChunks(text: string, chunks: Record<string, string>, required: readonly string[]): string {
  let changed = text;
  for (const [name, replacement] of Object.entries(chunks)) {
    const include = `#include <${name}>`;
    if (!changed.includes(include) && required.includes(name)) {
      throw new Error(`the material's shader has no chunk "${name}": use one of three's own mesh materials`);
    }
    changed = changed.replace(include, () => replacement);
  }
  return changed;
}
