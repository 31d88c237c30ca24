// Warnings about what floats: hulls that no force reads as they are meant, and fluids that steps cannot follow.
import { JOINT_KINDS } from '../components/joint.ts';
import { bitOf } from '../components/membership.ts';
import { warnOnce } from '../errors/warn-once.ts';
import type { Force, PhysicsWorld, Plan } from '../world/types.ts';
import { firstRow, has } from './first-row.ts';
import { parameterOf } from './force-parameters.ts';

export function warnAboutFluids(world: PhysicsWorld, plan: Plan, dt: number): void {
  warnAboutMissingHulls(world);
  if (world.internal.counts.Hull === 0) return;
  warnAboutHullShapes(world);
  warnAboutHullHeights(world);
  warnAboutAddedMass(world, plan);
  warnAboutStiffBuoyancy(world, dt);
  warnAboutLongHulls(world);
}

/** Forces of a fluid, also where they are restricted. */
function forcesCalled(world: PhysicsWorld, ...names: string[]): Force[] {
  return world.forces.filter(({ name }) => names.some((each) => name === each || name === `${each} (restricted)`));
}

/** Whether forces move a body that has a hull. */
function isFloater(world: PhysicsWorld, id: number): boolean {
  const { Hull, Mass } = world.components;
  return has(world, id, 'Hull') && Hull.volume[id] > 0 && Mass.value[id] > 0;
}

/** Water does not know what it carries by its collider. */
function warnAboutMissingHulls(world: PhysicsWorld): void {
  const { Hull, Mass, Velocity } = world.internal.counts;
  const [force] = forcesCalled(world, 'buoyancy', 'polygon buoyancy');
  if (force === undefined || Hull > 0 || Mass === 0 || Velocity === 0) return;
  const warning = {
    message: `${force.name} has no effect, because no body of this world has a Hull.`,
    hint: 'Spawn what floats with `hull: volume`, in m³, or `hull: { volume, shape }`: the collider does not say it.',
  };
  warnOnce(world, warning, 'no Hull');
}

/** A hull of a shape that the fluids of the world do not carry sinks. */
function warnAboutHullShapes(world: PhysicsWorld): void {
  const polygons = forcesCalled(world, 'polygon buoyancy').map((force) => parameterOf(world, force, 'shape')?.[0]);
  const isPlain = forcesCalled(world, 'buoyancy').length > 0;
  if (polygons.length === 0 && !isPlain) return;
  const { shape } = world.components.Hull;
  const isCarried = (id: number) => (shape[id] < 2 ? isPlain : polygons.includes(shape[id]));
  const sinking = firstRow(world, (id) => isFloater(world, id) && !isCarried(id));
  if (sinking === 0) return;
  const warning = {
    message: `body ${sinking} is not buoyant, because no force of this world carries hulls of the shape ${shape[sinking]}.`,
    hint: 'Shapes 0 and 1 are carried by `buoyancy`, others by a `polygonBuoyancy` of the same number.',
  };
  warnOnce(world, warning, 'shape of a hull');
}

/** Forces at the surface of a fluid that read the half height of hulls, `buoyancy` that of spheres and boxes. */
const READ_HEIGHT = ['buoyancy', 'immersed drag', 'added mass'];

/** Bodies are given the height of their shape when they are spawned: hulls that come later, and those of compounds, are not. */
function warnAboutHullHeights(world: PhysicsWorld): void {
  const forces = forcesCalled(world, ...READ_HEIGHT).filter(({ law }) => law?.names.includes('level'));
  if (forces.length === 0) return;
  const { Attachment, Collider, Hull } = world.components;
  const isRead = (id: number) => Hull.shape[id] < 2 || forces.some(({ name }) => !name.startsWith('buoyancy'));
  const isDefault = (id: number) => isFloater(world, id) && Hull.halfHeight[id] === 0 && isRead(id);
  const shaped = firstRow(world, (id) => isDefault(id) && Collider.shape[id] > 0);
  if (shaped > 0) {
    const radius = Number(Collider.radius[shaped].toPrecision(3));
    const warning = {
      message: `the hull of body ${shaped} reaches ${radius} m above and below its centre, as the circle around its shape does.`,
      hint: 'Give `hull.halfHeight`, or spawn the body with its hull, which then is as high as its shape.',
    };
    warnOnce(world, warning, 'height of a hull');
  }
  const isFlat = (id: number) => isDefault(id) && !(Collider.radius[id] > 0);
  const part = firstRow(world, (id) => isPart(world, id) && isFlat(Attachment.body[id]));
  if (part === 0) return;
  const warning = {
    message: `the hull of compound body ${Attachment.body[part]} has no height, and is either in the fluid or out of it.`,
    hint: 'Give `hull.halfHeight`: that of a compound does not follow from its parts.',
  };
  warnOnce(world, warning, 'height of a compound');
}

function isPart(world: PhysicsWorld, id: number): boolean {
  return has(world, id, 'Attachment');
}

/** What presses or holds a body does not feel the fluid that moves with it. */
function warnAboutAddedMass(world: PhysicsWorld, plan: Plan): void {
  if (forcesCalled(world, 'added mass').length === 0) return;
  const body = heldFloater(world) || pressedFloater(world, plan);
  if (body === 0) return;
  const warning = {
    message: `addedMass does not act on what contacts and joints do to body ${body}: where they press or hold it, they carry too little of its weight or lift.`,
    hint: 'Leave addedMass out, and give such bodies the sum `mass: m + A` and `gravityScale: m / (m + A)`; or `mask: 0` to what touches nothing.',
  };
  warnOnce(world, warning, 'added mass');
}

/** A body with a hull that a joint holds, 0 if there is none. */
function heldFloater(world: PhysicsWorld): number {
  if (world.internal.counts.Joint === 0) return 0;
  const { members } = world.internal;
  const { Joint } = world.components;
  const [isJoint, filter] = [bitOf('Joint'), JOINT_KINDS.indexOf('filter')];
  const holds = (id: number) => (members[id] & isJoint) !== 0 && Joint.kind[id] !== filter;
  const ends = (id: number) => [Joint.a[id], Joint.b[id]];
  const joint = firstRow(world, (id) => holds(id) && ends(id).some((end) => isFloater(world, end)));
  return joint === 0 ? 0 : (ends(joint).find((end) => isFloater(world, end)) ?? 0);
}

/** A body with a hull that others may press, 0 if there is none. */
function pressedFloater(world: PhysicsWorld, { systems }: Plan): number {
  const { solvesWalls } = world.integrator;
  const collides = solvesWalls === true || systems.collide.some(({ name }) => name === 'collide bodies');
  if (!collides || world.internal.counts.Collider < 2) return 0;
  const { Attachment, Collider } = world.components;
  const bodyOf = (id: number) => (isPart(world, id) ? Attachment.body[id] : id);
  const meets = (id: number) => has(world, id, 'Collider') && Collider.mask[id] !== 0 && Collider.sensor[id] === 0;
  return bodyOf(firstRow(world, (id) => meets(id) && isFloater(world, bodyOf(id))));
}

/** A float that bobs faster than steps can follow is thrown out of the water, by ω² = ρ g A/m with the area A of its waterline. */
function warnAboutStiffBuoyancy(world: PhysicsWorld, dt: number): void {
  const { isStable } = world.integrator;
  const forces = forcesCalled(world, 'buoyancy', 'polygon buoyancy');
  if (isStable === undefined || forces.length === 0) return;
  const [added] = forcesCalled(world, 'added mass');
  const coefficient = added === undefined ? 0 : (parameterOf(world, added, 'coefficient')?.[0] ?? 0);
  for (const force of forces) {
    const stiffnessOf = floatStiffness(world, force, coefficient);
    const thrown = firstRow(world, (id) => isFloater(world, id) && !isStable(stiffnessOf(id) * dt * dt, 0));
    if (thrown === 0) continue;
    const warning = {
      message: `body ${thrown} floats too stiffly for these steps, which throw it out of the fluid: it would bob ${Number((Math.sqrt(stiffnessOf(thrown)) / (2 * Math.PI)).toPrecision(2))} times a second.`,
      hint: 'Take shorter steps or more sub-steps, or a heavier or higher hull; a very light float also takes `addedMass`.',
    };
    warnOnce(world, warning, 'stiff buoyancy');
  }
}

/** Returns ω² of a body that this force floats, 1/s²; 0 if it does not float at a surface. */
function floatStiffness(world: PhysicsWorld, force: Force, coefficient: number): (id: number) => number {
  const { Collider, Hull, Mass } = world.components;
  const value = (name: string) => parameterOf(world, force, name)?.[0];
  const [density, gravity, level] = [value('density') ?? 0, value('gravity') ?? 0, value('level')];
  const [shape, area, extent] = [value('shape'), value('area') ?? 1, value('extent') ?? 0];
  return (id) => {
    const [volume, mass, kind] = [Hull.volume[id], Mass.value[id], Hull.shape[id]];
    const isCarried = shape === undefined ? kind < 2 : kind === shape;
    if (level === undefined || !isCarried || mass >= density * volume) return 0;
    const half = Hull.halfHeight[id] > 0 ? Hull.halfHeight[id] : Collider.radius[id];
    // A point has no waterline. That of a polygon is at most twice as wide as its corners are far out.
    if (shape === undefined && !(half > 0)) return 0;
    const perDepth = shape === undefined ? (kind === 0 ? 0.75 : 0.5) / half : (2 * extent) / area;
    // A box at rest displaces its mass; a sphere is stiffest where it is half immersed.
    const immersed = kind === 0 ? 0.5 * density * volume : mass;
    return (density * gravity * volume * perDepth) / (mass + coefficient * immersed);
  };
}

/** A hull of this part of a wavelength heaves a tenth too much: the mean of the wave over its length B is sin(π B/L)/(π B/L) of it. */
const LONGEST_HULL = 1 / 4;

/** The surface about a hull is taken for a plane. */
function warnAboutLongHulls(world: PhysicsWorld): void {
  const { shape } = world.components.Hull;
  for (const force of forcesCalled(world, 'polygon buoyancy')) {
    const [waveNumber, extent, kind] = ['waveNumber', 'extent', 'shape'].map(
      (name) => parameterOf(world, force, name)?.[0],
    );
    if (waveNumber === undefined || extent === undefined) continue;
    const length = (2 * Math.PI) / waveNumber;
    if (2 * extent <= LONGEST_HULL * length) continue;
    const long = firstRow(world, (id) => isFloater(world, id) && shape[id] === kind);
    if (long === 0) continue;
    const [hull, wave] = [2 * extent, length].map((metres) => Number(metres.toPrecision(3)));
    const warning = {
      message: `body ${long} is ${hull} m long, and the waves ${wave} m: a hull is lifted and tilted as if the surface about its centre were a plane.`,
      hint: 'Take waves of at least four times its length, or build it of several shorter bodies that are welded together.',
    };
    warnOnce(world, warning, 'long hull');
  }
}
