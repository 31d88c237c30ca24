/** The room in 3D: a floor with a grid of metres, the edges of the walls, and a lamp. */
import { createBoxFrame, createSegmentLines } from '@principia/render-three';
import type { BouncingBalls } from '@principia/scenes';
import {
  Box3,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  PlaneGeometry,
  Vector3,
} from 'three';

export interface Room3D {
  readonly object: Object3D;
  destroy(): void;
}

/** @param hasShadows whether the lamp casts shadows */
export function createRoom3D({ room }: BouncingBalls, hasShadows: boolean): Room3D {
  const min = new Vector3(room.min.x, room.min.y, room.min.z);
  const max = new Vector3(room.max.x, room.max.y, room.max.z);
  const frame = createBoxFrame(new Box3(min, max), { color: 0x8fa0e0, width: 1.5 });
  const grid = createSegmentLines({ color: 0x6876bd, width: 1 });
  for (let x = Math.ceil(min.x); x <= max.x; x++) grid.add(x, min.y, min.z, x, min.y, max.z);
  for (let z = Math.ceil(min.z); z <= max.z; z++) grid.add(min.x, min.y, z, max.x, min.y, z);
  const size = new Vector3().subVectors(max, min);
  const floor = new Mesh(new PlaneGeometry(size.x, size.z), new MeshLambertMaterial({ color: 0x39457a }));
  floor.rotation.x = -Math.PI / 2;
  // Slightly below the grid to avoid z-fighting.
  floor.position.set((min.x + max.x) / 2, min.y - 0.004, (min.z + max.z) / 2);
  floor.receiveShadow = hasShadows;
  const lamp = createLamp(min, max, hasShadows);
  const object = new Group().add(floor, grid.object, frame.object, lamp, lamp.target);
  object.add(new HemisphereLight(0xdfe6ff, 0x4a4270, 1.5));
  return {
    object,
    destroy() {
      frame.destroy();
      grid.destroy();
      lamp.dispose();
      floor.geometry.dispose();
      floor.material.dispose();
    },
  };
}

/** A lamp at the upper left in front; its shadow map covers exactly the room. */
function createLamp(min: Vector3, max: Vector3, hasShadows: boolean): DirectionalLight {
  const lamp = new DirectionalLight(0xfff4e0, 2.6);
  const middle = new Vector3().addVectors(min, max).multiplyScalar(0.5);
  const reach = min.distanceTo(max) / 2;
  lamp.target.position.copy(middle);
  lamp.position.copy(middle).addScaledVector(new Vector3(-0.35, 1, 0.45).normalize(), 2 * reach);
  lamp.castShadow = hasShadows;
  Object.assign(lamp.shadow.camera, {
    left: -reach,
    right: reach,
    top: reach,
    bottom: -reach,
    near: 0,
    far: 4 * reach,
  });
  lamp.shadow.mapSize.set(2048, 2048);
  lamp.shadow.radius = 4;
  lamp.shadow.bias = -0.0005;
  return lamp;
}
