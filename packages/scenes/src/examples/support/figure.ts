/** Drawings that are bodies: a plate with an outline, which turns about its centre of mass. */
import { createPhysicsWorld, decompose, type PhysicsWorld, rgba, rigidBodies, spawnCompound } from '@principia/physics';
import type { Color, Line, Point } from '../picture.ts';
import { placeOn } from './outline.ts';

/** Area, m², centroid, m, and moment of inertia about it per unit of density, m⁴. */
export interface Moments {
  readonly area: number;
  readonly centre: Point;
  readonly inertia: number;
}

/** Moments of a polygon by sums over its sides (Green's theorem). */
export function momentsOf(outline: readonly Point[]): Moments {
  let [twice, mx, my, second] = [0, 0, 0, 0];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length];
    const cross = a.x * b.y - a.y * b.x;
    twice += cross;
    mx += ((a.x + b.x) * cross) / 3;
    my += ((a.y + b.y) * cross) / 3;
    second += ((a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y) * cross) / 12;
  });
  const [area, centre] = [twice / 2, { x: mx / twice, y: my / twice }];
  const inertia = second - area * (centre.x * centre.x + centre.y * centre.y);
  return area > 0 ? { area, centre, inertia } : { area: -area, centre, inertia: -inertia };
}

/** A plate that turns about its centre of mass in the origin. */
export interface Figure {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly body: number;
  readonly moments: Moments;
  /** Where a point of the drawing is. */
  at(point: Point): () => Point;
  /** Lines through points of the drawing. @param isClosed back to the first */
  lines(points: readonly Point[], color: Color, width?: number, isClosed?: boolean): Line[];
}

/** @param spin angular velocity, rad/s */
export function spinFigure(outline: readonly Point[], spin: number): Figure {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 64 });
  const { centre } = momentsOf(outline);
  const { body } = spawnCompound(world, {
    position: { x: -centre.x, y: -centre.y },
    velocity: {},
    angularVelocity: spin,
    // So thin that lines and dots behind it are seen.
    appearance: rgba(0.43, 0.72, 1, 0.3),
    parts: decompose(outline).map((piece) => ({ ...piece, density: 1 })),
  });
  const at = ({ x, y }: Point) => {
    const inBody = { x: x - centre.x, y: y - centre.y };
    return () => placeOn(world, body, inBody);
  };
  return {
    world,
    dt: 1 / 60,
    body,
    moments: momentsOf(outline),
    at,
    lines: (points, color, width = 3, isClosed = true) =>
      points
        .map((point, i) => ({ from: at(point), to: at(points[(i + 1) % points.length]), color, width }))
        .slice(0, isClosed ? undefined : -1),
  };
}

/** The checks of every figure. */
export const FIGURE_CHECKS = [
  {
    label: 'Mass of its parts, by the area of the outline',
    unit: 'kg',
    exact: 1,
    tolerance: { relative: 1e-12 },
    at: { time: 0 },
    measure: ({ world, body, moments }: Figure) => world.components.Mass.value[body] / moments.area,
  },
  {
    label: 'Moment of inertia of its parts, by that of the outline',
    exact: 1,
    tolerance: { relative: 1e-12 },
    at: { time: 0 },
    measure: ({ world, body, moments }: Figure) => world.components.Inertia.value[body] / moments.inertia,
  },
  {
    label: 'How far its centre of mass moves while it turns',
    unit: 'm',
    exact: 0,
    tolerance: { absolute: 1e-12 },
    at: { until: 5, take: 'largest' },
    measure: ({ world, body }: Figure) => {
      const { x, y } = world.components.Position;
      return Math.sqrt(x[body] * x[body] + y[body] * y[body]);
    },
  },
] as const;
