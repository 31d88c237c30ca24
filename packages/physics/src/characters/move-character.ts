// Characters: kinematic bodies that walk, climb steps, slide along walls and ride on what moves.
import { warnAboutDuration } from '#warnings';
import type { PointInput } from '../collision/shapes/2d/shape.ts';
import { MAX_SPEED } from '../components/velocity.ts';
import { checkNumber, checkVector } from '../errors/validate.ts';
import { assertPlanar } from '../queries/body-query.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { type Character, type CharacterOptions, checkCharacter } from './character.ts';
import { groundBelow, heightAbove, isGround, mostLevel, recedingGround } from './ground.ts';
import { pushBodies } from './push-bodies.ts';
import { type Slide, slide, stopped, stoppedOnGround } from './slide.ts';
import { dot, gapTo, plus, type Surface, type Vector2, ZERO } from './surface.ts';
import { bodyBehind, carryingVelocity, isMovable } from './surface-body.ts';
import { approachOf, firstMeeting, touchedSurfaces } from './surroundings.ts';

/** What a character touches. */
export interface CharacterContact {
  /** Entity id of the body, the part or the wall; 0 for a wall of `boxWalls` that is no entity. */
  readonly body: number;
  readonly isWall: boolean;
  /** Point on its surface, m. */
  readonly x: number;
  readonly y: number;
  /** Unit normal, towards the character. */
  readonly nx: number;
  readonly ny: number;
}

/** What became of a movement. */
export interface CharacterMotion {
  /**
   * Velocity with which to go on, m/s: without what ground, walls and ceilings took of it. It is relative to the ground while
   * the character stands on some, so that it rides along, and relative to the world in the air.
   */
  readonly velocity: Vector2;
  /** Whether it stands on ground. */
  readonly grounded: boolean;
  /** Entity id of the ground; 0 in the air, and on a wall of `boxWalls` that is no entity. */
  readonly ground: number;
  /** Unit normal of the ground; `up` in the air. */
  readonly normal: Vector2;
  /** Velocity of the ground where the character stands, m/s; zero in the air. */
  readonly groundVelocity: Vector2;
  /** Everything that it touches in the end, ground, walls and ceilings, such as spikes, or a wall to jump off. */
  readonly contacts: readonly CharacterContact[];
}

const SPEED_BOUNDS = { min: -MAX_SPEED, max: MAX_SPEED };

/**
 * Moves a kinematic body as a character, along what it meets and not into it: sets its velocity so that the next step, of
 * length `dt`, carries it there. Call it once before each step. The body needs a round shape, such as an upright capsule. Only
 * what its collider collides with stops it. If it has a mass it pushes bodies as if it were one; none with mass pushes it.
 * @param velocity that the character wants, m/s, with gravity, as in `CharacterMotion`: a jump is a velocity upwards
 * @param dt length of the next step, s
 * @throws PhysicsError E_STALE, E_TYPE, E_NONFINITE, E_UNKNOWN, E_CAPACITY, E_DESTROYED; E_RANGE also for a body that is not
 *   kinematic or has sharp corners, and in three dimensions
 */
export function moveCharacter(
  world: PhysicsWorld,
  body: number,
  velocity: PointInput,
  dt: number,
  options: CharacterOptions = {},
): CharacterMotion {
  assertPlanar(world, 'moveCharacter');
  const checked = checkCharacter(world, body, checkNumber(dt, 'dt', { above: 0, max: 1e9 }), options);
  const own = checkVector(velocity, 'velocity', SPEED_BOUNDS);
  warnAboutDuration(world, dt, 'moveCharacter: dt');
  const { Position, Velocity } = world.components;
  const start = { x: Position.x[body], y: Position.y[body] };
  const atRest = touchedSurfaces(checked, start);
  const isUnder = (surface: Surface) => isGround(checked, surface, start);
  const isRising = dot(own, checked.up) > 0;
  const ground =
    mostLevel(atRest.filter(isUnder), checked.up) ?? (isRising ? undefined : recedingGround(checked, start));
  const groundVelocity = ground === undefined ? ZERO : carryingVelocity(world, ground);
  const character = { ...checked, groundVelocity };
  // What comes nearer depends on how the character rides along.
  const nearby = groundVelocity.x === 0 && groundVelocity.y === 0 ? atRest : touchedSurfaces(character, start);
  const walks = ground !== undefined && !isRising;
  const moved = walks
    ? walk(character, start, ground, own, nearby)
    : slide(character, start, plus(ZERO, own, dt), nearby);
  const support = bodyBehind(world, ground?.id ?? 0);
  const end = ride(character, moved.end, support);
  Velocity.x[body] = (end.x - start.x) / dt;
  Velocity.y[body] = (end.y - start.y) / dt;
  const touched = touchedSurfaces(character, moved.end);
  // Before bodies are pushed, so that the ground still has the velocity of which the character was one step ago.
  const inWorld = plus(own, groundVelocity);
  const motion = motionAt(character, moved.end, touched, inWorld, walks);
  pushBodies(character, [...touched, ...moved.surfaces], inWorld, support);
  return motion;
}

/** Walks along the ground, up and down steps; over an edge it falls. */
function walk(character: Character, start: Vector2, ground: Surface, own: Vector2, nearby: Surface[]): Slide {
  const { up, right, dt, snapDistance } = character;
  const distance = dot(own, right) * dt;
  const wanted = { x: ground.normal.y * distance, y: -ground.normal.x * distance };
  const from = liftedOut(character, start, ground);
  const straight = slide(character, from, wanted, nearby);
  const moved = climb(character, from, wanted, straight) ?? straight;
  const below = groundBelow(character, moved.end, snapDistance);
  if (below !== undefined) {
    // Out of the way of a lift that comes up through this ground it does not go back.
    const rise = nearby.reduce((most, surface) => Math.max(most, riseBy(character, surface, below.position)), 0);
    const height = dot(plus(moved.end, below.position, -1), up);
    return { end: plus(below.position, up, Math.min(rise, height)), surfaces: moved.surfaces };
  }
  const fallen = slide(character, moved.end, plus(ZERO, up, dot(own, up) * dt));
  return { end: fallen.end, surfaces: [...moved.surfaces, ...fallen.surfaces] };
}

/**
 * Straight up out of ground that yields, as far as there is room. Out of it along its normal and down again by its weight, a character
 * would walk downhill on a boat, wave by wave.
 */
function liftedOut(character: Character, start: Vector2, ground: Surface): Vector2 {
  const { world, up, minUpward } = character;
  const gap = gapTo(ground, start);
  const upward = dot(ground.normal, up);
  if (gap >= 0 || upward < minUpward || !isMovable(world, bodyBehind(world, ground.id))) return start;
  const rise = plus(ZERO, up, -gap / upward);
  return plus(start, rise, firstMeeting(character, start, rise)?.fraction ?? 1);
}

/** How far a surface that comes nearer lifts a character in the step, m; 0 if there is room. */
function riseBy(character: Character, surface: Surface, position: Vector2): number {
  const upward = dot(surface.normal, character.up);
  const gap = gapTo(surface, position);
  if (gap >= 0 || upward < character.minUpward) return 0;
  return Math.min(-gap, approachOf(character, surface.id, surface.point, surface.normal)) / upward;
}

/** Part of a wanted displacement below which something is in the way. */
const UNHINDERED = 0.99;

/** Climbs a step, where the way along the ground is blocked and one over it is not; undefined if there is none. */
function climb(character: Character, start: Vector2, wanted: Vector2, straight: Slide): Slide | undefined {
  const { up, right, stepHeight, margin } = character;
  const distance = dot(wanted, right);
  if (stepHeight === 0 || distance === 0) return undefined;
  const progress = dot(plus(straight.end, start, -1), right) / distance;
  if (progress >= UNHINDERED) return undefined;
  const rise = plus(ZERO, up, stepHeight);
  const raised = plus(start, rise, firstMeeting(character, start, rise)?.fraction ?? 1);
  const over = slide(character, raised, plus(ZERO, right, distance));
  if (dot(plus(over.end, start, -1), right) / distance <= progress) return undefined;
  const below = groundBelow(character, over.end, dot(plus(over.end, start, -1), up) + margin);
  // The round lower end would roll over edges that are higher than a step.
  if (below === undefined || heightAbove(character, start, below.surface) > stepHeight) return undefined;
  return { end: below.position, surfaces: over.surfaces };
}

/** Carries the character along with the body that it stands on, as far as there is room. */
function ride(character: Character, position: Vector2, body: number): Vector2 {
  const { world, groundVelocity, right, dt } = character;
  // A body that yields is followed up and down by where it is: two that follow each other would go down together.
  const velocity = isMovable(world, body) ? plus(ZERO, right, dot(groundVelocity, right)) : groundVelocity;
  const motion = plus(ZERO, velocity, dt);
  return plus(position, motion, firstMeeting(character, position, motion, body)?.fraction ?? 1);
}

function motionAt(
  character: Character,
  position: Vector2,
  touched: readonly Surface[],
  velocity: Vector2,
  walks: boolean,
): CharacterMotion {
  const { world, up } = character;
  const [grounds, walls]: [Surface[], Surface[]] = [[], []];
  for (const surface of touched) (isGround(character, surface, position) ? grounds : walls).push(surface);
  const ground = mostLevel(grounds, up);
  const groundVelocity = ground === undefined ? ZERO : carryingVelocity(world, ground);
  const relative = plus(velocity, groundVelocity, -1);
  const contacts = touched.map(contactOf);
  // One who walks from one plank to another that goes down faster does not jump.
  if (ground === undefined || (!walks && dot(relative, up) > 0)) {
    const stoppedVelocity = stopped(character, position, velocity, walls);
    return { velocity: stoppedVelocity, grounded: false, ground: 0, normal: up, groundVelocity: ZERO, contacts };
  }
  const level = plus(relative, up, -dot(relative, up));
  return {
    velocity: stoppedOnGround(character, level, ground, walls),
    grounded: true,
    ground: ground.id,
    normal: ground.normal,
    groundVelocity,
    contacts,
  };
}

function contactOf({ id, isWall, point, normal }: Surface): CharacterContact {
  return { body: id, isWall, x: point.x, y: point.y, nx: normal.x, ny: normal.y };
}
