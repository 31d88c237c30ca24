// Buoyancy on a polygonal hull in 2D, applied at its centre of buoyancy, so that it rights or capsizes the body.
//
//   F = -ρ V (A'/A) g        τ = r_B × F        potential  U = ρ V g/A ∫ depth dA'
//
//   A'/A  immersed fraction of the polygon's area    r_B  centroid of the immersed part, from the centre of mass, m
//   V  volume of the whole hull, m³: Hull.volume
//
// Euler, Scientia navalis (1749); the polygon is cut at the surface and summed by the shoelace formula, so it may be
// concave. Acts on bodies whose Hull.shape is the given number, rotated by their Rotation. Corners are relative to the
// centre of mass: a body of the shape `polygon(points)` has its centroid there, so give the shape itself, and not the points. The forces `immersedDrag` and `addedMass` take the hull for an upright box.
// In waves the surface is the plane that touches the wave above the centre of mass: a hull of a quarter of a wavelength heaves a tenth too
// much, one of a whole wavelength as a cork where it should hardly move. 2D only. A body with
// Inertia and AngularVelocity rotates; damp it with `angularDrag`. Cost: a sine and a cosine per body, and about 30
// operations and a division per edge.
import { isShape, type Shape } from '../collision/shapes/2d/shape.ts';
import { Hull } from '../components/hull.ts';
import { Rotation } from '../components/rotation.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, checkList, checkNumber, checkWhole } from '../errors/validate.ts';
import { axial3, type Scalar, select, type Vector, vec3 } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import { type Table, type TableLocation, table } from '../laws/table.ts';
import { type ForceMemory, forceMemory } from '../memory/force-memory.ts';
import type { Force } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';
import { FLUID, FLUID_VOLUME, type FluidVolume, fluidVolumeValues } from './support/fluid-volume.ts';
import { WAVES, waveAt } from './support/waves.ts';

/** A hull in two dimensions, by its number and its corners. */
export interface PolygonHull {
  /** Number of this polygon in `hull: { volume, shape }` of a body; 2 or more. */
  readonly shape: number;
  /** Corners in order, m, relative to the centre of mass of an unrotated body; or its shape, a `polygon` or `box` without rounding. */
  readonly vertices: readonly { readonly x: number; readonly y: number }[] | Shape;
}

/** Parameters of both laws below. */
const HULL = /* @__PURE__ */ { shape: scalar(''), area: scalar('m²') };

const about = {
  name: 'polygon buoyancy',
  formula: 'F = -ρ V (A′/A) g, τ = r_B × F',
  source: 'Euler, Scientia navalis (1749).',
  reads: { hull: Hull, angle: Rotation },
  dimensions: 2 as const,
};

interface HullSymbols {
  readonly hull: { readonly volume: Scalar; readonly shape: Scalar };
  readonly angle: Scalar;
}

interface FluidSymbols {
  readonly density: Scalar;
  readonly gravity: Scalar;
  readonly up: Vector;
  readonly shape: Scalar;
}

/** Mass of the fluid displaced by a whole hull of this shape, kg. */
function displacement({ hull }: HullSymbols, { density, shape }: Omit<FluidSymbols, 'gravity' | 'up'>): Scalar {
  return density.mul(select(hull.shape.equals(shape), hull.volume, 0));
}

/** Its weight, N. */
function weight(body: HullSymbols, fluid: FluidSymbols): Scalar {
  return displacement(body, fluid).mul(fluid.gravity);
}

/** A vector in the body's frame. */
function toBody({ angle }: HullSymbols, { x, y }: Vector): Vector {
  const [c, s] = [angle.cos(), angle.sin()];
  return vec3(x.mul(c).add(y.mul(s)), y.mul(c).sub(x.mul(s)));
}

function upOf(body: HullSymbols, { up }: FluidSymbols): Vector {
  return toBody(body, up);
}

const unbounded = /* @__PURE__ */ defineLaw({
  ...about,
  parameters: { ...FLUID, ...HULL, centroid: vector('m') },
  force: (body, fluid) => fluid.up.mul(weight(body, fluid)),
  torque: (body, fluid) => fluid.centroid.cross(upOf(body, fluid)).mul(weight(body, fluid)),
  potential(body, fluid) {
    const height = fluid.up.dot(body.position).add(upOf(body, fluid).dot(fluid.centroid));
    return weight(body, fluid).mul(height).negate();
  },
});

/** The part of an outline under the surface, in the body's axes. */
interface Submerged {
  /** Depth of the body's centre of mass, m. */
  readonly depth: Scalar;
  readonly up: Vector;
  /** Area, m², and its first moments about the centre of mass, m³. */
  readonly area: Scalar;
  readonly moments: Vector;
}

/** A corner of the polygon, and the vector to the next corner. */
const EDGE = ['x', 'y', 'dx', 'dy'] as const;

interface OutlineSymbols {
  /** Maximum distance of a corner from the centre of mass, m. */
  readonly extent: Scalar;
  readonly edges: Table<(typeof EDGE)[number]>;
}

type FloatingSymbols = HullSymbols & { readonly position: Vector };

const submergedParts = /* @__PURE__ */ new WeakMap<HullSymbols, Submerged>();

/** Returns the immersed part under a level surface, cached because force and torque share the same sums. */
function submerged(
  body: FloatingSymbols,
  fluid: OutlineSymbols & FluidSymbols & { readonly level: Scalar },
): Submerged {
  const immersed =
    submergedParts.get(body) ?? cutOutline(fluid, upOf(body, fluid), fluid.level.sub(fluid.up.dot(body.position)));
  submergedParts.set(body, immersed);
  return immersed;
}

interface SubmergedInWaves extends Submerged {
  /** Force per mass of displaced fluid, m/s². */
  readonly lift: Vector;
}

const partsInWaves = /* @__PURE__ */ new WeakMap<HullSymbols, SubmergedInWaves>();

/** The same under the surface of a wave above the body. */
function submergedInWaves(
  body: FloatingSymbols,
  fluid: OutlineSymbols & FluidSymbols & Parameters<typeof waveAt>[1],
): SubmergedInWaves {
  const known = partsInWaves.get(body);
  if (known !== undefined) return known;
  const { normal, depth, acceleration } = waveAt(body.position, fluid);
  const lift = fluid.up.mul(fluid.gravity).add(acceleration);
  const immersed = { ...cutOutline(fluid, toBody(body, normal), depth), lift };
  partsInWaves.set(body, immersed);
  return immersed;
}

/**
 * Sums over the edges, each cut at the surface that is `depth` above the centre of mass along `up`, in the body's frame, by the shoelace formula, relative to a point of the surface: then
 * the closing edges along the surface contribute nothing. A hull far from the surface has no such edges, and a
 * distant reference point would lose digits.
 */
function cutOutline(fluid: OutlineSymbols, up: Vector, depth: Scalar): Submerged {
  const isNear = depth.abs().lessOrEqual(fluid.extent);
  const about = up.mul(select(isNear, depth, 0));
  const sums = fluid.edges.sum(({ x, y, dx, dy }) => {
    const [corner, edge] = [vec3(x, y), vec3(dx, dy)];
    const rise = up.dot(edge);
    const cornerDepth = depth.sub(up.dot(corner));
    const crossing = select(rise.equals(0), 0, cornerDepth.div(rise));
    const from = select(cornerDepth.greater(0), 0, crossing);
    const to = select(cornerDepth.greater(rise), 1, crossing);
    const start = corner.sub(about);
    const twice = start.x.mul(dy).sub(start.y.mul(dx)).mul(to.sub(from));
    const ends = start.mul(2).add(edge.mul(from.add(to)));
    return axial3(ends.x.mul(twice), ends.y.mul(twice), twice);
  });
  const area = sums.z.mul(0.5);
  return { depth, up, area, moments: vec3(sums.x, sums.y).div(6).add(about.mul(area)) };
}

/** Defines the law of a polygon, whose table is in this memory. */
function withSurface({ of, release }: ForceMemory<TableLocation>) {
  return defineLaw({
    ...about,
    parameters: { ...FLUID_VOLUME, ...HULL, extent: scalar('m'), edges: table(EDGE, of) },
    force: (body, fluid) => fluid.up.mul(weight(body, fluid).div(fluid.area).mul(submerged(body, fluid).area)),
    torque(body, fluid) {
      const { moments, up } = submerged(body, fluid);
      return moments.cross(up).mul(weight(body, fluid).div(fluid.area));
    },
    // Every area element contributes its depth: the derivative by height is the area, by angle the torque.
    potential(body, fluid) {
      const { depth, up, area, moments } = submerged(body, fluid);
      return weight(body, fluid)
        .div(fluid.area)
        .mul(area.mul(depth).sub(moments.dot(up)));
    },
    // Allocates the memory before the step.
    prepare: (world) => void of(world),
    releaseMemory: release,
  });
}

/** The same with waves, which do work: it has no potential. */
function withWaves({ of, release }: ForceMemory<TableLocation>) {
  return defineLaw({
    ...about,
    parameters: { ...FLUID_VOLUME, ...WAVES, ...HULL, extent: scalar('m'), edges: table(EDGE, of) },
    force(body, fluid) {
      const { area, lift } = submergedInWaves(body, fluid);
      return lift.mul(displacement(body, fluid).div(fluid.area).mul(area));
    },
    torque(body, fluid) {
      const { moments, lift } = submergedInWaves(body, fluid);
      return moments.cross(toBody(body, lift)).mul(displacement(body, fluid).div(fluid.area));
    },
    prepare: (world) => void of(world),
    releaseMemory: release,
  });
}

/**
 * Buoyancy on a polygonal hull in 2D, at the centroid of its immersed part, so that it rights or capsizes the body: F
 * = -ρ V (A'/A) g, N, and τ = r_B × F, N m.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function polygonBuoyancy(fluidVolume: FluidVolume, hull: PolygonHull): Force {
  const { fluid, level, waves } = fluidVolumeValues(fluidVolume, 'polygonBuoyancy');
  checkKeys(hull, 'polygonBuoyancy', ['shape', 'vertices']);
  const shape = checkWhole(hull.shape, 'polygonBuoyancy.shape', 2, 1000);
  const corners = anticlockwise(hull.vertices);
  const edges = corners.map(({ x, y }, i) => {
    const next = corners[(i + 1) % corners.length];
    return { x, y, dx: next.x - x, dy: next.y - y };
  });
  const area = areaOf(corners);
  if (level === undefined) return unbounded({ ...fluid, shape, area, centroid: centroidOf(edges, area) });
  const hullAt = forceMemory((world, take): TableLocation => {
    const at = take(8 * EDGE.length * edges.length, 'a hull');
    const values = edges.flatMap((edge) => EDGE.map((field) => edge[field]));
    new Float64Array(world.memory.buffer, at, values.length).set(values);
    return { at, count: edges.length };
  });
  const extent = Math.max(...corners.map(({ x, y }) => Math.sqrt(x * x + y * y)));
  const given = { ...fluid, level, shape, area, extent };
  return waves === undefined ? withSurface(hullAt)(given) : withWaves(hullAt)({ ...given, ...waves });
}

interface Corner {
  readonly x: number;
  readonly y: number;
}

/** The corners of a shape, whose origin is its centroid. */
function cornersOf({ kind, radius, vertices }: Shape): Corner[] {
  if (kind !== 'polygon' || radius > 0) {
    throw new PhysicsError('E_RANGE', `polygonBuoyancy.vertices is a ${kind} with round parts of ${radius} m.`, {
      field: 'polygonBuoyancy.vertices',
      hint: 'Give a polygon or box without rounding, or a list of corners.',
    });
  }
  return vertices.flatMap((x, i) => (i % 2 === 0 ? [{ x, y: vertices[i + 1] }] : []));
}

/** Validates the corners and orders them anticlockwise. */
function anticlockwise(given: PolygonHull['vertices']): Corner[] {
  const vertices = isShape(given) ? cornersOf(given) : given;
  checkList(vertices, 'polygonBuoyancy.vertices');
  const corners = (vertices ?? []).map((vertex, i) => ({
    x: checkNumber(vertex?.x, `polygonBuoyancy.vertices[${i}].x`, POSITION_BOUNDS),
    y: checkNumber(vertex?.y, `polygonBuoyancy.vertices[${i}].y`, POSITION_BOUNDS),
  }));
  const area = areaOf(corners);
  if (corners.length < 3 || area === 0) {
    throw new PhysicsError(
      'E_RANGE',
      `polygonBuoyancy.vertices has ${corners.length} vertices and an area of ${area} m². Give at least three that enclose an area.`,
      {
        field: 'vertices',
        value: vertices,
      },
    );
  }
  return area > 0 ? corners : corners.reverse();
}

function areaOf(corners: readonly Corner[]): number {
  const twice = corners.reduce((sum, { x, y }, i) => {
    const next = corners[(i + 1) % corners.length];
    return sum + x * next.y - next.x * y;
  }, 0);
  return twice / 2;
}

function centroidOf(edges: readonly Record<(typeof EDGE)[number], number>[], area: number): Corner {
  const sum = { x: 0, y: 0 };
  for (const { x, y, dx, dy } of edges) {
    const weight = (x * dy - y * dx) / (6 * area);
    sum.x += weight * (2 * x + dx);
    sum.y += weight * (2 * y + dy);
  }
  return sum;
}
