import { SHAPES } from '@principia/render-core';
import { type Material, MeshDepthMaterial, MeshDistanceMaterial, RGBADepthPacking } from 'three';
import { patchMaterial, replaceChunks, showsNormals, type Uniforms } from './material-patch.ts';
import { bodyPull } from './shaders/body-pull.ts';
import { beachBall } from './shaders/impostor.ts';

/** Which bodies a geometry draws, stored with each of its vertices as `drawnShape` so that one material serves all. */
export const drawnShapes = { solids: 0, balls: 1, boxes: 2 } as const;

const vertexPars = /* glsl */ `
attribute uint eid;
attribute float drawnShape;
flat varying vec4 vBodyColor;
flat varying uint vBodyShape;
varying vec3 vBodyPoint;

bool drawsShape(uint shape) {
  if (shape == ${SHAPES.ring}u || shape == ${SHAPES.glow}u) return false;
  return drawnShape == 0.0 || (drawnShape == 2.0) == (shape == ${SHAPES.box}u);
}

void pullInstance() {
  ivec2 at = cellOf(int(eid));
  pullStyle(at);
  bodyCentre = vec3(0.0);
  bodyTurn = vec4(0.0, 0.0, 0.0, 1.0);
  // A body that another geometry draws shrinks to a point, which no pixel shows.
  if (!(bodyRadius > 0.0 && drawsShape(bodyShape))) bodyRadius = 0.0;
  if (bodyRadius == 0.0) return;
  bodyCentre = pullCentre(at);
  bodyTurn = pullTurn(at);
}
`;

function vertexShader(stock: string, dimensions: 2 | 3): string {
  const chunks = {
    clipping_planes_pars_vertex: `#include <clipping_planes_pars_vertex>\n${bodyPull(dimensions)}${vertexPars}`,
    uv_vertex: '#include <uv_vertex>\npullInstance();',
    beginnormal_vertex: 'vec3 objectNormal = turned(bodyTurn, normal);',
    begin_vertex: `vec3 transformed = bodyCentre + bodyRadius * turned(bodyTurn, position);
      vBodyPoint = position;
      vBodyColor = bodyColor;
      vBodyShape = bodyShape;`,
  };
  return replaceChunks(stock, chunks, ['clipping_planes_pars_vertex', 'uv_vertex', 'begin_vertex']);
}

function fragmentShader(stock: string, isColored: boolean): string {
  const pars = `#include <clipping_planes_pars_fragment>
    flat varying vec4 vBodyColor;
    flat varying uint vBodyShape;
    varying vec3 vBodyPoint;
    ${beachBall}`;
  const color = `#include <color_fragment>
    vec3 pattern = beachBall(vBodyPoint, vBodyColor.rgb);
    diffuseColor.rgb *= vBodyShape == ${SHAPES.markedDisc}u ? pattern : vBodyColor.rgb;`;
  const chunks = { clipping_planes_pars_fragment: pars, color_fragment: color };
  const required = ['clipping_planes_pars_fragment', ...(isColored ? ['color_fragment'] : [])];
  return replaceChunks(stock, chunks, required);
}

/**
 * Makes `material` draw one instance of its geometry for each body: any mesh material of three, with its maps. The
 * geometry is in radii and has an instanced attribute `eid`. The material's colour multiplies the bodies' colours.
 */
export function patchMeshMaterial(material: Material, uniforms: Uniforms, dimensions: 2 | 3): void {
  patchMaterial(material, uniforms, `principia-mesh-${dimensions}`, (shader) => {
    shader.vertexShader = vertexShader(shader.vertexShader, dimensions);
    shader.fragmentShader = fragmentShader(shader.fragmentShader, !showsNormals(material));
  });
}

/** Materials that draw the instances into the shadow maps of directional and spot (`depth`) and point lights. */
export function createMeshShadowMaterials(
  uniforms: Uniforms,
  dimensions: 2 | 3,
): { depth: MeshDepthMaterial; distance: MeshDistanceMaterial } {
  const depth = new MeshDepthMaterial({ depthPacking: RGBADepthPacking });
  const distance = new MeshDistanceMaterial();
  for (const material of [depth, distance]) {
    patchMaterial(material, uniforms, `principia-mesh-shadow-${dimensions}`, (shader) => {
      shader.vertexShader = vertexShader(shader.vertexShader, dimensions);
    });
  }
  return { depth, distance };
}
