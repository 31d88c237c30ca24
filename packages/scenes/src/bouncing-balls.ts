// Balls that bounce in a closed room. A few balls have the size of beach balls; with many, the radius shrinks so that
// they fill at most a fixed fraction of the room. Collisions are optional.
import {
  boxWalls,
  createPhysicsWorld,
  type ManyInput,
  type PhysicsWorld,
  particleContacts,
  quadraticDrag,
  spawnMany,
  uniformGravity,
} from '@principia/physics';
import { wrapAround } from './edges.ts';
import { countOf, defineScene, type SceneRun } from './scene.ts';
import { seededUniforms } from './seeded.ts';

/** Balls in a room. */
export interface BouncingBalls extends SceneRun {
  /** Corners of the room, m. In 2D `z` is zero. */
  readonly room: { readonly min: Point; readonly max: Point };
  /** Radius of every ball, m, and its mass, kg. */
  readonly radius: number;
  readonly mass: number;
  /** Ids of the balls, ascending. */
  readonly balls: Uint32Array;
  /** Switches collisions between balls on or off from the next step. */
  setCollisions(on: boolean): void;
}

interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

const WIDTH = 8;
const HEIGHT = 5;
const DEPTH = 5;
const MAX_RADIUS = 0.25;
/** Largest fraction of the room that balls fill: of its area in 2D, of its volume in 3D. */
const MAX_FILL = { 2: 0.22, 3: 0.1 } as const;
/** Distance of neighbouring centres at the start, in radii, so that balls do not overlap. */
const SPACING = 2.2;
/** Density of a ball, kg/m³: that of a table-tennis ball. */
const DENSITY = 84;
/** Drag coefficient of a sphere at Reynolds numbers from 10³ to 10⁵. */
const SPHERE_DRAG = 0.47;

/** Coefficient k = ρ C_d A / 2 of a ball's quadratic drag in a medium of density ρ, kg/m. */
export function ballDrag(mediumDensity: number, radius: number): number {
  return 0.5 * mediumDensity * SPHERE_DRAG * Math.PI * radius * radius;
}

/** Balls launched together that bounce in a room. */
export const bouncingBalls = defineScene({
  name: 'bouncing-balls',
  description: 'balls launched together that bounce in a room',
  precision: 'f32',
  parameters: {
    count: countOf('balls', 5, 1_000_000),
    gravity: { about: 'acceleration of free fall', unit: 'm/s²', initial: 9.80665, min: 0, max: 100 },
    restitution: { about: 'speed after a bounce over speed before', unit: '', initial: 0.8, min: 0, max: 1 },
    drag: { about: 'density of the medium that drags; air has 1.2', unit: 'kg/m³', initial: 0, min: 0, max: 1000 },
    collisions: { about: 'whether balls meet each other: 1 or 0', unit: '', initial: 0, min: 0, max: 1, integer: true },
    wrap: {
      about: 'whether balls that leave at a side come back at the other: 1 or 0',
      unit: '',
      initial: 0,
      min: 0,
      max: 1,
      integer: true,
    },
    friction: { about: 'friction of balls and walls, which makes them spin', unit: '', initial: 0.3, min: 0, max: 2 },
  },
  build({ dimensions, precision, seed, progress, parameters }): BouncingBalls {
    const { count, gravity, restitution, drag, friction, collisions, wrap } = parameters;
    const depth = dimensions === 3 ? DEPTH / 2 : 0;
    const room = { min: { x: 0, y: 0, z: -depth }, max: { x: WIDTH, y: HEIGHT, z: depth } };
    const radius = radiusFor(count, dimensions);
    const mass = DENSITY * (4 / 3) * Math.PI * radius * radius * radius;
    const world = createPhysicsWorld({
      dimensions,
      precision,
      seed,
      capacity: count,
      preset: particleContacts,
      forces: [uniformGravity({ y: -gravity }), quadraticDrag()],
      walls: [boxWalls(wallsOf(room, dimensions, wrap === 1))],
    });
    if (wrap === 1) world.phases.finish.push(wrapAround(ringsOf(room, dimensions)));
    const uniform = seededUniforms(seed, count);
    const velocity = { x: uniform(0, 5), y: uniform(-1, 3), ...(dimensions === 3 ? { z: uniform(-2, 2) } : {}) };
    const values: ManyInput = {
      position: launchPositions(count, radius, dimensions),
      velocity,
      mass,
      collider: { radius, restitution, friction },
      quadraticDrag: ballDrag(drag, radius),
      inertia: 0.4 * mass * radius * radius,
      angularVelocity: {},
      ...(dimensions === 3 ? { orientation: {} } : { rotation: {} }),
      appearance: {},
    };
    const balls = spawnMany(world, count, values, progress);
    const setCollisions = collisionSwitch(world);
    setCollisions(collisions === 1);
    const losesEnergy = 'bounces, friction and drag take energy out';
    return { world, dt: 1 / 60, losesEnergy, room, radius, mass, balls, setCollisions };
  },
});

/** Removes the systems of the `collide` phase and puts them back. */
function collisionSwitch({ phases }: PhysicsWorld): (on: boolean) => void {
  const systems = [...phases.collide];
  return (on) => {
    phases.collide.splice(0, phases.collide.length, ...(on ? systems : []));
  };
}

type Room = BouncingBalls['room'];

/** Six walls in 3D and four in 2D; balls that come back at the other side need floor and ceiling only. */
function wallsOf({ min, max }: Room, dimensions: 2 | 3, isOpen: boolean) {
  if (isOpen) return { min: { y: min.y }, max: { y: max.y } };
  return dimensions === 3 ? { min, max } : { min: inPlane(min), max: inPlane(max) };
}

/** Balls that leave along x, and in 3D along z, come back at the other side. */
function ringsOf({ min, max }: Room, dimensions: 2 | 3) {
  if (dimensions === 2) return { min: { x: min.x }, max: { x: max.x } };
  return { min: { x: min.x, z: min.z }, max: { x: max.x, z: max.z } };
}

function inPlane({ x, y }: Point) {
  return { x, y };
}

function radiusFor(count: number, dimensions: 2 | 3): number {
  const share = MAX_FILL[dimensions] / count;
  const fitting =
    dimensions === 2
      ? Math.sqrt((share * WIDTH * HEIGHT) / Math.PI)
      : cubeRoot((share * WIDTH * HEIGHT * DEPTH) / ((4 / 3) * Math.PI));
  return Math.min(MAX_RADIUS, fitting);
}

/** A square or cube of balls in the upper left of the room, centred in depth. */
function launchPositions(count: number, radius: number, dimensions: 2 | 3) {
  const spacing = SPACING * radius;
  const layers = dimensions === 3 ? Math.ceil(cubeRoot(count)) : 1;
  const columns = Math.ceil(Math.sqrt(count / layers));
  const axis = () => new Float64Array(count);
  const position = { x: axis(), y: axis(), ...(dimensions === 3 ? { z: axis() } : {}) };
  for (let i = 0; i < count; i++) {
    const layer = i % layers;
    const place = Math.floor(i / layers);
    // Every other row is shifted by half a spacing, so that rows do not fall straight onto each other.
    const row = Math.floor(place / columns);
    position.x[i] = 2 * radius + ((place % columns) + 0.5 * (row % 2)) * spacing;
    position.y[i] = HEIGHT - 2 * radius - row * spacing;
    if (position.z !== undefined) position.z[i] = (layer - (layers - 1) / 2) * spacing;
  }
  return position;
}

/** Newton's method, in arithmetic that is bitwise equal on every engine. */
function cubeRoot(value: number): number {
  let root = Math.max(1, value);
  for (let i = 0; i < 60; i++) root -= (root * root * root - value) / (3 * root * root);
  return root;
}
