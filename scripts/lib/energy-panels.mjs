/** What docs/integrators.md draws: which schemes share a panel, and on which problem each panel measures them. */

/** Semi-major axis 1 about μ = 1, so that an orbit takes 2π. */
const ECCENTRICITY = 0.3;

/** A planet on a Kepler orbit, at its periapsis: the problem of all panels that name no other. */
export const planet = {
  /**
   * @param {any} physics the package
   * @param {any} integrator
   */
  build({ createPhysicsWorld, spawn, attractors }, integrator) {
    const world = createPhysicsWorld({ capacity: 10, integrator, forces: [attractors()] });
    spawn(world, { position: {}, attractor: 1 });
    spawn(world, { ...periapsis(), mass: 1 });
    return world;
  },
};

/** The same planet with a charge, in a magnetic field across its plane that turns it twice in a radian of its orbit. */
const FIELD = { z: 2 };
export const chargedPlanet = {
  /**
   * @param {any} physics
   * @param {any} integrator Boris's scheme knows the field already; others meet it as a force
   */
  build({ createPhysicsWorld, spawn, attractors, magneticField, boris }, integrator) {
    const hasField = integrator.name === 'Boris';
    const world = createPhysicsWorld({
      capacity: 10,
      integrator: hasField ? boris({ field: FIELD }) : integrator,
      forces: hasField ? [attractors()] : [attractors(), magneticField(FIELD)],
    });
    spawn(world, { position: {}, attractor: 1 });
    spawn(world, { ...periapsis(), mass: 1, charge: 1 });
    return world;
  },
};

/** A star and two planets that pull on each other; the orbits counted are those of the inner one. */
export const twoPlanets = {
  /**
   * @param {any} physics
   * @param {any} integrator Wisdom and Holman's map must know the constant of gravity
   */
  build({ createPhysicsWorld, spawn, mutualGravity, wisdomHolman }, integrator) {
    const G = 1;
    const world = createPhysicsWorld({
      capacity: 10,
      integrator: integrator.name === 'Wisdom-Holman' ? wisdomHolman({ G }) : integrator,
      forces: [mutualGravity({ G })],
    });
    spawn(world, { position: {}, velocity: {}, mass: 1 });
    spawn(world, { ...periapsis(), mass: 1e-3 });
    spawn(world, { position: { x: -3 }, velocity: { y: -Math.sqrt(1 / 3) }, mass: 5e-4 });
    return world;
  },
};

function periapsis() {
  const e = ECCENTRICITY;
  return { position: { x: 1 - e }, velocity: { y: Math.sqrt((1 + e) / (1 - e)) } };
}

/**
 * @typedef {{ title: string, note: string, problem: typeof planet, schemes: readonly string[],
 *   beside: readonly string[] }} Panel `schemes` are shown by this panel and no other, `beside` is there to compare.
 * @type {readonly Panel[]}
 */
export const PANELS = [
  {
    title: 'First order',
    note: 'a planet of eccentricity 0.3',
    problem: planet,
    schemes: ['explicitEuler', 'implicitEuler', 'semiImplicitEuler', 'positionFirstEuler'],
    beside: [],
  },
  {
    title: 'Second order, symplectic',
    note: 'a planet of eccentricity 0.3',
    problem: planet,
    schemes: ['positionVerlet', 'velocityVerlet', 'leapfrog', 'driftKickDrift'],
    beside: [],
  },
  {
    title: 'Runge-Kutta of fixed step',
    note: 'a planet of eccentricity 0.3',
    problem: planet,
    schemes: ['midpoint', 'heun', 'rungeKutta4'],
    beside: ['velocityVerlet'],
  },
  {
    title: 'High order, and steps of their own',
    note: 'a planet of eccentricity 0.3',
    problem: planet,
    schemes: ['yoshida4', 'yoshida6', 'dormandPrince', 'gaussRadau'],
    beside: ['velocityVerlet'],
  },
  {
    title: 'For magnetic fields',
    note: 'the planet charged, q B/m twice its angular speed',
    problem: chargedPlanet,
    schemes: ['boris'],
    beside: ['velocityVerlet', 'rungeKutta4'],
  },
  {
    title: 'For planetary systems',
    note: 'two planets of 0.001 and 0.0005 stars',
    problem: twoPlanets,
    schemes: ['wisdomHolman'],
    beside: ['velocityVerlet', 'rungeKutta4'],
  },
];
