/** A cube in space whose torque is on for the first seconds, and whenever a key is held. */
import {
  angularDrag,
  constantTorque,
  createPhysicsWorld,
  type Force,
  type Integrator,
  keepState,
  type PhysicsWorld,
  spawn,
} from '@principia/physics';
import { COLORS, type Color, type Line, type Point } from '../picture.ts';
import { listWhile } from './force-switch.ts';
import { cubeEdges, type Point3, pointOn } from './space.ts';

/** The torque is on for this time without a key, s. */
export const PUSH_TIME = 10;
export const CUBE_DT = 1 / 240;
const HALF_WIDTH = 50;

export interface CubeRun {
  readonly world: PhysicsWorld;
  readonly dt: number;
  readonly cube: number;
  readonly switches: { byKey: boolean };
  readonly isOn: () => boolean;
}

export interface CubeOptions {
  /** N m */
  readonly torque: Point;
  /** Drag of the rotation, N m s. */
  readonly drag: number;
  readonly inertia: number;
  /** Seconds in which the torque is on without a key. */
  readonly pushTime: number;
  readonly forces?: readonly Force[];
  readonly integrator: Integrator;
}

export function turningCube({ torque, drag, inertia, pushTime, forces = [], integrator }: CubeOptions): CubeRun {
  const push = constantTorque(torque);
  const world = createPhysicsWorld({
    dimensions: 3,
    capacity: 4,
    forces: [...forces, angularDrag(), push],
    integrator,
  });
  const body = { position: {}, velocity: {}, mass: 1, inertia, orientation: {}, angularVelocity: {} };
  const cube = spawn(world, { ...body, angularDrag: drag });
  const switches = { byKey: false };
  keepState(world, switches);
  const isOn = () => switches.byKey || world.time < pushTime - CUBE_DT / 2;
  listWhile(world, push, isOn);
  return { world, dt: CUBE_DT, cube, switches, isOn };
}

/** The edges of the cube, and a line to the middle of one face, so that its turning is seen. */
export function cubeLines({ world, cube }: CubeRun, color: Color = COLORS.blue): Line[] {
  const place = (local: Point3) => pointOn(world, cube, local);
  const middle = { x: 0, y: 0, z: HALF_WIDTH };
  return [
    ...cubeEdges(HALF_WIDTH, place, color),
    { from: () => place({ x: 0, y: 0, z: 0 }), to: () => place(middle), color: COLORS.orange },
  ];
}
