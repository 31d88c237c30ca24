/** Types of a program's uniforms. */
export type UniformType = 'f32' | 'i32' | 'vec2<f32>' | 'vec4<f32>';

/** A shader that reads its data from textures (vertex pulling), written once for WebGL and once for WebGPU. */
export interface PullProgram {
  readonly name: string;
  /**
   * Data textures by the name in the shader. Both WebGL 2 and WebGPU guarantee 16 in a vertex shader (WebGPU only 8
   * storage buffers, so columns are textures there too).
   */
  readonly textures: Readonly<Record<string, 'real' | 'whole'>>;
  /** Those of them, of reals, that the fragment stage reads, too. */
  readonly fragmentTextures?: readonly string[];
  /** The program's uniforms by name, widest types first so that WGSL needs no padding between them. */
  readonly uniforms: Readonly<Record<string, UniformType>>;
  /** Code after the header: `main` of either stage. */
  readonly glsl: { readonly vertex: string; readonly fragment: string };
  /** Code after the header: `mainVertex` and `mainFragment`. */
  readonly wgsl: string;
}

const GLSL_TYPES: Readonly<Record<UniformType, string>> = {
  f32: 'float',
  i32: 'int',
  'vec2<f32>': 'vec2',
  'vec4<f32>': 'vec4',
};

/**
 * Start of the two GLSL stages: precisions, pixi's uniforms and the program's own, and the functions
 * `real(texture, i)`, `whole(texture, i)` (texel `i` of a column), `clip(p)` (metres to clip space),
 * `pixelsPerMetre()` (physical pixels; the view has one scale for both axes) and `pixelRatio()` (physical pixels per
 * CSS pixel).
 */
export function glslHeader(program: PullProgram): { vertex: string; fragment: string } {
  const uniforms = Object.entries(program.uniforms).map(([name, type]) => `uniform ${GLSL_TYPES[type]} ${name};`);
  const textures = Object.entries(program.textures).map(
    ([name, kind]) => `uniform ${kind === 'real' ? 'sampler2D' : 'usampler2D'} ${name};`,
  );
  const precision = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
`;
  const access = `ivec2 texel(int i) { return ivec2(i & 1023, i >> 10); }
float real(sampler2D column, int i) { return texelFetch(column, texel(i), 0).r; }
`;
  const vertex = `${precision}
uniform mat3 uProjectionMatrix;
uniform mat3 uWorldTransformMatrix;
uniform vec4 uWorldColorAlpha;
uniform vec2 uResolution;
uniform mat3 uTransformMatrix;
uniform vec4 uColor;
${[...uniforms, ...textures].join('\n')}
${access}uint whole(usampler2D column, int i) { return texelFetch(column, texel(i), 0).r; }
mat3 metresToClip() { return uProjectionMatrix * uWorldTransformMatrix * uTransformMatrix; }
vec4 clip(vec2 p) { return vec4((metresToClip() * vec3(p, 1.0)).xy, 0.0, 1.0); }
float pixelsPerMetre() { return length(metresToClip()[0].xy * uResolution) * 0.5; }
float pixelRatio() { return length(uProjectionMatrix[0].xy * uResolution) * 0.5; }
vec4 rgba(uint bytes) {
  return vec4(uvec4(bytes, bytes >> 8, bytes >> 16, bytes >> 24) & 255u) / 255.0;
}
/** Straight to premultiplied colour, times the tint and opacity of the containers above. */
vec4 tinted(vec4 c) { return vec4(c.rgb * c.a, c.a) * uColor * uWorldColorAlpha; }
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
`;
  const shared = program.fragmentTextures?.map((name) => `uniform sampler2D ${name};\n`) ?? [];
  // A uniform that both stages declare is one, and a stage may declare what it does not read.
  const fragment = [precision, 'out vec4 finalColor;\n', ...uniforms.map((line) => `${line}\n`), ...shared, access];
  return { vertex, fragment: fragment.join('') };
}

/** Start of the WGSL source, with the same functions as `glslHeader`. */
export function wgslHeader(program: PullProgram): string {
  const members = Object.entries(program.uniforms).map(([name, type]) => `  ${name}: ${type},`);
  const textures = Object.entries(program.textures).map(
    ([name, kind], i) => `@group(2) @binding(${i + 1}) var ${name}: texture_2d<${kind === 'real' ? 'f32' : 'u32'}>;`,
  );
  return `struct GlobalUniforms {
  uProjectionMatrix: mat3x3<f32>,
  uWorldTransformMatrix: mat3x3<f32>,
  uWorldColorAlpha: vec4<f32>,
  uResolution: vec2<f32>,
}
struct LocalUniforms {
  uTransformMatrix: mat3x3<f32>,
  uColor: vec4<f32>,
  uRound: f32,
}
struct Own {
${members.join('\n')}
}
@group(0) @binding(0) var<uniform> globalUniforms: GlobalUniforms;
@group(1) @binding(0) var<uniform> localUniforms: LocalUniforms;
@group(2) @binding(0) var<uniform> own: Own;
${textures.join('\n')}
fn texel(i: i32) -> vec2<i32> { return vec2<i32>(i & 1023, i >> 10u); }
fn real(column: texture_2d<f32>, i: i32) -> f32 { return textureLoad(column, texel(i), 0).r; }
fn whole(column: texture_2d<u32>, i: i32) -> u32 { return textureLoad(column, texel(i), 0).r; }
fn metresToClip() -> mat3x3<f32> {
  return globalUniforms.uProjectionMatrix * globalUniforms.uWorldTransformMatrix * localUniforms.uTransformMatrix;
}
fn clip(p: vec2<f32>) -> vec4<f32> { return vec4<f32>((metresToClip() * vec3<f32>(p, 1.0)).xy, 0.0, 1.0); }
fn pixelsPerMetre() -> f32 { return length(metresToClip()[0].xy * globalUniforms.uResolution) * 0.5; }
fn pixelRatio() -> f32 { return length(globalUniforms.uProjectionMatrix[0].xy * globalUniforms.uResolution) * 0.5; }
fn rgba(bytes: u32) -> vec4<f32> {
  let parts = vec4<u32>(bytes, bytes >> 8u, bytes >> 16u, bytes >> 24u) & vec4<u32>(255u);
  return vec4<f32>(parts) / 255.0;
}
fn tinted(c: vec4<f32>) -> vec4<f32> {
  return vec4<f32>(c.rgb * c.a, c.a) * localUniforms.uColor * globalUniforms.uWorldColorAlpha;
}
const NOWHERE = vec4<f32>(2.0, 2.0, 2.0, 1.0);
`;
}

/** `GPUShaderStage.VERTEX`, `FRAGMENT`: literals, because the global exists only in browsers with WebGPU. */
const VERTEX = 1;
const FRAGMENT = 2;

/**
 * Bind group layout of the program. It is explicit because a layout derived from the source would declare the f32
 * textures filterable, which 32-bit float textures are not.
 */
export function gpuLayout(program: PullProgram): GPUBindGroupLayoutEntry[][] {
  const uniform = (): GPUBindGroupLayoutEntry => ({
    binding: 0,
    visibility: VERTEX | FRAGMENT,
    buffer: { type: 'uniform' },
  });
  const textures = Object.entries(program.textures).map(
    ([name, kind], i): GPUBindGroupLayoutEntry => ({
      binding: i + 1,
      visibility: program.fragmentTextures?.includes(name) ? VERTEX | FRAGMENT : VERTEX,
      texture: { sampleType: kind === 'real' ? 'unfilterable-float' : 'uint', viewDimension: '2d' },
    }),
  );
  return [[uniform()], [uniform()], [uniform(), ...textures]];
}
