/** Forces that are legal and surely not meant get a warning, once, that says what to do. */
import {
  attractors,
  boris,
  buoyancy,
  constantTorque,
  defineForce,
  defineLaw,
  driftKickDrift,
  electricField,
  explicitEuler,
  type Force,
  fixedCharges,
  type Integrator,
  leapfrog,
  lennardJones,
  lift,
  linearDrag,
  magneticField,
  magnus,
  mutualCoulomb,
  mutualGravity,
  paczynskiWiita,
  pointerPull,
  powerLaw,
  quadraticDrag,
  type Restrictions,
  randomDrive,
  restrictForce,
  rigidBodies,
  rocketEngines,
  rungeKutta4,
  semiImplicitEuler,
  softStep,
  spawn,
  springs,
  step,
  turbulentDrag,
  uniformGravity,
  uniformSphereGravity,
  velocityVerlet,
  wisdomHolman,
  yoshida4,
  yoshida6,
  yukawa,
} from '@principia/physics';
import { expect, it } from 'vitest';
import { warnedWorld } from '../support/warned-world.ts';

/** What a world says of forces that act twice. */
function saidOf(forces: readonly Force[], integrator: Integrator = velocityVerlet): string {
  const { world, messages } = warnedWorld({ forces, integrator });
  spawn(world, { position: { x: 1 }, velocity: { x: 0.1 }, mass: 1, charge: 1e-6, linearDrag: 1, lift: 1 });
  spawn(world, { position: { x: 3 }, mass: 1, charge: 1e-6 });
  for (let i = 0; i < 2; i++) step(world, 1e-4);
  return messages()
    .split('\n')
    .filter((message) => message.includes('twice with the same parameters'))
    .join('\n');
}

const own = defineForce({ name: 'own', accumulate() {} });
const turbulence = { deviation: 1, largest: 1, modes: 4 };

it.each<[string, () => Force]>([
  ['uniform gravity', () => uniformGravity()],
  ['linear drag', () => linearDrag()],
  ['springs', () => springs()],
  ['attractors', () => attractors()],
  ['attractors', () => attractors({ lightSpeed: 1e3 })],
  ['mutual gravity', () => mutualGravity({ G: 1 })],
  ['mutual Coulomb', () => mutualCoulomb({ softening: 0.1 })],
  ['fixed charges', () => fixedCharges()],
  ['lift', () => lift()],
  ['lift', () => lift({ wind: { x: 2 } })],
  ['random drive', () => randomDrive({ spectralDensity: 1, seed: 3 })],
  ['turbulent drag', () => turbulentDrag({ ...turbulence, seed: 3 })],
  ['uniform gravity (restricted)', () => restrictForce(uniformGravity(), { from: 1, until: 2 })],
])('names %s that is listed twice, and once it says nothing', (name, make) => {
  expect(saidOf([make()])).toBe('');
  const message = `the force "${name}" is in \`world.forces\` twice with the same parameters, and acts twice.`;
  expect(saidOf([make(), make()])).toBe(message);
});

it.each<[string, Force]>([
  ['pointer pull', pointerPull()],
  ['own', own],
  ['springs (restricted)', restrictForce(springs(), { group: 'Charge' })],
  ['linear drag', linearDrag((time) => ({ x: time }))],
])('names one and the same %s that is listed twice', (name, force) => {
  expect(saidOf([force, force])).toContain(`the force "${name}"`);
});

it.each<[string, Force, Force]>([
  ['springs of two groups', restrictForce(springs(), { group: 'Charge' }), restrictForce(springs(), { group: 'Lift' })],
  ['attractors with other horizons', attractors(), attractors({ lightSpeed: 1e3 })],
  ['gravity with two softenings', mutualGravity({ softening: 0.1 }), mutualGravity({ softening: 0.2 })],
  ['gravity of two laws', mutualGravity(), mutualGravity({ law: 'inverse-distance' })],
  ['noise of two seeds', randomDrive({ spectralDensity: 1, seed: 1 }), randomDrive({ spectralDensity: 1, seed: 2 })],
  ['noise without seeds', randomDrive({ spectralDensity: 1 }), randomDrive({ spectralDensity: 1 })],
  ['turbulence of two seeds', turbulentDrag(turbulence), turbulentDrag({ ...turbulence, seed: 2 })],
  ['two pointers', pointerPull(), pointerPull()],
  ['lift along two spans', lift({ frame: 'body' }), lift()],
  ['lift in two winds', lift({ wind: { x: 2 } }), lift({ wind: { x: 3 } })],
  ['functions of one’s own', own, defineForce({ name: 'own', accumulate() {} })],
  ['winds that are functions', linearDrag((time) => ({ x: time })), linearDrag((time) => ({ x: 2 * time }))],
])('says nothing of %s', (_, a, b) => {
  expect(saidOf([a, b])).toBe('');
});

it('names two constants of gravity that differ, and no others', () => {
  const warned = (own: { G?: number }, ...Gs: number[]) => {
    const forces = Gs.map((G) => mutualGravity({ G }));
    const { world, messages } = warnedWorld({ forces, integrator: wisdomHolman(own) });
    spawn(world, { position: {}, mass: 1 });
    spawn(world, { position: { x: 1 }, velocity: { y: 1 }, mass: 1e-3 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned({}, 1)).toBe('wisdomHolman has G = 6.6743e-11, but mutualGravity has G = 1: the orbits are wrong.');
  expect(warned({ G: 1 }, 1)).toBe('');
  expect(warned({ G: 1 }, 1 + 1e-12)).toBe('');
  // Two forces may share one constant.
  expect(warned({ G: 1 }, 0.75, 0.25)).toBe('');
});

it('names a magnetic field that acts by boris and by a force', () => {
  const warned = (field: number, ofForce: number) => {
    const forces = [magneticField({ z: ofForce })];
    const { world, messages } = warnedWorld({ forces, integrator: boris({ field: { z: field } }) });
    spawn(world, { position: {}, velocity: { x: 1 }, mass: 1, charge: 1 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned(0.5, 0.5)).toBe('the magnetic field of boris is in `world.forces` as well, and acts twice.');
  // Another field adds to that of the integrator.
  expect(warned(0.5, 0.2)).toBe('');
  expect(warned(0, 0)).toBe('');
});

it.each([2, 3] as const)('names a body that a torque does not turn, %d D', (dimensions) => {
  const turning = dimensions === 2 ? { rotation: 0, angularVelocity: 0 } : { orientation: {}, angularVelocity: {} };
  const warned = (init: object, forces = [constantTorque({ z: 1 })]) => {
    const { world, messages } = warnedWorld({ dimensions, forces });
    spawn(world, { position: {}, mass: 1, ...init });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  const message = 'constantTorque does not turn body 1, because it has Inertia and no AngularVelocity.';
  expect(warned({ inertia: 1 })).toBe(message);
  expect(warned({ inertia: 1, ...turning })).toBe('');
  expect(warned({ inertia: Number.POSITIVE_INFINITY })).toBe('');
  expect(warned({})).toBe('');
  expect(warned({ inertia: 1 }, [])).toBe('');
});

it('names gravity along z in a 2D world', () => {
  const warned = (dimensions: 2 | 3, acceleration: object) => {
    const { world, messages } = warnedWorld({ dimensions, forces: [uniformGravity(acceleration)] });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned(2, { z: -9.8 })).toBe('uniformGravity has z = -9.8, which has no effect in a 2D world.');
  expect(warned(2, { y: -9.8, z: 0 })).toBe('');
  expect(warned(3, { z: -9.8 })).toBe('');
});

it('says that buoyancy carries nothing without a hull', () => {
  const { world, messages } = warnedWorld({ forces: [buoyancy({ density: 1000, level: 0 })] });
  step(world, 0.01);
  expect(messages()).toBe('');
  spawn(world, { position: {}, mass: 1, collider: 0.5 });
  step(world, 0.01);
  expect(messages()).toBe('buoyancy has no effect, because no body of this world has a Hull.');
  const floating = warnedWorld({ forces: [buoyancy({ density: 1000, level: 0 })] });
  spawn(floating.world, { position: {}, mass: 1, collider: 0.5 });
  spawn(floating.world, { position: {}, mass: 1, hull: 0.01 });
  step(floating.world, 0.01);
  expect(floating.messages()).toBe('');
});

it('names schemes that a force of the velocity makes first order', () => {
  const warned = (integrator: Integrator, force: Force, charge?: number) => {
    const { world, messages } = warnedWorld({ forces: [force], integrator });
    spawn(world, { position: {}, velocity: { x: 1 }, mass: 1, ...(charge !== undefined && { charge }) });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  const field = magneticField({ z: 1.3 });
  for (const integrator of [leapfrog, driftKickDrift, yoshida4, yoshida6]) {
    expect(warned(integrator, field, 1)).toBe(
      `${integrator.name} is of first order with the force "magnetic field", which depends on the velocity, and may be worse than Euler's scheme.`,
    );
    expect(warned(integrator, uniformGravity())).toBe('');
  }
  expect(warned(leapfrog, field)).toBe('');
  expect(warned(velocityVerlet, field, 1)).toBe('');
  expect(warned(rungeKutta4, field, 1)).toBe('');
});

it('names charges that rigid bodies spiral outwards, with the rate', () => {
  const warned = (field: number, integrator = softStep()) => {
    const { world, messages } = warnedWorld({ preset: rigidBodies, integrator, forces: [magneticField({ z: field })] });
    spawn(world, { position: {}, velocity: { x: 3 }, mass: 1, charge: 1, collider: 0.1 });
    for (let i = 0; i < 2; i++) step(world, 1 / 60);
    return messages();
  };
  // Ω² h/2 with Ω = 5/s and sub-steps of 1/240 s.
  expect(warned(5)).toMatch(/^charges in the magnetic field gain 5.2 % of their speed a second/);
  expect(warned(0.1)).toBe('');
  expect(warned(0.5, softStep({ substeps: 1000 }))).toBe('');
});

it.each([semiImplicitEuler, explicitEuler, velocityVerlet, rungeKutta4])(
  'names charges that $name makes faster',
  (integrator) => {
    const warned = (field: number) => {
      const { world, messages } = warnedWorld({ dimensions: 3, integrator, forces: [magneticField({ x: field })] });
      spawn(world, { position: {}, velocity: { y: 3 }, mass: 1, charge: 1 });
      step(world, 1e-3);
      return messages();
    };
    // Ω² h/2 with Ω = 6/s.
    const gains = /^charges in the magnetic field gain 1.8 % of their speed a second, because the integrator is/;
    const isFirstOrder = integrator.order === 1;
    expect(warned(6)).toMatch(isFirstOrder ? gains : /^$/);
    expect(warned(0.1)).toBe('');
  },
);

it('names what lift and spin make faster, by as much as it gets faster', () => {
  const dt = 1 / 60;
  const flown = (force: Force, init: object, options: object, seconds = 0) => {
    const { world, messages } = warnedWorld({ precision: 'f64', forces: [force, quadraticDrag()], ...options });
    const body = { position: {}, velocity: { x: 20 }, mass: 0.0027, rotation: 0, collider: 0.02, ...init };
    const id = spawn(world, body);
    step(world, dt);
    for (let time = dt; time < seconds - dt / 2; time += dt) step(world, dt);
    const { x, y } = world.components.Velocity;
    return { said: messages(), speed: Math.sqrt(x[id] * x[id] + y[id] * y[id]) };
  };
  const ball = { inertia: 1e-6, angularVelocity: 300 };
  const omega = (Math.PI * 1.2 * 0.02 ** 3 * 300) / 0.0027;
  // A step or sub-step multiplies the speed by √(1 + Ω² h²), which the rate of the warning says.
  const cases = [
    [{ preset: rigidBodies }, dt / 4],
    [{ integrator: semiImplicitEuler }, dt],
  ] as const;
  for (const [options, h] of cases) {
    const { said, speed } = flown(magnus({ density: 1.2 }), ball, options, 10);
    const percent = Number(((50 * Math.log1p((omega * h) ** 2)) / h).toPrecision(2));
    expect(said.startsWith(`"Magnus force" makes body 1 faster by ${percent} % a second, though it does no work`)).toBe(
      true,
    );
    // The percentage has two digits.
    expect(Math.log(speed / 20) / 10 / (percent / 100)).toBeCloseTo(1, 1);
    expect(flown(lift(), { lift: 5e-4 }, options).said).toMatch(/^"lift" makes body 1 faster by/);
    // Drag takes more than is gained, 20 m/s 1.35·10⁻³ kg/m/2.7 g = 10/s.
    expect(flown(lift(), { lift: 5e-4, quadraticDrag: 1.35e-3 }, options).said).toBe('');
  }
  expect(flown(magnus({ density: 1.2 }), ball, {}).said).toBe('');
  expect(flown(lift(), { lift: 5e-4 }, { integrator: rungeKutta4 }).said).toBe('');
});

it('names planets that nothing attracts', () => {
  const warned = (forces: Force[]) => {
    const { world, messages } = warnedWorld({ forces, integrator: wisdomHolman({ G: 1 }) });
    spawn(world, { position: {}, mass: 1 });
    spawn(world, { position: { x: 1 }, velocity: { y: 1 }, mass: 1e-3 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned([])).toMatch(/^wisdomHolman moves nothing on orbits by itself/);
  expect(warned([mutualGravity({ G: 1 })])).toBe('');
});

it('names planets of wisdomHolman that were not created outwards', () => {
  const warned = (distances: readonly number[], isTest = false) => {
    const integrator = wisdomHolman({ G: 1 });
    const { world, messages } = warnedWorld({ forces: [mutualGravity({ G: 1 })], integrator });
    for (const [i, r] of distances.entries()) {
      const last = i === distances.length - 1;
      const round = { position: { x: r }, velocity: { y: 1 / Math.sqrt(r) }, mass: 1e-4 };
      spawn(world, { ...round, ...(last && isTest && { testParticle: {} }) });
    }
    // The star may be created at any time.
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    for (let i = 0; i < 2; i++) step(world, 0.01);
    return messages();
  };
  expect(warned([1, 1.9, 5.2])).toBe('');
  expect(warned([1, 5.2, 1.9])).toMatch(
    /^wisdomHolman takes planets in the order in which they were created, and body 3 moves inside of body 2/,
  );
  expect(warned([1, 5.2, 4.5])).toBe('');
  expect(warned([1, 5.2, 1.9], true)).toBe('');
});

it('names sources that act by two forces', () => {
  const charges = (mass?: number) => {
    const { world, messages } = warnedWorld({ forces: [fixedCharges(1), mutualCoulomb({ k: 1 })] });
    spawn(world, { position: {}, charge: 1, ...(mass !== undefined && { mass }) });
    spawn(world, { position: { x: 1 }, velocity: {}, mass: 1, charge: 1 });
    step(world, 1e-4);
    return messages();
  };
  expect(charges()).toBe('charges without mass act twice: by fixedCharges and by mutualCoulomb, which includes them.');
  expect(charges(1)).toBe('');
  const masses = (mass?: number) => {
    const { world, messages } = warnedWorld({ forces: [attractors(), mutualGravity({ G: 1 })] });
    spawn(world, { position: {}, attractor: 1, ...(mass !== undefined && { mass }) });
    spawn(world, { position: { x: 1 }, velocity: {}, mass: 1e-6 });
    step(world, 1e-4);
    return messages();
  };
  expect(masses(1)).toBe('body 1 has Attractor and Mass, and attracts twice: by attractors and by mutualGravity.');
  expect(masses()).toBe('');
});

it('names forces of pairs that are restricted to some bodies', () => {
  const warned = (limits: Restrictions) => {
    const { world, messages } = warnedWorld({ forces: [restrictForce(springs(), limits)] });
    const a = spawn(world, { position: {}, velocity: {}, mass: 1 });
    const b = spawn(world, { position: { x: 1 }, velocity: {}, mass: 1 });
    spawn(world, { spring: { a, b, stiffness: 10, length: 0.5 } });
    step(world, 0.01);
    return messages();
  };
  expect(warned({ group: 'Mass' })).toMatch(
    /^"springs" restricted to some bodies or a region acts on one end of a pair/,
  );
  // They do act, and time takes both ends.
  expect(warned({ from: 0 })).toBe('');
});

it('names fuel that is more than the mass that includes it, and an engine without mass', () => {
  const warned = (mass?: number) => {
    const { world, messages } = warnedWorld({ forces: [rocketEngines()] });
    spawn(world, { position: {}, mass, engine: { exhaustSpeed: 100, burnRate: 1, fuel: 5 } });
    step(world, 0.01);
    return messages();
  };
  expect(warned(1)).toMatch(/^body 1 has 4.99\d* kg of fuel in a mass of 0.99\d* kg, which includes the fuel\.$/);
  expect(warned(6)).toBe('');
  expect(warned()).toMatch(/^the engine of body 1 pushes nothing, because the body has no Mass\.$/);
});

it('names a law whose potential is not that of its force', () => {
  const warned = (factor: number) => {
    const bowl = defineLaw({
      name: 'bowl',
      acceleration: ({ position }) => position.negate(),
      potential: ({ position, mass }) => mass.mul(position.lengthSquared()).mul(factor),
    });
    const { world, messages } = warnedWorld({ forces: [bowl()] });
    spawn(world, { position: { x: 1, y: -0.3 }, velocity: {}, mass: 2 });
    step(world, 0.01);
    return messages();
  };
  const message =
    'the force of "bowl" is not minus the gradient of its potential, as at body 1: energy(world) is wrong.';
  expect(warned(1)).toBe(message);
  expect(warned(-0.5)).toBe(message);
  expect(warned(0.5)).toBe('');
});

it('finds nothing to say about the potentials of this package', () => {
  const forces = [
    uniformGravity(),
    uniformSphereGravity({ mu: 3, radius: 1 }),
    paczynskiWiita({ mu: 4, horizon: 0.1 }),
    powerLaw({ strength: -2, exponent: 1.5 }),
    lennardJones({ depth: 1, diameter: 1 }),
    yukawa({ strength: 2, range: 0.7 }),
    electricField({ x: 3, y: 1 }),
  ];
  const { world, messages } = warnedWorld({ forces, dimensions: 3 });
  spawn(world, { position: { x: 1.3, y: -0.7, z: 0.4 }, velocity: { x: 1 }, mass: 2, charge: -1 });
  spawn(world, { position: { x: 0.3, y: 0.1, z: 0.2 }, velocity: { x: 1 }, mass: 2, charge: -1 });
  step(world, 1e-4);
  expect(messages()).toBe('');
});
