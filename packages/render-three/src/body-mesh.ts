import { type BodySource, checkOptions, type OptionNames, sourceOf } from '@principia/render-core';
import { Group, type Intersection, Mesh, type Object3D, type Raycaster, type WebGLRenderer } from 'three';
import { assertLive } from './assert-live.ts';
import { colorBytes } from './body-color.ts';
import type { BodyMeshOptions, BodyPass } from './body-pass.ts';
import { pickBody } from './body-picker.ts';
import { BodyTextures } from './body-textures.ts';
import {
  createFlatMaterial,
  createImpostorShadowMaterials,
  createStudioMaterial,
  patchImpostorMaterial,
} from './impostor-material.ts';
import { createInstancedPasses } from './instanced-passes.ts';
import { restoreMaterial } from './material-patch.ts';
import { QuadGeometry } from './quad-geometry.ts';
import { TargetPixels } from './target-pixels.ts';

/** Bodies as one object of a scene. */
export interface BodyMesh {
  /**
   * Add it to the scene. `Raycaster` hits on it carry the body's id in `instanceId`. They are those of `pickBody`: of the ball of
   * a body's drawn radius, or the cube of a `box`, whatever its collider or `geometry` is. A ray through the hole of a torus hits.
   */
  readonly object: Object3D;
  /**
   * Call once a frame before rendering. Sends to the GPU what the source says has changed.
   *
   * @param alpha 0 draws the previous step, 1 the present one, between them a blend
   * @throws Error when it is no number, or the mesh was destroyed
   */
  update(alpha: number): void;
  /**
   * Draws an f64 world relative to a point near the camera, metres: bodies 10⁹ m from zero keep their millimetres.
   * Does nothing in an f32 world.
   */
  setOrigin(x: number, y: number, z: number): void;
  /**
   * Frees textures, geometries and materials; remove `object` from the scene yourself. A material of your own is as it was, and
   * may draw other bodies.
   */
  destroy(): void;
}

const OPTION_NAMES: OptionNames<BodyMeshOptions> = {
  source: true,
  defaultColor: true,
  material: true,
  form: true,
  segments: true,
  geometry: true,
  minPixelRadius: true,
  castShadow: true,
  receiveShadow: true,
};

/**
 * Draws the bodies of a source: `disc` as a ball, `box` as a cube, `markedDisc` as a beach ball, `ring` as the outline
 * of a ball and `glow` as a spot of added light. A 2D world lies in the plane z = 0; as impostors, bodies whose colliders
 * are polygons are plates, as thick as they are narrow, and capsules are capsules.
 *
 * @throws Error when there is no source, `segments` is not a whole number of at least 3, `geometry` is none or given for impostors, `material`
 * is none or draws another body mesh, an option does not exist, or a column has another length than `rows`
 */
export function createBodyMesh(options: BodyMeshOptions): BodyMesh {
  const source = sourceOf(options, 'createBodyMesh');
  checkOptions(options, OPTION_NAMES, 'createBodyMesh');
  const { defaultColor = 0x8fb8ff, segments, geometry, minPixelRadius = 0.75 } = options;
  const form = options.form ?? (segments !== undefined || geometry !== undefined ? 'mesh' : 'impostor');
  if (form === 'impostor' && geometry !== undefined) {
    throw new Error("impostors have no geometry: leave out form: 'impostor' or the geometry");
  }
  const textures = new BodyTextures(source, colorBytes(defaultColor), geometry !== undefined);
  const target = new TargetPixels();
  const uniforms = textures.uniforms;
  uniforms.pixelHeight = target.height;
  uniforms.multisampled = target.multisampled;
  uniforms.minPixelRadius = { value: minPixelRadius };
  const passes = form === 'mesh' ? createInstancedPasses(options, textures) : [createImpostorPass(options, textures)];
  passes.push(createFlatPass(source, textures));
  const object = new Group();
  let drawnAlpha = 1;
  let live = true;
  for (const { mesh } of passes) object.add(prepared(mesh, options, target, textures));
  object.raycast = (raycaster, hits) => raycastBodies(source, object, drawnAlpha, raycaster, hits);
  return {
    object,
    update(alpha) {
      assertLive(live, 'createBodyMesh');
      textures.refresh(alpha);
      drawnAlpha = alpha;
      for (let i = 0; i < passes.length; i++) showPass(passes[i], source.count, textures);
    },
    setOrigin(x, y, z) {
      textures.centres.setOrigin(x, y, z);
      for (const { mesh } of passes) mesh.position.copy(textures.centres.origin);
    },
    destroy() {
      live = false;
      for (const pass of passes) pass.destroy();
      textures.dispose();
    },
  };
}

/** A pass without bodies is not told their number, so its index buffer may never be created. */
function showPass(pass: BodyPass, count: number, textures: BodyTextures): void {
  pass.mesh.visible = count > 0 && pass.isNeeded();
  if (!pass.mesh.visible || pass.membership === textures.membershipVersion) return;
  pass.membership = textures.membershipVersion;
  pass.setCount(count);
}

function prepared(mesh: Mesh, options: BodyMeshOptions, target: TargetPixels, textures: BodyTextures): Mesh {
  mesh.frustumCulled = false;
  mesh.castShadow = options.castShadow ?? false;
  mesh.receiveShadow = options.receiveShadow ?? false;
  // A shadow is drawn to a map of its own size: with the pixels of a tiny canvas each body would cover all of it.
  const prepare = (renderer: WebGLRenderer) => {
    target.read(renderer);
    textures.send(renderer);
  };
  mesh.onBeforeRender = prepare;
  mesh.onBeforeShadow = prepare;
  mesh.raycast = () => {}; // the group answers for all passes
  return mesh;
}

function createImpostorPass(options: BodyMeshOptions, textures: BodyTextures): BodyPass {
  const { dimensions } = options.source;
  const geometry = new QuadGeometry();
  const material = options.material ?? createStudioMaterial();
  patchImpostorMaterial(material, textures.uniforms, dimensions);
  const mesh = new Mesh(geometry, material);
  const shadow = createImpostorShadowMaterials(textures.uniforms, dimensions);
  mesh.customDepthMaterial = shadow.depth;
  mesh.customDistanceMaterial = shadow.distance;
  return {
    mesh,
    membership: Number.NaN,
    isNeeded: () => textures.style.hasSolids,
    setCount: (count) => geometry.setCount(count),
    destroy() {
      for (const resource of [geometry, material, shadow.depth, shadow.distance]) resource.dispose();
      restoreMaterial(material);
    },
  };
}

/** Outlines and glows: blended over the solids, never lit, without shadows. */
function createFlatPass(source: BodySource, textures: BodyTextures): BodyPass {
  const geometry = new QuadGeometry();
  const material = createFlatMaterial(textures.uniforms, source.dimensions);
  return {
    mesh: new Mesh(geometry, material),
    membership: Number.NaN,
    isNeeded: () => textures.style.hasFlats,
    setCount: (count) => geometry.setCount(count),
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}

function raycastBodies(
  source: BodySource,
  object: Object3D,
  alpha: number,
  raycaster: Raycaster,
  hits: Intersection[],
): void {
  const ray = raycaster.ray.clone().applyMatrix4(object.matrixWorld.clone().invert());
  const pick = { id: 0, distance: 0 };
  if (pickBody(source, ray, { alpha, result: pick }) === 0) return;
  const point = ray.at(pick.distance, ray.origin.clone()).applyMatrix4(object.matrixWorld);
  const distance = raycaster.ray.origin.distanceTo(point);
  if (distance < raycaster.near || distance > raycaster.far) return;
  hits.push({ distance, point, object, instanceId: pick.id });
}
