// Upthrust on a hull of any outline in the plane, at its centre of buoyancy, so that it rights or capsizes the body.
//
//   F = -ρ V (A'/A) g        τ = r_B × F        potential  U = ρ V g/A ∫ depth dA'
//
//   A'/A  share of the outline's area under the surface    r_B  centroid of that part, from the centre of mass, m
//   V  volume of the whole hull, m³: Hull.volume
//
// Euler, Scientia navalis (1749); the outline is cut at the surface and summed by the shoelace formula, so it may be
// concave. Acts on bodies whose Hull.shape is the number given here, turned by their Rotation. In 2D only. With an
// Inertia and an AngularVelocity the body turns; damp it with `angularDrag`. Cost: some 10 ns a vertex.
import { PhysicsError } from '../faults/physics-error';
import { checkKeys, checkList, checkNumber, checkWhole } from '../faults/validate';
import { allocate } from '../store/arena';
import { resource } from '../store/resource';
import { PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { hullTable, type Pool, poolState } from './pool';

export interface PolygonHull {
  /** Number by which bodies name this outline: `hull: { volume, shape }`. 2 and up. */
  readonly shape: number;
  /** Corners in order, m, from the centre of mass of a body that is not turned. */
  readonly vertices: readonly { readonly x: number; readonly y: number }[];
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function polygonUpthrust(pool: Pool, hull: PolygonHull): Force {
  const { at, parameters } = poolState(pool, 'polygonUpthrust');
  checkKeys(hull, 'polygonUpthrust', ['shape', 'vertices']);
  const shape = checkWhole(hull.shape, 'polygonUpthrust.shape', 2, 1000);
  const outline = anticlockwise(hull.vertices);
  const area = areaOf(outline);
  const cornersAt = resource((world) => {
    const address = allocate(world.internal.arena, outline.byteLength, 'a hull');
    new Float64Array(world.memory.buffer, address, outline.length).set(outline);
    return address;
  });
  return {
    name: 'polygon upthrust',
    equation: 'F = -ρ V (A′/A) g, τ = r_B × F',
    parameters: { ...parameters, area: { unit: 'm²', value: area } },
    reads: ['Position', 'Rotation', 'Hull'],
    local: true,
    timeless: true,
    turns: true,
    accumulate(world, first, last) {
      if (world.dimensions === 3 || world.internal.counts.Hull === 0) return;
      const { force, torque } = world.scratch.at;
      const [pool, hulls, angle] = [at(world), hullTable(world), world.addresses.Rotation.angle];
      const [corners, count] = [cornersAt(world), outline.length / 2];
      const { x, y } = force;
      const kernels = lawKernels(world);
      kernels.polygonUpthrust(pool, hulls, shape, corners, count, area, angle, x, y, torque.z, first, last);
    },
    potential(world) {
      if (world.dimensions === 3 || world.internal.counts.Hull === 0) return 0;
      const [pool, hulls, angle] = [at(world), hullTable(world), world.addresses.Rotation.angle];
      const [corners, count, rows] = [cornersAt(world), outline.length / 2, world.lastId + 1];
      return lawKernels(world).polygonPotential(pool, hulls, shape, corners, count, area, angle, rows);
    },
  };
}

function anticlockwise(vertices: PolygonHull['vertices']): Float64Array {
  checkList(vertices, 'polygonUpthrust.vertices');
  const count = vertices?.length ?? 0;
  const outline = new Float64Array(2 * count);
  for (let i = 0; i < count; i++) {
    outline[2 * i] = checkNumber(vertices[i]?.x, `polygonUpthrust.vertices[${i}].x`, PLACES);
    outline[2 * i + 1] = checkNumber(vertices[i]?.y, `polygonUpthrust.vertices[${i}].y`, PLACES);
  }
  const area = areaOf(outline);
  if (count < 3 || area === 0) {
    throw new PhysicsError('E_RANGE', 'polygonUpthrust needs at least three vertices that enclose an area.', {
      field: 'vertices',
      value: vertices,
    });
  }
  return area > 0 ? outline : reversed(outline);
}

function areaOf(outline: Float64Array): number {
  let twice = 0;
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    twice += outline[i] * outline[j + 1] - outline[j] * outline[i + 1];
  }
  return twice / 2;
}

function reversed(outline: Float64Array): Float64Array {
  const count = outline.length / 2;
  return outline.map((_, i) => outline[2 * (count - 1 - (i >> 1)) + (i & 1)]);
}
