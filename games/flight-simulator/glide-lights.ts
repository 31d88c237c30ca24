/**
 * The four lights beside the runway by which pilots judge their path: each is white seen from above its angle and red from
 * below. Two of each mean four degrees, which is right. ICAO Annex 14, section 5.3.5, with a steeper path.
 */
import { BoxGeometry, Group, Mesh, MeshBasicMaterial, type Vector3 } from 'three';
import { RUNWAY } from './terrain.ts';

const DEGREE = Math.PI / 180;
const ANGLES = [3, 3.7, 4.4, 5.1];
/** Where the wheels should touch, m. */
const X = 250 - RUNWAY.length / 2;

export function createGlideLights(): { readonly object: Group; update(eye: Vector3): void } {
  const object = new Group();
  const geometry = new BoxGeometry(1.2, 1.2, 1.2);
  const lights = ANGLES.map((angle, i) => {
    const mesh = new Mesh(geometry, new MeshBasicMaterial({ fog: false }));
    mesh.position.set(X, 0.8, -RUNWAY.width / 2 - 8 - 4 * i);
    object.add(mesh);
    return { mesh, angle: angle * DEGREE };
  });
  return {
    object,
    update({ x, y, z }) {
      for (const { mesh, angle } of lights) {
        const isAbove = Math.atan2(y, Math.hypot(X - x, z)) > angle;
        mesh.material.color.setHex(isAbove ? 0xffffff : 0xff3020);
        // They are seen from afar, as real lamps are.
        mesh.scale.setScalar(1 + Math.hypot(X - x, z) / 700);
      }
    },
  };
}
