/** What floats otherwise than it is meant to, and what steps cannot follow, gets a warning, once, that says what to do. */
import {
  addedMass,
  angularDrag,
  box,
  buoyancy,
  createJoint,
  distance,
  type Force,
  immersedDrag,
  particleContacts,
  polygonBuoyancy,
  rigidBodies,
  rungeKutta4,
  semiImplicitEuler,
  setShape,
  softStep,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

const SEA = { density: 1000, level: 0 };
const SQUARE = [
  { x: -0.5, y: -0.5 },
  { x: 0.5, y: -0.5 },
  { x: 0.5, y: 0.5 },
  { x: -0.5, y: 0.5 },
];

it('names a hull of a shape that no force carries', () => {
  const warned = (shape: number, ...forces: Force[]) => {
    const { world, messages } = warnedWorld({ forces });
    spawn(world, { position: { y: -5 }, mass: 500, hull: { volume: 1, shape, halfHeight: 0.5 } });
    for (let i = 0; i < 2; i++) step(world, 1 / 60);
    return messages();
  };
  const polygon = polygonBuoyancy(SEA, { shape: 3, vertices: SQUARE });
  const messageOf = (shape: number) =>
    `body 1 is not buoyant, because no force of this world carries hulls of the shape ${shape}.`;
  expect(warned(7, buoyancy(SEA))).toBe(messageOf(7));
  expect(warned(2, polygon)).toBe(messageOf(2));
  expect(warned(0, polygon)).toBe(messageOf(0));
  expect(warned(3, polygon)).toBe('');
  expect(warned(1, buoyancy(SEA))).toBe('');
  expect(warned(3, buoyancy(SEA), polygon)).toBe('');
});

it('names a hull as high as the circle around its shape', () => {
  const warned = (build: (world: ReturnType<typeof warnedWorld>['world']) => void, forces = [buoyancy(SEA)]) => {
    const { world, messages } = warnedWorld({ preset: rigidBodies, forces });
    build(world);
    step(world, 1 / 60);
    return messages();
  };
  const collider = { shape: box(4, 3), density: 500 };
  const late = (halfHeight: number) =>
    warned((world) => {
      const body = spawn(world, { position: {}, collider });
      addComponent(world, body, set(world.components.Hull, { volume: 12, halfHeight }));
    });
  expect(late(0)).toBe(
    'the hull of body 1 reaches 2.5 m above and below its centre, as the circle around its shape does.',
  );
  expect(late(1.5)).toBe('');
  expect(warned((world) => void spawn(world, { position: {}, collider, hull: 12 }))).toBe('');
  const compound = (hull: object) =>
    warned((world) => void spawnCompound(world, { position: {}, hull, parts: [{ ...collider, x: 1 }] }));
  expect(compound({ volume: 12 })).toBe(
    'the hull of compound body 1 has no height, and is either in the fluid or out of it.',
  );
  expect(compound({ volume: 12, halfHeight: 1 })).toBe('');
});

it('keeps the hull of a body that gets another shape', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [buoyancy(SEA)] });
  const body = spawn(world, { position: {}, collider: { shape: box(4, 2), density: 500 }, hull: 8 });
  setShape(world, body, box(2, 4));
  step(world, 1 / 60);
  expect(world.components.Hull.halfHeight[body]).toBe(1);
  expect(messages()).toBe('');
});

it('names a part that has a hull', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [buoyancy(SEA)] });
  const { body, parts } = spawnCompound(world, {
    hull: { volume: 1, halfHeight: 1 },
    parts: [{ shape: box(1, 1), density: 1 }],
  });
  addComponent(world, parts[0], set(world.components.Hull, { volume: 1, halfHeight: 0.5 }));
  step(world, 1 / 60);
  expect(body).toBe(1);
  expect(messages()).toBe(
    `the Hull of part ${parts[0]} has no effect, because forces act on compound bodies and not on their parts.`,
  );
});

it.each([
  ['Thrust', { y: 10 }],
  ['LinearDrag', { coefficient: 1 }],
  ['Charge', { value: 1e-6 }],
  ['GravityScale', { value: 0 }],
  ['NeverSleep', {}],
] as const)('names a part that has %s, which its body should have', (name, values) => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  const { parts } = spawnCompound(world, { parts: [{ shape: box(1, 1), density: 1 }] });
  step(world, 1 / 60);
  expect(messages()).toBe('');
  addComponent(world, parts[0], set(world.components[name] as typeof world.components.Charge, values));
  step(world, 1 / 60);
  expect(messages()).toContain(`the ${name} of part ${parts[0]} has no effect`);
});

it('names a body with added mass that others may press, or a joint holds', () => {
  const warned = (mask: number, others: number, options = {}, joined = false) => {
    const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [addedMass(SEA)], ...options });
    const body = { position: { y: -5 }, mass: 1000, hull: 1 };
    const stone = spawn(world, { ...body, collider: { radius: 0.5, mask } });
    for (let i = 0; i < others; i++) spawn(world, { position: { x: 3 * i + 3 }, collider: { radius: 0.5 } });
    if (joined) createJoint(world, distance({ a: stone, b: spawn(world, { ...body, position: { y: -3 } }) }));
    for (let i = 0; i < 2; i++) step(world, 1 / 60);
    return messages();
  };
  const message = /^addedMass does not act on what contacts and joints do to body 1: [^\n]*$/;
  expect(warned(1, 1)).toMatch(message);
  expect(warned(1, 1, { preset: particleContacts })).toMatch(message);
  expect(warned(0, 0, {}, true)).toMatch(message);
  // Nothing else is there, it touches nothing, or bodies do not collide.
  expect(warned(1, 0)).toBe('');
  expect(warned(0, 1)).toBe('');
  expect(warned(1, 1, { preset: undefined })).toBe('');
});

it('names a float that bobs faster than steps can follow', () => {
  const warned = (mass: number, shape: number, options = {}, added: Force[] = []) => {
    const polygon = SQUARE.map(({ x, y }) => ({ x, y: 0.01 * y }));
    const forces = [buoyancy(SEA), polygonBuoyancy(SEA, { shape: 2, vertices: polygon }), ...added];
    const { world, messages } = warnedWorld({ forces, ...options });
    spawn(world, { position: { y: 1 }, mass, hull: { volume: 0.01, halfHeight: 0.005, shape } });
    for (let i = 0; i < 2; i++) step(world, 1 / 60);
    return messages();
  };
  // A plate of 1 m by 1 cm with a hundredth of the density of water: ω² = 9810/s² 1 m²/0.1 m³, and ω dt = 5.2, above 2.
  const message =
    'body 1 floats too stiffly for these steps, which throw it out of the fluid: it would bob 50 times a second.';
  for (const shape of [1, 2]) {
    expect(warned(0.1, shape)).toBe(message);
    expect(warned(0.1, shape, { integrator: semiImplicitEuler })).toBe(message);
    // ω dt = 1.65 and 1.3.
    expect(warned(1, shape)).toBe('');
    expect(warned(0.1, shape, { preset: rigidBodies, integrator: softStep() })).toBe('');
    expect(warned(0.1, shape, { preset: rigidBodies, integrator: softStep({ substeps: 1 }) })).toBe(message);
  }
  // A sphere is half as stiff again; what sinks does not bob.
  expect(warned(0.5, 0)).toMatch(/it would bob 27 times a second\.$/);
  expect(warned(0.9, 1, { integrator: rungeKutta4 })).toBe('');
  expect(warned(11, 0)).toBe('');
  // With as much mass as half of its water, 5 kg and ½ 0.5·10 kg, the sphere follows.
  expect(warned(0.5, 0, {}, [addedMass(SEA, 1)])).toBe('');
});

it('says that an angular drag, or a drag in the fluid, is too strong for the step', () => {
  const warned = (coefficient: number, options = {}) => {
    const { world, messages } = warnedWorld({ forces: [angularDrag()], ...options });
    spawn(world, { position: {}, mass: 1, inertia: 0.5, rotation: 0, angularVelocity: 1, angularDrag: coefficient });
    step(world, 1 / 60);
    return [messages(), Math.abs(world.components.AngularVelocity.z[1])] as const;
  };
  const message = 'the angular drag of body 1 takes more of its spin in a step than it has, and turns it back faster.';
  // k dt/I = 61/30 and 59/30.
  for (const integrator of [semiImplicitEuler, rungeKutta4]) {
    const [said, spin] = warned(61, { integrator });
    expect(said).toBe(message);
    expect(spin).toBeGreaterThan(1);
    const [, calm] = warned(59, { integrator });
    expect(calm).toBeLessThan(1);
    expect(warned(59, { integrator })[0]).toBe('');
  }
  expect(warned(61, { preset: rigidBodies })[0]).toBe('');
  expect(warned(241, { preset: rigidBodies })[0]).toBe(message);
  const { world, messages } = warnedWorld({ forces: [uniformGravity(), immersedDrag({ density: 1000 })] });
  spawn(world, { position: {}, mass: 1, linearDrag: 200 });
  step(world, 1 / 60);
  expect(messages()).toMatch(/^the drag of body 1 takes more of its speed in a step than it has/);
});

it('names a hull that is too long for waves', () => {
  const warned = (length: number, shape = 2) => {
    const sea = { ...SEA, waves: { amplitude: 0.1, length } };
    const { world, messages } = warnedWorld({
      forces: [buoyancy(sea), polygonBuoyancy(sea, { shape: 2, vertices: SQUARE })],
    });
    spawn(world, { position: {}, mass: 500, hull: { volume: 1, shape, halfHeight: 0.5 } });
    for (let i = 0; i < 2; i++) step(world, 1 / 60);
    return messages();
  };
  // From corner to corner √2 m: a quarter of 5.66 m.
  expect(warned(5.6)).toMatch(/^body 1 is 1\.41 m long, and the waves 5\.6 m: a hull is lifted and tilted/);
  expect(warned(5.7)).toBe('');
  expect(warned(5.6, 1)).toBe('');
});
