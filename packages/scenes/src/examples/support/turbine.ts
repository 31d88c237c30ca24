/** Wind turbines: three blades that a steady torque turns against damping. */
import { type PhysicsWorld, spawn } from '@principia/physics';
import { COLORS, type Line } from '../picture.ts';
import { spokes, star } from './outline.ts';

/** A turbine that can turn about its hub. */
export function addTurbine(world: PhysicsWorld, x: number, y: number, mass: number, inertia: number): number {
  const turning = { rotation: 0.4, angularVelocity: 0, angularDrag: 0.5 };
  return spawn(world, { position: { x, y }, velocity: {}, mass, inertia, ...turning });
}

/** Its tower, and its blades of the given radius. */
export function turbineLines(world: PhysicsWorld, turbine: number, radius: number, foot: number): Line[] {
  const { x, y } = world.components.Position;
  return [
    { from: { x: x[turbine], y: y[turbine] }, to: { x: x[turbine], y: foot }, width: 7, color: COLORS.grey },
    ...spokes(world, turbine, star(3, radius), { width: Math.max(4, radius / 12), color: COLORS.white }),
    ...spokes(world, turbine, star(3, radius * 0.6), { width: Math.max(6, radius / 8), color: COLORS.white }),
  ];
}
