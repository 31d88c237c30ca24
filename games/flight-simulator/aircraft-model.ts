/** The picture of the aeroplane, in its own axes: x forwards, y up, z to the right. */
import {
  BoxGeometry,
  type BufferGeometry,
  CircleGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
} from 'three';
import { AIRCRAFT } from './aircraft.ts';
import { WHEELS } from './landing-gear.ts';
import type { Surfaces } from './pilot.ts';

export interface AircraftModel {
  readonly object: Group;
  /** Shows what is seen from outside, or by the pilot in the cabin. */
  seenFrom(isCockpit: boolean): void;
  /** @param turned angle of the propeller, rad */
  update(surfaces: Readonly<Surfaces>, throttle: number, turned: number): void;
}

export function createAircraftModel(color: number): AircraftModel {
  const white = new MeshLambertMaterial({ color: 0xf3f5f7 });
  const paint = new MeshLambertMaterial({ color });
  const dark = new MeshLambertMaterial({ color: 0x2a3340 });
  const glass = new MeshLambertMaterial({ color: 0x7fb3d9, emissive: 0x15304a });
  const object = new Group();
  const hull = new Group();
  const cockpit = new Group();
  object.add(hull, cockpit);
  const add = (
    geometry: BufferGeometry,
    material: MeshLambertMaterial,
    x: number,
    y: number,
    z: number,
    parent = hull,
  ) => {
    const mesh = new Mesh(geometry, material);
    mesh.position.set(x, y, z);
    parent.add(mesh);
    return mesh;
  };
  const along = (front: number, back: number, length: number) =>
    new CylinderGeometry(front, back, length, 10).rotateZ(-Math.PI / 2);
  add(along(0.62, 0.66, 2.4), white, 0.2, 0, 0);
  add(along(0.42, 0.6, 1), paint, 1.85, -0.12, 0);
  add(along(0.62, 0.16, 4.2), white, -3.1, 0.05, 0);
  add(new BoxGeometry(1.9, 0.55, 1), glass, 0.1, 0.5, 0);
  add(new BoxGeometry(1.5, 0.13, AIRCRAFT.span - 3.2), white, 0.15, 0.83, 0, object);
  for (const side of [-1, 1]) add(new BoxGeometry(1.35, 0.12, 1.6), paint, 0.15, 0.87, side * 4.7, object);
  const ailerons = [-1, 1].map((side) =>
    hinged(object, new BoxGeometry(0.35, 0.07, 2.6), paint, -0.6, 0.83, side * 3.9),
  );
  add(new BoxGeometry(0.8, 0.08, 3.4), white, -4.7, 0.2, 0);
  const elevator = hinged(hull, new BoxGeometry(0.5, 0.06, 3.4), paint, -5.1, 0.2, 0);
  add(new BoxGeometry(0.9, 1.3, 0.1), white, -4.75, 0.85, 0);
  const rudder = hinged(hull, new BoxGeometry(0.5, 1.3, 0.08), paint, -5.2, 0.85, 0);
  addWheels(add, dark, white);
  // The pilot sees the top of the cowling, a dark panel below the window, and its posts.
  add(new BoxGeometry(1.3, 0.3, 0.8), paint, 2.0, -0.02, 0, cockpit);
  add(new BoxGeometry(0.2, 0.4, 1.6), dark, 1.25, -0.1, 0, cockpit);
  for (const side of [-1, 1]) {
    add(new BoxGeometry(0.05, 0.9, 0.05), dark, 1.2, 0.45, side * 0.72, cockpit).rotation.z = 0.5;
  }
  const disc = new Mesh(
    new CircleGeometry(0.95, 24).rotateY(Math.PI / 2),
    new MeshBasicMaterial({ color: 0xdfe6ee, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false }),
  );
  disc.position.set(2.42, -0.12, 0);
  const blade = add(new BoxGeometry(0.06, 1.9, 0.14), dark, 2.4, -0.12, 0, object);
  object.add(disc);
  return {
    object,
    seenFrom(isCockpit) {
      hull.visible = !isCockpit;
      cockpit.visible = isCockpit;
    },
    update({ aileron, elevator: raised, rudder: right }, throttle, turned) {
      ailerons[0].rotation.z = aileron;
      ailerons[1].rotation.z = -aileron;
      elevator.rotation.z = -raised;
      rudder.rotation.y = right;
      blade.rotation.x = turned;
      disc.material.opacity = 0.05 + 0.15 * throttle;
    },
  };
}

type AddPart = (geometry: BufferGeometry, material: MeshLambertMaterial, x: number, y: number, z: number) => Mesh;

function addWheels(add: AddPart, dark: MeshLambertMaterial, white: MeshLambertMaterial): void {
  for (const { at } of WHEELS) {
    add(new CylinderGeometry(0.22, 0.22, 0.16, 12).rotateX(Math.PI / 2), dark, at.x, at.y + 0.22, at.z);
    const leg = add(new CylinderGeometry(0.05, 0.05, 0.9, 6), white, at.x, at.y + 0.6, at.z * 0.8);
    leg.rotation.x = at.z * 0.4;
  }
}

/** A surface that turns about its front edge. */
function hinged(
  parent: Group,
  geometry: BoxGeometry,
  material: MeshLambertMaterial,
  x: number,
  y: number,
  z: number,
): Group {
  const hinge = new Group();
  hinge.position.set(x, y, z);
  const width = geometry.parameters.width;
  const mesh = new Mesh(geometry.translate(-width / 2, 0, 0), material);
  hinge.add(mesh);
  parent.add(hinge);
  return hinge;
}
