/** The rings of the course; the next one glows. */
import { Group, Mesh, MeshBasicMaterial, Quaternion, TorusGeometry, Vector3 } from 'three';
import { RING_RADIUS, RINGS } from './course.ts';
import type { FlightLog } from './referee.ts';

const NEXT = 0xffb020;
const LATER = 0xf6f1e0;

export function createRingsModel(): { readonly object: Group; update(log: FlightLog): void } {
  const object = new Group();
  const geometry = new TorusGeometry(RING_RADIUS, 1.6, 8, 48);
  const forwards = new Vector3(0, 0, 1);
  const direction = new Vector3();
  const turn = new Quaternion();
  const rings = RINGS.map((ring) => {
    const material = new MeshBasicMaterial({ color: LATER, transparent: true, opacity: 0.7, fog: false });
    const mesh = new Mesh(geometry, material);
    mesh.position.copy(ring.at);
    mesh.quaternion.copy(turn.setFromUnitVectors(forwards, direction.copy(ring.direction)));
    object.add(mesh);
    return mesh;
  });
  return {
    object,
    update(log) {
      for (let i = 0; i < rings.length; i++) {
        rings[i].visible = i >= log.ring && i < log.ring + 3;
        rings[i].material.color.setHex(i === log.ring ? NEXT : LATER);
        rings[i].material.opacity = i === log.ring ? 0.95 : 0.35;
      }
    },
  };
}
