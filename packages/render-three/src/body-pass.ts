import type { BodySource } from '@principia/render-core';
import type { BufferGeometry, ColorRepresentation, Material, Mesh } from 'three';

/** Options of `createBodyMesh`. */
export interface BodyMeshOptions {
  /** The bodies, by `worldSource`. */
  source: BodySource;
  /** Colour of bodies whose colour is zero; default a light blue, 0x8fb8ff. */
  defaultColor?: ColorRepresentation;
  /**
   * Any mesh material of three, used for these bodies alone until they are destroyed: it is rewritten to read the columns.
   * Default: impostors
   * are lit by a light that moves with the camera, and meshes are a `MeshStandardMaterial`.
   */
  material?: Material;
  /**
   * `impostor`: exact balls and boxes worked out for each pixel, the cheapest for many bodies. `mesh`: instances of
   * triangles, which can wear texture maps and any `geometry`. Default `impostor`, or `mesh` where `segments` or
   * `geometry` is given.
   */
  form?: 'impostor' | 'mesh';
  /** Segments around a ball in `mesh` form, at least 3; default 16. */
  segments?: number;
  /**
   * Geometry of all bodies instead of balls and boxes, in units of the drawn radius; implies the form `mesh`. Default
   * none.
   */
  geometry?: BufferGeometry;
  /**
   * Smallest drawn radius in device pixels, so that distant bodies neither vanish nor flicker; default 0.75. Impostors
   * only. Bodies with neither a size nor a collider are not drawn.
   */
  minPixelRadius?: number;
  /** Whether bodies cast shadows. Default false. */
  castShadow?: boolean;
  /** Whether shadows fall on bodies. Default false. */
  receiveShadow?: boolean;
}

/** A mesh and whether any body needs it. */
export interface BodyPass {
  readonly mesh: Mesh;
  /** Version of the membership of its last update. */
  membership: number;
  isNeeded(): boolean;
  setCount(count: number): void;
  destroy(): void;
}
