/**
 * The osculating ellipse of a body: the orbit on which it would stay if all but one body stopped attracting it. One curve of
 * the unit circle serves for all; a matrix makes it the ellipse, and lets it begin at the body.
 */
import { BufferAttribute, BufferGeometry, Color, Line, LineBasicMaterial, Matrix4 } from 'three';
import { cross, dot, lengthOf, scaled, sum, type Vector } from './vectors.ts';

const POINTS = 400;

/** Half axes and centre of an ellipse through a place, from which the parameter counts. */
export interface Ellipse {
  readonly centre: Vector;
  /** From the centre to the place. */
  readonly here: Vector;
  /** From the centre to the place a quarter of the parameter later. */
  readonly quarter: Vector;
  readonly eccentricity: number;
  readonly semiMajorAxis: number;
}

/**
 * The ellipse of a body with this position and velocity relative to its centre of attraction; undefined for a path that does
 * not close. @param mu G times the sum of both masses, km³/s²
 */
export function osculatingEllipse(r: Vector, v: Vector, mu: number): Ellipse | undefined {
  const distance = lengthOf(r);
  const semiMajorAxis = 1 / (2 / distance - dot(v, v) / mu);
  if (!(semiMajorAxis > 0) || !Number.isFinite(semiMajorAxis)) return undefined;
  const h = cross(r, v);
  // Eccentricity vector, which points to the periapsis: v × h / μ − r / |r|.
  const e = sum(scaled(cross(v, h), 1 / mu), r, -1 / distance);
  const eccentricity = lengthOf(e);
  const centre = scaled(e, -semiMajorAxis);
  const here = sum(r, centre, -1);
  // The conjugate half axis of `here` has the direction of the velocity: dr/dE = a r v / √(μ a).
  const quarter = scaled(v, (semiMajorAxis * distance) / Math.sqrt(mu * semiMajorAxis));
  return { centre, here, quarter, eccentricity, semiMajorAxis };
}

/** The unit circle, with points close together near its beginning, fading away from it. */
function circleGeometry(color: Color): BufferGeometry {
  const positions = new Float32Array(3 * POINTS);
  const colors = new Float32Array(4 * POINTS);
  for (let i = 0; i < POINTS; i++) {
    const u = (2 * i) / (POINTS - 1) - 1;
    const angle = Math.PI * (1 + Math.sign(u) * (1 - (1 - Math.abs(u)) ** 3));
    positions.set([Math.cos(angle), Math.sin(angle), 0], 3 * i);
    // The body moves towards larger angles, so what is just behind it is brightest.
    colors.set([color.r, color.g, color.b, 0.26 + 0.7 * (angle / (2 * Math.PI)) ** 2], 4 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colors, 4));
  return geometry;
}

export interface OrbitLine {
  readonly object: Line;
  /** @param centre the attracting body in the picture @param unit length of the picture by km */
  set(ellipse: Ellipse | undefined, centre: Vector, unit: number): void;
  destroy(): void;
}

export function createOrbitLine(color: string): OrbitLine {
  const geometry = circleGeometry(new Color(color));
  const material = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
  const object = new Line(geometry, material);
  object.frustumCulled = false;
  object.matrixAutoUpdate = false;
  const matrix = new Matrix4();
  return {
    object,
    set(ellipse, { x, y, z }, length) {
      object.visible = ellipse !== undefined;
      if (ellipse === undefined) return;
      const { centre: c, here: a, quarter: b } = ellipse;
      const k = length;
      matrix.set(
        k * a.x,
        k * b.x,
        0,
        x + k * c.x,
        k * a.y,
        k * b.y,
        0,
        y + k * c.y,
        k * a.z,
        k * b.z,
        0,
        z + k * c.z,
        0,
        0,
        0,
        1,
      );
      object.matrix.copy(matrix);
      object.matrixWorldNeedsUpdate = true;
    },
    destroy() {
      geometry.dispose();
      material.dispose();
    },
  };
}
