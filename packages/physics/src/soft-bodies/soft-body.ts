// A soft body: a skin of springs around a gas, a ring in 2D and a subdivided icosahedron in 3D.

import { assertUsable } from '../ecs/guards.ts';
import { belongsTo } from '../ecs/id-lists.ts';
import { checkKeys, checkNumber, checkVector, checkWhole, type VectorInput } from '../errors/validate.ts';
import { cos, sin } from '../math/elementary.ts';
import type { Force, PhysicsWorld } from '../world/types.ts';
import { enclosedGas } from './gas.ts';
import { icosphere } from './icosphere.ts';
import {
  checkStiffness,
  type Network,
  SPRING_OPTIONS,
  SpringList,
  type SpringOptions,
  spawnNetwork,
} from './network.ts';

/** Options of `createSoftBody`. */
export interface SoftBodyOptions extends SpringOptions {
  /** Position of the centre, m. */
  readonly centre: VectorInput;
  /** Radius, m. */
  readonly radius: number;
  /** Number of nodes of the ring in 2D, default 24; number of subdivisions of the icosahedron in 3D, default 2. */
  readonly detail?: number;
  /** Mass of the whole body, kg; the gas is massless. */
  readonly mass: number;
  /** Stiffness of the springs of the skin, N/m. */
  readonly stiffness: number;
  /** Initial pressure of the gas, relative to the outside, Pa. */
  readonly pressure: number;
  /** Pressure outside, Pa; default 0. */
  readonly ambient?: number;
}

/** A soft body: its springs, its faces and its gas. */
export interface SoftBody extends Network {
  /** Entity ids of the corners of its faces: two per edge in 2D, three per triangle in 3D. */
  readonly faces: Uint32Array;
  /** The force of its gas, which is in `world.forces`. */
  readonly gas: Force;
}

const OPTIONS = ['centre', 'radius', 'detail', 'mass', 'stiffness', 'pressure', 'ambient', ...SPRING_OPTIONS];

interface Skin {
  /** Unit vectors, three numbers each. */
  readonly points: number[];
  readonly faces: number[];
}

/**
 * Creates a soft body at rest and adds its gas to `world.forces`. The skin is unstretched, so the body expands at
 * first.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_REENTRANT (during a step), E_DESTROYED
 */
export function createSoftBody(world: PhysicsWorld, options: SoftBodyOptions): SoftBody {
  assertUsable(world);
  checkKeys(options, 'createSoftBody', OPTIONS);
  const centre = checkVector(options.centre, 'softBody.centre');
  const radius = checkNumber(options.radius, 'softBody.radius', { above: 0 });
  const mass = checkNumber(options.mass, 'softBody.mass', { above: 0 });
  const stiffness = checkStiffness(options.stiffness, 'softBody.stiffness');
  const pressure = checkNumber(options.pressure, 'softBody.pressure', { min: 0, max: 1e30 });
  const ambient = checkNumber(options.ambient ?? 0, 'softBody.ambient', { min: 0, max: 1e30 });
  const flat = world.dimensions === 2;
  const skin = flat ? ring(options.detail ?? 24) : icosphere(options.detail ?? 2);
  const count = skin.points.length / 3;
  const coordinates = (axis: number, start: number) =>
    Float64Array.from({ length: count }, (_, i) => start + radius * skin.points[3 * i + axis]);
  const position = {
    x: coordinates(0, centre.x),
    y: coordinates(1, centre.y),
    z: flat ? centre.z : coordinates(2, centre.z),
  };
  const size = enclosedVolume(skin, flat) * (flat ? radius * radius : radius * radius * radius);
  const volume = checkNumber(size, 'softBody: its volume', { above: 0, max: 1e30 });
  const amount = checkNumber((pressure + ambient) * volume, 'softBody: pressure times volume', { max: 1e30 });
  const list = edgeSprings(skin, flat ? 2 : 3, radius, stiffness);
  const { nodes, springs } = spawnNetwork(world, count, { position, mass: mass / count }, list, options);
  const faces = belongsTo(
    world,
    Uint32Array.from(skin.faces, (node) => nodes[node]),
  );
  const gas = enclosedGas({ faces, corners: flat ? 2 : 3, amount, ambient, reference: volume });
  world.forces.push(gas);
  return { nodes, springs, faces, gas };
}

/** A ring, counter-clockwise, so that the inside is to the left of each edge. */
function ring(detail: number): Skin {
  const count = checkWhole(detail, 'softBody.detail', 3, 1e6);
  const points: number[] = [];
  const faces: number[] = [];
  for (let i = 0; i < count; i++) {
    const angle = (2 * Math.PI * i) / count;
    points.push(cos(angle), sin(angle), 0);
    faces.push(i, (i + 1) % count);
  }
  return { points, faces };
}

/** Returns one spring per edge of the skin. */
function edgeSprings({ points, faces }: Skin, corners: 2 | 3, radius: number, stiffness: number): SpringList {
  const list = new SpringList();
  for (let f = 0; f < faces.length; f += corners) {
    for (let k = 0; k < (corners === 2 ? 1 : 3); k++) {
      const [a, b] = [faces[f + k], faces[f + ((k + 1) % corners)]];
      // In a closed surface every edge belongs to two triangles, in opposite directions.
      if (corners === 3 && a > b) continue;
      const [x, y, z] = [0, 1, 2].map((axis) => points[3 * b + axis] - points[3 * a + axis]);
      list.add(a, b, stiffness, radius * Math.sqrt(x * x + y * y + z * z));
    }
  }
  return list;
}

function enclosedVolume({ points, faces }: Skin, flat: boolean): number {
  let sum = 0;
  for (let f = 0; f < faces.length; f += flat ? 2 : 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * (faces[f + k] ?? 0));
    const [ax, ay, az, bx, by, bz] = [0, 1, 2, 3, 4, 5].map((i) => points[(i < 3 ? a : b - 3) + i]);
    if (flat) sum += (ax * by - ay * bx) / 2;
    else {
      const [cx, cy, cz] = [0, 1, 2].map((axis) => points[c + axis]);
      sum += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
    }
  }
  return sum;
}
