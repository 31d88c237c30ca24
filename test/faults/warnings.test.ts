/** Input that is legal but surely not meant gets a warning, once, that says what to do. */
import {
  boris,
  box,
  boxWalls,
  breakSprings,
  COMBINE,
  circle,
  createJoint,
  createRope,
  createRunner,
  defineForce,
  distance,
  linearDrag,
  on,
  particleContacts,
  quadraticDrag,
  restrictForce,
  revolute,
  rgba,
  rigidBodies,
  type SoftStepOptions,
  type System,
  softStep,
  spawn,
  spawnMany,
  springs,
  step,
  uniformGravity,
} from '@principia/physics';
import { addComponent, removeComponent, set } from 'bitecs';
import { expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

it('is silent in an ordinary world', () => {
  const walls = [boxWalls({ min: { x: -5, y: -5 }, max: { x: 5, y: 5 } })];
  const { world, warnings } = warnedWorld({
    preset: particleContacts,
    forces: [uniformGravity(), linearDrag()],
    walls,
  });
  spawn(world, { position: {}, mass: 1, linearDrag: 0.1, collider: 0.5 });
  spawn(world, { segmentWall: { ax: -1, bx: 1 } });
  on(world, 'contact', () => {});
  const runner = createRunner(world);
  for (let i = 0; i < 5; i++) runner.advance(1 / 60);
  expect(warnings).toEqual([]);
});

it('names walls that nothing runs, once', () => {
  const { world, warnings, messages } = warnedWorld();
  spawn(world, { segmentWall: { ax: -1, bx: 1 } });
  spawn(world, { planeWall: { ny: 1 } });
  for (let i = 0; i < 3; i++) step(world, 0.01);
  expect(messages()).toBe(
    'bodies pass through every SegmentWall, because no system of this world runs them.\n' +
      'bodies pass through every PlaneWall, because no system of this world runs them.',
  );
  expect(warnings[0].hint).toContain('particleContacts');
});

it('names a handler of contacts that is never called, also one that comes later', () => {
  const { world, messages } = warnedWorld();
  step(world, 0.01);
  on(world, 'wallContact', () => {});
  step(world, 0.01);
  expect(messages()).toMatch(/^a handler of "wallContact" is never called/);
});

it('sends who waits for contacts of rigid bodies to their lists', () => {
  const { world, warnings } = warnedWorld({ preset: rigidBodies });
  on(world, 'contact', () => {});
  step(world, 0.01);
  expect(warnings[0].hint).toContain('contactEvents(world)');
});

it('names a coefficient that no force reads, and the force to add', () => {
  const { world, warnings, messages } = warnedWorld({ forces: [uniformGravity()] });
  spawn(world, { position: {}, mass: 1, linearDrag: 2 });
  step(world, 0.01);
  expect(messages()).toBe('LinearDrag has no effect, because no force of this world reads it.');
  expect(warnings[0].hint).toBe('Add linearDrag() to `forces`.');
});

it.each([
  ['GravityScale', 'value', 0.01],
  ['MotionLocks', 'y', 1],
] as const)(
  'names a value of %s that counts for nothing, because the body lacks the component',
  (name, field, value) => {
    const { world, warnings, messages } = warnedWorld({ preset: rigidBodies, forces: [uniformGravity()] });
    const [without, with_] = [0, 9].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 1 }));
    addComponent(world, with_, set(world.components[name], { [field]: value }));
    (world.components[name] as Record<string, { [row: number]: number }>)[field][without] = value;
    step(world, 0.01);
    expect(messages()).toBe(
      `${name}.${field} of body ${without} is ${value} and has no effect, because the body does not have ${name}.`,
    );
    expect(warnings[0].hint).toContain(
      `addComponent(world, id, set(world.components.${name}, { ${field}: ${value} }))`,
    );
    expect(world.components.Velocity.y[without]).toBeLessThan(-0.09);
    expect(world.components.Velocity.y[with_]).toBeGreaterThan(-0.01);
  },
);

it('knows that an integrator reads charges', () => {
  const { world, warnings } = warnedWorld({ integrator: boris({ field: { z: 1 } }) });
  spawn(world, { position: {}, mass: 1, charge: 2 });
  step(world, 0.01);
  expect(warnings).toEqual([]);
});

it('names a force that is there twice, but not two of different parameters', () => {
  const { world, messages } = warnedWorld({ forces: [uniformGravity(), uniformGravity({ y: -1 })] });
  step(world, 0.01);
  expect(messages()).toBe('');
  world.forces.push(uniformGravity({ y: -1 }));
  step(world, 0.01);
  expect(messages()).toMatch(/^the force "uniform gravity" is in `world.forces` twice/);
});

it('names in large worlds, too, what a body lacks that came when bodies come in every step, a few steps later', () => {
  const { world, messages } = warnedWorld({ capacity: 10_000 });
  spawnMany(world, 8000, { position: {}, velocity: {}, mass: 1 });
  step(world, 0.01);
  spawn(world, { position: {}, velocity: {}, mass: 1, linearDrag: 1 });
  for (let i = 0; i < 10; i++) {
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    step(world, 0.01);
  }
  expect(messages()).toMatch(/^LinearDrag has no effect/);
});

it('does not take a force restricted to two regions, or to two times, for one that is there twice', () => {
  const left = { region: { min: { x: -2 }, max: { x: -1 } } };
  const limits = [left, { region: { min: { x: 1 }, max: { x: 2 } } }, { until: 1 }, { from: 2 }, { from: 3 }];
  const { world, messages } = warnedWorld({ forces: limits.map((where) => restrictForce(uniformGravity(), where)) });
  step(world, 0.01);
  expect(messages()).toBe('');
  world.forces.push(restrictForce(uniformGravity(), left));
  step(world, 0.01);
  expect(messages()).toMatch(/^the force "uniform gravity \(restricted\)" is in `world.forces` twice/);
});

it('recognises milliseconds, and lets a page that was hidden go on', () => {
  const { world, messages } = warnedWorld();
  step(world, 16.7);
  expect(messages()).toBe('step got 16.7, which looks like milliseconds; times are in seconds.');

  const frames = warnedWorld();
  const runner = createRunner(frames.world);
  runner.advance(16.7);
  expect(frames.messages()).toBe('');
  runner.advance(16.7);
  expect(frames.messages()).toMatch(/^advance got 16.7/);

  const slow = warnedWorld();
  createRunner(slow.world, { dt: 16.7 });
  expect(slow.messages()).toMatch(/^createRunner: dt got 16.7/);
  const orbits = warnedWorld();
  createRunner(orbits.world, { dt: 3600 });
  step(orbits.world, 86_400);
  expect(orbits.messages()).toBe('');
});

it('warns once of frames in milliseconds, although each has another length', () => {
  const { world, warnings } = warnedWorld();
  const runner = createRunner(world);
  for (let i = 0; i < 20; i++) runner.advance(16.7 + i / 100);
  expect(warnings.length).toBe(1);
});

it('names springs that nothing solves, and springs that cannot break', () => {
  const { world, messages } = warnedWorld({ forces: [uniformGravity()] });
  const a = spawn(world, { position: {} });
  const b = spawn(world, { position: { y: -1 }, mass: 1 });
  spawn(world, { spring: { a, b, stiffness: 10, length: 1, breakForce: 5 } });
  step(world, 0.01);
  expect(messages()).toBe(
    'Spring has no effect, because neither a force nor the integrator of this world solves springs.\n' +
      'springs with a `breakForce` do not break, because no system of this world breaks springs.',
  );
  const { world: torn, warnings } = warnedWorld({ forces: [springs()] });
  torn.phases.finish.push((world) => breakSprings(world));
  createRope(torn, { from: {}, to: { x: 1 }, nodes: 3, mass: 1, stiffness: 10, breakForce: 5 });
  step(torn, 0.01);
  expect(warnings).toEqual([]);
});

it('tells a world without a handler of its first fault', () => {
  const { world, warnings, messages } = warnedWorld();
  const body = spawn(world, { position: {}, mass: 1 });
  for (let i = 0; i < 3; i++) {
    world.components.Velocity.x[body] = Number.NaN;
    step(world, 0.01);
  }
  expect(messages()).toMatch(/^E_NONFINITE: Velocity.x of entity 1 was NaN/);
  expect(warnings.length).toBe(1);

  const handled = warnedWorld();
  on(handled.world, 'fault', () => {});
  const other = spawn(handled.world, { position: {}, mass: 1 });
  handled.world.components.Velocity.x[other] = Number.NaN;
  step(handled.world, 0.01);
  expect(handled.warnings).toEqual([]);
});

it('says that a box falls through a floor in a world that knows no shapes', () => {
  const { world, warnings, messages } = warnedWorld();
  spawn(world, { position: { y: -1 }, collider: { shape: box(9, 1) } });
  step(world, 0.01);
  expect(warnings).toEqual([]);
  spawn(world, { position: { y: 1 }, collider: { shape: box(1, 1), density: 1 } });
  step(world, 0.01);
  expect(messages()).toBe('body 2 passes through body 1, because no system of this world knows shapes.');
  expect(warnings[0].hint).toContain('rigidBodies');
});

it('says that a ball falls through a box, too', () => {
  const { world, messages } = warnedWorld();
  spawn(world, { position: { y: -1 }, collider: { shape: box(9, 1) } });
  spawn(world, { position: { y: 3 }, mass: 1, collider: { radius: 0.5, mask: 0 } });
  step(world, 0.01);
  expect(messages()).toBe('');
  spawn(world, { position: { y: 1 }, mass: 1, collider: 0.5 });
  step(world, 0.01);
  expect(messages()).toBe('body 3 passes through body 1, because no system of this world knows shapes.');
});

it('says that contacts of particles take a box for the disc around it', () => {
  const { world, messages } = warnedWorld({ preset: particleContacts });
  spawn(world, { position: { y: -1 }, collider: { shape: box(20, 1) } });
  step(world, 0.01);
  expect(messages()).toBe('');
  spawn(world, { position: { y: 30 }, mass: 1, collider: { shape: circle(0.5) } });
  step(world, 0.01);
  expect(messages()).toBe(
    'body 1 meets others as a disc of 10 m, the circle around its shape, because the contacts of this world know discs only.',
  );
});

it.each(['frictionCombine', 'restitutionCombine'] as const)('says that particles have no %s', (rule) => {
  const { world, messages } = warnedWorld({ preset: particleContacts });
  spawn(world, { position: {}, mass: 1, collider: { radius: 0.5, [rule]: COMBINE.min } });
  step(world, 0.01);
  expect(messages()).toBe(`body 1 has \`collider.${rule}\`, which has no effect: only rigid bodies have it.`);
});

it('names a rigid body that friction cannot roll, unless that is said to be meant', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  const collider = { radius: 0.5, friction: 1 };
  spawn(world, { position: {}, mass: 1, inertia: Number.POSITIVE_INFINITY, collider });
  spawn(world, { position: { x: 2 }, mass: 1, motionLocks: { angle: true }, collider });
  spawn(world, { position: { x: 4 }, collider: { ...collider, density: 1 } });
  step(world, 0.01);
  expect(messages()).toBe('');
  const { AngularVelocity, Inertia } = world.components;
  const disc = (x: number) => spawn(world, { position: { x }, mass: 1, collider });
  removeComponent(world, disc(6), Inertia);
  removeComponent(world, disc(8), AngularVelocity);
  step(world, 0.01);
  expect(messages()).toBe(
    'body 4 does not turn or roll, because it has no Inertia.\n' +
      'body 5 does not turn, because it has Inertia and no AngularVelocity.',
  );
});

it('says that a static body does not fall because it gets a mass', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  const block = spawn(world, { position: { y: 3 }, collider: { radius: 0.5 } });
  step(world, 0.01);
  expect(messages()).toBe('');
  addComponent(world, block, set(world.components.Mass, { value: 10 }));
  step(world, 0.01);
  expect(messages()).toBe('body 1 has a mass and stands still, because it has no Velocity.');
});

it('reports a handler that rejects, which no step can throw any more', async () => {
  const { world, messages } = warnedWorld({ preset: particleContacts });
  for (const x of [0, 0.9]) spawn(world, { position: { x }, mass: 1, collider: 0.5 });
  on(world, 'contact', (async () => {
    throw new Error('too late');
  }) as () => void);
  step(world, 0.01);
  await Promise.resolve();
  expect(messages()).toBe('an asynchronous handler of "contact" was rejected: Error: too late');
});

it('reports a system that rejects', async () => {
  const { world, messages } = warnedWorld();
  const rejects: unknown = async () => {
    throw new Error('too late');
  };
  world.phases.input.push(rejects as System);
  step(world, 0.01);
  await Promise.resolve();
  expect(messages()).toBe('an asynchronous system of the phase "input" was rejected: Error: too late');
});

it('says that a colour as the web writes it is invisible, and not of one made by rgba', () => {
  const { world, messages } = warnedWorld();
  for (const color of [rgba(1, 0, 0), rgba(0, 0, 0, 0), 0]) spawn(world, { position: {}, appearance: { color } });
  spawnMany(world, 2, { position: {}, appearance: { color: rgba(0, 1, 0) } });
  expect(messages()).toBe('');
  spawn(world, { position: {}, appearance: { color: 0xff00 } });
  expect(messages()).toContain('the colour 0x00ff00 is invisible');
  const other = warnedWorld();
  spawnMany(other.world, 2, { position: {}, appearance: 0xff0000 });
  expect(other.messages()).toContain('the colour 0xff0000 is invisible');
});

it('says that bodies with a surface pass through each other where nothing runs contacts', () => {
  const surface = { radius: 0.5, restitution: 0.8 };
  const { world, messages } = warnedWorld();
  spawn(world, { position: {}, mass: 1, collider: { radius: 0.5 } });
  step(world, 0.01);
  expect(messages()).toBe('');
  for (const x of [2, 4]) spawn(world, { position: { x }, mass: 1, collider: surface });
  step(world, 0.01);
  expect(messages()).toBe(
    'body 2 has restitution or friction and passes through everything, because no system of this world runs contacts or walls.',
  );
  for (const options of [
    { preset: particleContacts },
    { preset: rigidBodies },
    { walls: [boxWalls({ min: { x: -5, y: -5 }, max: { x: 5, y: 5 } })] },
  ]) {
    const other = warnedWorld(options);
    spawn(other.world, { position: {}, mass: 1, collider: surface });
    step(other.world, 0.01);
    expect(other.messages()).toBe('');
  }
});

it('says that a body without a position goes nowhere', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  spawn(world, { position: {}, collider: { shape: box(1, 1), density: 1 } });
  step(world, 0.01);
  expect(messages()).toBe('');
  spawn(world, { rotation: -0.3, collider: { shape: box(40, 1) } });
  step(world, 0.01);
  expect(messages()).toBe(
    'entity 2 has Mass, Velocity or Collider and no Position, so that nothing moves or meets it.',
  );
});

it('says when a rod is made longer than its anchors are apart, and by the true distance when limits are left', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  const disc = (x: number) => spawn(world, { position: { x }, rotation: 0.3, mass: 1, collider: { radius: 0.1 } });
  const [a, b] = [disc(0), disc(1)];
  createJoint(world, distance({ a, b, anchorB: { x: 1.5 } }));
  createJoint(world, distance({ a, b, length: 3, limits: { upper: 1.2 } }));
  expect(messages()).toBe('');
  createJoint(world, distance({ a, b, length: 3 }));
  expect(messages()).toBe(
    'a rod of 3 m was made between anchors that are 1 m apart. It is brought to its length in the next steps.',
  );
});

it('says that a kinematic body without Rotation does not turn', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies });
  spawn(world, { position: {}, rotation: 0, velocity: {}, angularVelocity: 1, collider: { radius: 0.1 } });
  step(world, 1 / 60);
  expect(messages()).toBe('');
  const still = spawn(world, { position: { x: 5 }, velocity: {}, angularVelocity: 1, collider: { radius: 0.1 } });
  step(world, 1 / 60);
  expect(messages()).toBe(`body ${still} has an angular velocity and does not turn, because it has no Rotation.`);
});

it('says when a joint is made beyond its limits, once for each kind', () => {
  const { world, warnings, messages } = warnedWorld({ preset: rigidBodies });
  const post = spawn(world, { position: {}, collider: { shape: box(1, 1) } });
  const far = () => spawn(world, { position: { x: 5 }, collider: { shape: box(1, 1), density: 1 } });
  createJoint(world, distance({ a: post, b: far(), limits: { upper: 5.04 } }));
  createJoint(world, revolute({ a: post, b: far(), anchor: { x: 5 }, limits: { lower: 0, upper: 1 } }));
  expect(warnings).toEqual([]);
  for (let i = 0; i < 2; i++) createJoint(world, distance({ a: post, b: far(), limits: { upper: 3 } }));
  createJoint(world, revolute({ a: post, b: far(), anchor: { x: 5 }, limits: { lower: 0.5, upper: 1 } }));
  expect(messages()).toBe(
    'a distance joint was made beyond its limits: its anchors are 5 m apart, more than its upper limit, 3. It is pulled there in the next steps.\n' +
      'a revolute joint was made beyond its limits: its coordinate is 0, less than its lower limit, 0.5. It is pulled there in the next steps.',
  );
  expect(warnings[1].hint).toContain('let the limits include 0');
});

it('says that contacts let small bodies sink in, and by how much', () => {
  const rest = (edge: number, options: SoftStepOptions = {}) => {
    const integrator = softStep({ sleepTime: 0, ...options });
    const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [uniformGravity({ y: -10 })], integrator });
    spawn(world, { position: { y: -1 }, collider: { shape: box(2, 2), friction: 0.5 } });
    const [lower, upper] = [0.5, 1.5].map((y) =>
      spawn(world, { position: { y: y * edge }, collider: { shape: box(edge, edge), density: 1, friction: 0.5 } }),
    );
    for (let i = 0; i < 240; i++) step(world, 1 / 60);
    const { y } = world.components.Position;
    return { messages: messages(), overlap: edge - (y[upper] - y[lower]) };
  };
  const dice = rest(0.01);
  // 2.5 g/ω² at 30 Hz: 25/(60 π)² = 0.7036 mm, 10 % of 7.1 mm.
  expect(dice.messages).toContain('presses it 0.7 mm into another like it, 10 % of its radius');
  expect(dice.overlap / (25 / (60 * Math.PI) ** 2)).toBeCloseTo(1, 4);
  expect(rest(0.02).messages).toBe('');
  expect(rest(0.01, { substeps: 16, contactHertz: 120 }).messages).toBe('');
});

it('does not say so of a bob that touches nothing', () => {
  const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [uniformGravity()] });
  const a = spawn(world, { position: {}, collider: { radius: 0.01, mask: 0 } });
  const b = spawn(world, { position: { y: -1 }, mass: 1, collider: { radius: 0.01, mask: 0 } });
  createJoint(world, distance({ a, b }));
  step(world, 1 / 60);
  expect(messages()).toBe('');
});

it('is not misled by a force of the name of gravity', () => {
  const gravity = defineForce({ name: 'uniform gravity', equation: 'F = 0', reads: [], accumulate() {} });
  const { world, messages } = warnedWorld({ preset: rigidBodies, forces: [gravity] });
  spawn(world, { position: {}, collider: { shape: box(0.001, 0.001), density: 1 } });
  step(world, 1 / 60);
  expect(messages()).toBe('');
});

it('says that a drag is too strong for the step, and where the limit is', () => {
  const { world, messages, warnings } = warnedWorld({ forces: [linearDrag(), quadraticDrag()] });
  const body = spawn(world, { position: {}, velocity: { x: 5 }, mass: 0.5, linearDrag: 100 });
  step(world, 1 / 60);
  expect(messages()).toBe(
    `the drag of body ${body} takes more of its speed in a step than it has, and throws it back faster.`,
  );
  // c/m = 200/s.
  expect(warnings[0].hint).toContain('steps below 0.0050 s');
  const calm = warnedWorld({ forces: [linearDrag(), quadraticDrag()] });
  spawn(calm.world, { position: {}, velocity: { x: 5 }, mass: 0.5, linearDrag: 30, quadraticDrag: 1 });
  step(calm.world, 1 / 60);
  expect(calm.messages()).toBe('');
});

it.each(['sensor', 'bullet', 'oneWay', 'group', 'rollingResistance', 'tangentSpeed'] as const)(
  'says that a collider’s %s is of rigid bodies only',
  (field) => {
    const { world, messages } = warnedWorld({ preset: particleContacts });
    const body = spawn(world, { position: {}, mass: 1, collider: { radius: 1, [field]: 1 } });
    step(world, 1 / 60);
    expect(messages()).toBe(`body ${body} has \`collider.${field}\`, which has no effect: only rigid bodies have it.`);
  },
);
