import { SHAPES } from '@principia/render-core';
import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  MeshStandardMaterial,
  Sphere,
  SphereGeometry,
  Vector3,
} from 'three';
import type { BodyMeshOptions, BodyPass } from './body-pass.ts';
import type { BodyTextures } from './body-textures.ts';
import { restoreMaterial } from './material-patch.ts';
import { createMeshShadowMaterials, drawnShapes, patchMeshMaterial } from './mesh-material.ts';

/** One instanced mesh a geometry, all with one material: balls and boxes, or the application's own geometry. */
export function createInstancedPasses(options: BodyMeshOptions, textures: BodyTextures): BodyPass[] {
  const { source, segments = 16 } = options;
  if (!Number.isInteger(segments) || segments < 3) {
    throw new Error(`segments must be a whole number of at least 3, got ${segments}`);
  }
  checkGeometry(options.geometry);
  const material = options.material ?? new MeshStandardMaterial({ roughness: 0.55, metalness: 0 });
  patchMeshMaterial(material, textures.uniforms, source.dimensions);
  const shadow = createMeshShadowMaterials(textures.uniforms, source.dimensions);
  const pass = (geometry: BufferGeometry, drawn: number, isNeeded: () => boolean): BodyPass => {
    const instanced = instancedGeometry(geometry, drawn, textures.ids);
    const mesh = new Mesh(instanced, material);
    mesh.customDepthMaterial = shadow.depth;
    mesh.customDistanceMaterial = shadow.distance;
    return {
      mesh,
      membership: Number.NaN,
      isNeeded,
      setCount: (count) => showInstances(instanced, count),
      destroy() {
        for (const resource of [instanced, material, shadow.depth, shadow.distance]) resource.dispose();
        restoreMaterial(material);
      },
    };
  };
  const { style } = textures;
  if (options.geometry !== undefined) return [pass(options.geometry, drawnShapes.solids, () => style.hasSolids)];
  const ball = new SphereGeometry(1, segments, Math.max(2, Math.round(segments / 2)));
  return [
    pass(ball, drawnShapes.balls, () => style.hasBalls),
    pass(new BoxGeometry(2, 2, 2), drawnShapes.boxes, () => style.hasShape(SHAPES.box)),
  ];
}

function checkGeometry(geometry: BufferGeometry | undefined): void {
  if (geometry === undefined || geometry?.attributes?.position !== undefined) return;
  throw new Error(`geometry must be one of three with positions, such as new ConeGeometry(1, 2), got ${geometry}`);
}

/** The vertices of `base` with the ids to draw as an instanced attribute over the very array that holds them. */
function instancedGeometry(base: BufferGeometry, drawn: number, ids: Uint32Array): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  // Copies, since freeing this geometry frees its buffers on the GPU.
  geometry.setIndex(base.index?.clone() ?? null);
  for (const [name, attribute] of Object.entries(base.attributes)) geometry.setAttribute(name, attribute.clone());
  const vertices = base.attributes.position.count;
  geometry.setAttribute('drawnShape', new BufferAttribute(new Float32Array(vertices).fill(drawn), 1));
  geometry.setAttribute('eid', new InstancedBufferAttribute(ids, 1).setUsage(DynamicDrawUsage));
  geometry.boundingSphere = new Sphere(new Vector3(), Number.POSITIVE_INFINITY);
  geometry.instanceCount = 0;
  return geometry;
}

function showInstances(geometry: InstancedBufferGeometry, count: number): void {
  const eid = geometry.attributes.eid as InstancedBufferAttribute;
  eid.clearUpdateRanges();
  eid.addUpdateRange(0, count);
  eid.needsUpdate = true;
  geometry.instanceCount = count;
}
