import { SHAPES } from '@principia/render-core';
import {
  CustomBlending,
  DoubleSide,
  type Material,
  MeshBasicMaterial,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RGBADepthPacking,
  ShaderChunk,
  ShaderMaterial,
  type WebGLProgramParametersWithUniforms,
  ZeroFactor,
} from 'three';
import { patchMaterial, replaceChunks, showsNormals, type Uniforms } from './material-patch.ts';
import { bodyPull } from './shaders/body-pull.ts';
import {
  beachBall,
  drawsFlats,
  drawsSolids,
  impostorFragmentPars,
  impostorSolidPars,
  impostorVertexPars,
} from './shaders/impostor.ts';
import { flatFragmentShader, flatVertexShader } from './shaders/impostor-flat.ts';

/**
 * Light of a photographer's studio that moves with the camera: bodies are shaded, and look the same, in a scene that
 * has no lights at all.
 */
const studioLight = /* glsl */ `
float studioLight(vec3 normal) {
  float key = dot(normal, vec3(-0.40, 0.64, 0.66));
  float fill = dot(normal, vec3(0.64, -0.38, 0.66));
  float lit = max(key, 0.0);
  return 0.16 + 0.10 * normal.y + 0.80 * lit + 0.16 * max(fill, 0.0) + 0.5 * pow(lit, 40.0);
}
`;

/** The lit fragment shader of any of three's materials, changed to meet the surface of the body. */
function litFragmentShader(stock: string, isStudio: boolean, isColored: boolean): string {
  const pars = `#include <clipping_planes_pars_fragment>
    ${impostorFragmentPars}${impostorSolidPars}${beachBall}${studioLight}${shadowMatrices}`;
  const chunks = {
    clipping_planes_pars_fragment: pars,
    clipping_planes_fragment: '#include <clipping_planes_fragment>\nmeetSolid();',
    logdepthbuf_fragment: '',
    color_fragment: bodyColorFragment,
    normal_fragment_begin: isColored ? normalFragment : normalFragment + coverageFragment,
    lights_fragment_begin: lightsAtHit(),
    opaque_fragment: `${isStudio ? 'outgoingLight *= studioLight(impostorNormal);' : ''}\n#include <opaque_fragment>`,
  };
  const required = ['clipping_planes_pars_fragment', 'clipping_planes_fragment'];
  return replaceChunks(stock, chunks, isColored ? [...required, 'color_fragment'] : required);
}

const coverageFragment = 'diffuseColor.a *= impostorCoverage;\n';

const bodyColorFragment = /* glsl */ `
vec3 pattern = beachBall(impostorLocal, vBodyColor.rgb);
diffuseColor.rgb *= vBodyShape == ${SHAPES.markedDisc}u ? pattern : vBodyColor.rgb;
${coverageFragment}`;

const normalFragment = /* glsl */ `
float faceDirection = 1.0;
vec3 normal = impostorNormal;
vec3 nonPerturbedNormal = normal;
`;

/** Shadow coordinates are linear over a triangle, not over a ball, so they are worked out at the hit. */
const shadowMatrices = /* glsl */ `
#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  uniform mat4 directionalShadowMatrix[NUM_DIR_LIGHT_SHADOWS];
#endif
#if defined(USE_SHADOWMAP) && NUM_POINT_LIGHT_SHADOWS > 0
  uniform mat4 pointShadowMatrix[NUM_POINT_LIGHT_SHADOWS];
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
  uniform mat4 spotLightMatrix[NUM_SPOT_LIGHT_COORDS];
#endif
vec4 hitInWorld(float normalBias) {
  vec3 world = ((vec4(impostorHit, 1.0) - viewMatrix[3]) * viewMatrix).xyz;
  return vec4(world + normalBias * (vec4(impostorNormal, 0.0) * viewMatrix).xyz, 1.0);
}
`;

function lightsAtHit(): string {
  return ShaderChunk.lights_fragment_begin
    .replaceAll('vViewPosition', '(- impostorHit)')
    .replaceAll(
      'vDirectionalShadowCoord[ i ]',
      '(directionalShadowMatrix[ i ] * hitInWorld(directionalLightShadow.shadowNormalBias))',
    )
    .replaceAll('vPointShadowCoord[ i ]', '(pointShadowMatrix[ i ] * hitInWorld(pointLightShadow.shadowNormalBias))')
    .replaceAll('vSpotLightCoord[ i ]', '(spotLightMatrix[ i ] * hitInWorld(0.0))');
}

function solidVertexShader(stock: string, dimensions: 2 | 3): string {
  const chunks = {
    clipping_planes_pars_vertex: `#include <clipping_planes_pars_vertex>
      ${bodyPull(dimensions)}${drawsSolids}${impostorVertexPars}`,
    uv_vertex: 'pullImpostor();\nplaceImpostor();',
    beginnormal_vertex: 'vec3 objectNormal = vec3(0.0, 0.0, 1.0);',
    begin_vertex: 'vec3 transformed = bodyCentre;',
    project_vertex: `vec4 mvPosition = impostorCorner;
      gl_Position = impostorVisible ? projectionMatrix * mvPosition : vec4(2.0, 2.0, 2.0, 1.0);`,
  };
  const required = ['clipping_planes_pars_vertex', 'uv_vertex', 'begin_vertex', 'project_vertex'];
  return replaceChunks(stock, chunks, required);
}

/** The material of bodies in a scene without lights: shaded by a light that moves with the camera. */
export function createStudioMaterial(): MeshBasicMaterial {
  const material = new MeshBasicMaterial();
  material.name = 'studio';
  return material;
}

/**
 * Makes `material` draw impostors: any lit or unlit mesh material of three. Its colour multiplies the bodies' colours;
 * its texture maps are not used, as an impostor has no texture coordinates.
 */
export function patchImpostorMaterial(material: Material, uniforms: Uniforms, dimensions: 2 | 3): void {
  const isStudio = material.name === 'studio';
  const isColored = !showsNormals(material);
  const change = (shader: WebGLProgramParametersWithUniforms) => {
    shader.vertexShader = solidVertexShader(shader.vertexShader, dimensions);
    shader.fragmentShader = litFragmentShader(shader.fragmentShader, isStudio, isColored);
  };
  const settings = { shadowSide: DoubleSide, ...(material?.transparent ? {} : SMOOTH_OUTLINES) };
  patchMaterial(material, uniforms, `principia-impostor-${dimensions}-${isStudio}`, change, settings);
}

/**
 * Smooth outlines where the target is multisampled. The blend keeps the canvas opaque: coverage must not be read as
 * transparency of the page.
 */
const SMOOTH_OUTLINES = {
  alphaToCoverage: true,
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: ZeroFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneFactor,
} as const;

function shadowFragmentShader(stock: string): string {
  const chunks = {
    clipping_planes_pars_fragment: `#include <clipping_planes_pars_fragment>
      #define CASTS_SHADOW
      ${impostorFragmentPars}${impostorSolidPars}`,
    clipping_planes_fragment: '#include <clipping_planes_fragment>\nmeetSolid();',
    logdepthbuf_fragment: '',
  };
  return replaceChunks(stock, chunks, ['clipping_planes_pars_fragment', 'clipping_planes_fragment'])
    .replaceAll('vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ]', 'impostorClip.z / impostorClip.w')
    .replace(
      'vWorldPosition - referencePosition',
      '((vec4(impostorHit, 1.0) - viewMatrix[3]) * viewMatrix).xyz - referencePosition',
    );
}

/** Materials that draw impostors into the shadow maps of directional, spot (`depth`) and point lights (`distance`). */
export function createImpostorShadowMaterials(
  uniforms: Uniforms,
  dimensions: 2 | 3,
): { depth: MeshDepthMaterial; distance: MeshDistanceMaterial } {
  const depth = new MeshDepthMaterial({ depthPacking: RGBADepthPacking });
  const distance = new MeshDistanceMaterial();
  for (const material of [depth, distance]) {
    patchMaterial(material, uniforms, `principia-impostor-shadow-${dimensions}`, (shader) => {
      shader.vertexShader = solidVertexShader(shader.vertexShader, dimensions);
      shader.fragmentShader = shadowFragmentShader(shader.fragmentShader);
    });
  }
  return { depth, distance };
}

/** The unlit pass over the solids: outlines (`ring`) cover, spots (`glow`) add. One blend does both. */
export function createFlatMaterial(uniforms: Uniforms, dimensions: 2 | 3): ShaderMaterial {
  return new ShaderMaterial({
    uniforms,
    vertexShader: flatVertexShader(`${bodyPull(dimensions)}${drawsFlats}${impostorVertexPars}`),
    fragmentShader: flatFragmentShader(impostorFragmentPars),
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
  });
}
