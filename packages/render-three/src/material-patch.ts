import type { IUniform, Material, WebGLProgramParametersWithUniforms } from 'three';

/** Uniforms by name, shared by every material that draws the same bodies. */
export type Uniforms = Record<string, IUniform>;

/** What undoes the rewriting of each material that draws bodies. */
const undoes = new WeakMap<Material, () => void>();

/** Settings of a material that a rewriting changes. */
type MaterialSettings = Partial<
  Pick<
    Material,
    'shadowSide' | 'alphaToCoverage' | 'blending' | 'blendSrc' | 'blendDst' | 'blendSrcAlpha' | 'blendDstAlpha'
  >
>;

/**
 * Lets `change` rewrite the shaders of one of three's materials and gives them `uniforms`. What the application itself
 * does in `onBeforeCompile` comes first. `restoreMaterial` undoes it.
 *
 * @param key names the rewriting: three shares programs between materials whose key and settings are equal
 * @param settings are set as well
 * @throws Error when it is no material, or draws other bodies
 */
export function patchMaterial(
  material: Material,
  uniforms: Uniforms,
  key: string,
  change: (shader: WebGLProgramParametersWithUniforms) => void,
  settings: MaterialSettings = {},
): void {
  if (typeof material?.customProgramCacheKey !== 'function') {
    const given = Array.isArray(material) ? 'an array: all bodies have the same' : String(material);
    throw new Error(`material must be one material of three, such as new MeshStandardMaterial(), got ${given}`);
  }
  if (undoes.has(material)) {
    throw new Error('this material draws the bodies of another mesh: give each its own, such as material.clone()');
  }
  const before = material.onBeforeCompile;
  const makeKeyBefore = material.customProgramCacheKey;
  const keyBefore = material.customProgramCacheKey();
  const settingsBefore = Object.fromEntries(Object.keys(settings).map((name) => [name, material[name as never]]));
  undoes.set(material, () =>
    Object.assign(material, settingsBefore, { onBeforeCompile: before, customProgramCacheKey: makeKeyBefore }),
  );
  Object.assign(material, settings);
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    Object.assign(shader.uniforms, uniforms);
    change(shader);
  };
  material.customProgramCacheKey = () => `${key} ${keyBefore}`;
}

/** Makes a material what it was before `patchMaterial`, so that it may draw something else. */
export function restoreMaterial(material: Material): void {
  undoes.get(material)?.();
  undoes.delete(material);
}

/** Whether a material of three shows normals, whatever the colours are: its shader then has no chunk for the colour. */
export function showsNormals(material: Material): boolean {
  return material?.type === 'MeshNormalMaterial';
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
      throw new Error(
        `the material's shader has no chunk "${name}": use a mesh material of three, such as MeshStandardMaterial`,
      );
    }
    changed = changed.replace(include, () => replacement);
  }
  return changed;
}
