import { describe, expect, test } from 'vitest';
import { forceOn, lawOn, run, single, slope } from '../../../../test/support/laws.ts';
import {
  addedMass,
  angularDrag,
  box,
  buoyancy,
  circle,
  createPhysicsWorld,
  energy,
  immersedDrag,
  isAsleep,
  lift,
  magnus,
  PhysicsError,
  polygon,
  polygonBuoyancy,
  replaceForce,
  rigidBodies,
  rungeKutta4,
  spawn,
  sphereDrag,
  sphereDragCoefficient,
  step,
  uniformGravity,
} from '../index.ts';

describe('sphere drag', () => {
  test('the drag curve: Stokes at Re → 0, measured values from 1 to 10⁵ within 6 %', () => {
    // Relative to Stokes' 24/Re the terms are 0.15 Re^0.687, 2.7e-4, and 0.42 Re/24 · Re^1.16/42500, which is
    // negligible.
    expect(Math.abs((sphereDragCoefficient(1e-4) * 1e-4) / 24 - 1 - 0.15 * 1e-4 ** 0.687)).toBeLessThan(1e-12);
    // Source of the table: Clift, Grace and Weber, Bubbles, Drops and Particles (1978), table 5.1.
    for (const [re, measured] of [
      [1, 26.5],
      [10, 4.26],
      [100, 1.087],
      [1000, 0.471],
      [1e4, 0.4],
      [1e5, 0.5],
    ]) {
      // The authors of the curve claim this accuracy.
      expect(Math.abs(sphereDragCoefficient(re) / measured - 1), `Re = ${re}`).toBeLessThan(0.06);
    }
  });

  test('the force follows the curve, and Stokes’ law to rounding at low speed', () => {
    const [density, viscosity, r, v] = [1000, 1e-3, 0.01, 0.3];
    const force = lawOn(sphereDrag({ density, viscosity }), { velocity: { x: v }, collider: r }).x;
    const re = (2 * r * v * density) / viscosity;
    expect(force).toBeCloseTo(-0.5 * density * sphereDragCoefficient(re) * Math.PI * r * r * v * v, 12);
    const slow = lawOn(sphereDrag({ density, viscosity: 1e6 }), { velocity: { x: 1e-6 }, collider: 1 }).x;
    expect(slow / (-6 * Math.PI * 1e6 * 1e-6)).toBeCloseTo(1, 6);
  });

  test('a raindrop of 1 mm falls at 4.03 m/s, a fog droplet of 10 µm at 3.02 mm/s', () => {
    // Gunn and Kinzer, J. Meteorol. 6, 243 (1949), measured 4.03 m/s: 6 % of the drag are 4 % of the speed, as C_d
    // decreases as Re^-0.43 there, and a drop is not quite a rigid sphere. Fog: Stokes' d² ρ g/18η less 0.15 Re^0.687
    // = 0.21 % of it, at Re = 2.0e-3.
    const stokes = (1e-10 * 1000 * 9.80665) / (18 * 1.8e-5);
    for (const [diameter, terminal, within] of [
      [1e-3, 4.03, 0.05 * 4.03],
      [1e-5, stokes * (1 - 0.0021), 1e-4 * stokes],
    ]) {
      const r = diameter / 2;
      const mass = (1000 * 4 * Math.PI * r ** 3) / 3;
      const forces = [uniformGravity(), sphereDrag({ density: 1.2, viscosity: 1.8e-5 })];
      const { world, speed } = single(forces, { mass, collider: r });
      // Slow drops approach their terminal speed as exp(-g t/v).
      run(world, 24 * (terminal / 9.8), terminal / 9.8 / 200);
      expect(Math.abs(speed() - terminal)).toBeLessThan(within);
    }
  });

  test('at rest in the medium there is no drag', () => {
    const law = sphereDrag({ density: 1, viscosity: 1, wind: { x: 3 } });
    expect(lawOn(law, { velocity: { x: 3 }, collider: 1 })).toEqual({ x: 0, y: 0, z: 0, torque: 0 });
  });
});

describe('lift and the Magnus force', () => {
  test('both are perpendicular to the motion, do no work, and agree in 2D and 3D', () => {
    const body = { velocity: { x: 3, y: 4 }, lift: 0.5, collider: 2, angularVelocity: { z: 7 } };
    for (const law of [lift(), magnus({ density: 1.2 })]) {
      const force = lawOn(law, body);
      expect(force.x * 3 + force.y * 4).toBeCloseTo(0, 12);
      expect(lawOn(law, body, { dimensions: 3 })).toEqual(force);
    }
    expect(lawOn(lift(), body)).toMatchObject({ x: -0.5 * 5 * 4, y: 0.5 * 5 * 3 });
    const size = Math.PI * 1.2 * 8 * 7 * 5;
    expect(Math.hypot(lawOn(magnus({ density: 1.2 }), body).x, lawOn(magnus({ density: 1.2 }), body).y)).toBeCloseTo(
      size,
      10,
    );
  });

  test('a rolled wing lifts sideways', () => {
    const half = Math.SQRT1_2;
    const body = { velocity: { x: 10 }, lift: 0.1, orientation: { x: half, w: half } };
    const force = lawOn(lift({ frame: 'body' }), body, { dimensions: 3 });
    expect(force.y).toBeCloseTo(0, 12);
    expect(force.z).toBeCloseTo(10, 12);
    const along = lawOn(lift({ span: { x: 1 } }), body, { dimensions: 3 });
    expect(Math.hypot(along.x, along.y, along.z)).toBe(0);
  });

  test('a ball with topspin is pushed down', () => {
    const body = { velocity: { x: 10 }, collider: 0.03, angularVelocity: { z: -100 } };
    expect(lawOn(magnus({ density: 1.2 }), body).y).toBeLessThan(0);
  });
});

describe('buoyancy', () => {
  const pool = { density: 1000, gravity: { y: -10 }, level: 2 };

  test('is proportional to the immersed volume: zero above, half at the surface, full below', () => {
    const at = (y: number, shape: 0 | 1) =>
      lawOn(buoyancy(pool), { position: { y }, hull: { volume: 3, halfHeight: 0.5, shape } }).y / 3e4;
    for (const shape of [0, 1] as const) {
      expect(at(2.5, shape)).toBe(0);
      expect(at(9, shape)).toBe(0);
      expect(at(2, shape)).toBe(0.5);
      expect(at(1.5, shape)).toBe(1);
      expect(at(-9, shape)).toBe(1);
    }
    // The immersed cap of height h = R/2 has the fraction h²(3R - h)/4R³ = 5/32.
    expect(at(2.25, 0)).toBeCloseTo(5 / 32, 15);
    expect(at(2.25, 1)).toBeCloseTo(1 / 4, 15);
  });

  test('the force is minus the gradient of the energy, and an undamped bob conserves it', () => {
    for (const shape of [0, 1]) {
      for (const y of [2.6, 2.3, 1.9, 1.2]) {
        const body = { position: { y }, hull: { volume: 3, shape }, collider: 0.5 };
        const { world, eid } = single([buoyancy(pool)], body);
        expect(forceOn(world, eid).y).toBeCloseTo(slope(world, eid).y, 4);
      }
    }
    const body = { position: { y: 3 }, mass: 1500, hull: 3, collider: 0.5 };
    const { world } = single([uniformGravity({ y: -10 }), buoyancy(pool)], body, { integrator: rungeKutta4 });
    const before = energy(world).total;
    run(world, 20, 1e-3);
    expect(energy(world).total / before).toBeCloseTo(1, 7);
  });

  test('up is opposite to gravity in any direction', () => {
    const sideways = { density: 1, gravity: { x: 3, y: 4 }, level: 100 };
    const force = lawOn(buoyancy(sideways), { position: {}, hull: 2, collider: 1 });
    expect(force.x).toBeCloseTo(-6, 12);
    expect(force.y).toBeCloseTo(-8, 12);
  });

  test('drag acts on the immersed fraction only, relative to the flow', () => {
    const law = immersedDrag({ ...pool, flow: { x: 1 } });
    const body = { velocity: { x: 4 }, hull: { volume: 1, halfHeight: 1 }, quadraticDrag: 2, linearDrag: 5 };
    expect(lawOn(law, { ...body, position: { y: 9 } }).x).toBeCloseTo(0, 15);
    expect(lawOn(law, { ...body, position: { y: 2 } }).x).toBe(-0.5 * (2 * 3 + 5) * 3);
    expect(lawOn(law, { ...body, position: { y: 0 } }).x).toBe(-(2 * 3 + 5) * 3);
  });

  test('what sleeps on the water rises with it where the forces of the fluid are replaced', () => {
    const forces = [uniformGravity({ y: -10 }), buoyancy(pool), immersedDrag(pool)];
    const world = createPhysicsWorld({ preset: rigidBodies, forces });
    const collider = { shape: box(1, 1), density: 300 };
    const crate = spawn(world, { position: { y: 2.2 }, collider, hull: { shape: 1 }, linearDrag: 1000 });
    const { y } = world.components.Position;
    for (let i = 0; i < 600; i++) step(world, 1 / 60);
    expect(isAsleep(world, crate)).toBe(true);
    const risen = { ...pool, level: 3 };
    replaceForce(world, buoyancy(risen));
    replaceForce(world, immersedDrag(risen));
    step(world, 1 / 60);
    expect(isAsleep(world, crate)).toBe(false);
    for (let i = 0; i < 600; i++) step(world, 1 / 60);
    // 0.3 of its height are under water, and it fell asleep where it crept by less than 5 mm.
    expect(Math.abs(y[crate] - 3.2)).toBeLessThan(0.005);
  });

  test('an empty bubble accelerates at 2 g at most with added mass, and at 999 g without', () => {
    const deep = { density: 1000, gravity: { y: -10 } };
    const bubble = { mass: 1e-3, hull: 1e-3 };
    const forces = [uniformGravity({ y: -10 }), buoyancy(deep)];
    const without = single(forces, bubble);
    expect(forceOn(without.world, without.eid).y / 1e-3).toBeCloseTo(9990, 9);
    const light = single([...forces, addedMass(deep)], bubble);
    expect(forceOn(light.world, light.eid).y / 1e-3).toBeCloseTo(9.99 / 0.501, 9);
  });
});

test('a balloon has the potential energy of the displaced air, and a hull without mass has none', () => {
  const air = buoyancy({ density: 1.2, gravity: { y: -10 } });
  const { world } = single([air], { position: { x: 5, y: 7 }, mass: 0.1, hull: 2 });
  expect(energy(world).potential).toBeCloseTo(-1.2 * 10 * 2 * 7, 12);
  world.components.Mass.value[1] = 0;
  expect(energy(world).potential).toBeCloseTo(0, 12);
});

describe('buoyancy on a polygon', () => {
  const pool = { density: 1000, gravity: { y: -10 }, level: 0 };
  const outline = [
    { x: -1, y: -0.5 },
    { x: 1, y: -0.5 },
    { x: 1, y: 0.5 },
    { x: -1, y: 0.5 },
  ];
  const hull = { shape: 2, vertices: outline };

  test('an upright rectangle equals an upright box, in either orientation of its vertices', () => {
    for (const vertices of [outline, [...outline].reverse()]) {
      for (const y of [-0.6, -0.2, 0, 0.4, 0.5, 0.7]) {
        const body = { position: { y }, hull: { volume: 2, shape: 2 } };
        const boxed = { position: { y }, hull: { volume: 2, halfHeight: 0.5, shape: 1 } };
        const force = lawOn(polygonBuoyancy(pool, { shape: 2, vertices }), body);
        expect(force.y).toBeCloseTo(lawOn(buoyancy(pool), boxed).y, 9);
        expect(force.torque).toBeCloseTo(0, 9);
      }
    }
  });

  test('a wide hull rights itself with the metacentric height I/V - BG at small angles', () => {
    // At half immersion the displaced area is 1, the second moment of the waterline 2³/12, and the centre of buoyancy
    // 0.25 below the centre.
    const metacentre = 8 / 12 / 1 - 0.25;
    const angle = 1e-4;
    const force = lawOn(polygonBuoyancy(pool, hull), { rotation: angle, hull: { volume: 2, shape: 2 } });
    expect(force.y).toBeCloseTo(1e4, 6);
    expect(force.torque / (-1e4 * metacentre * angle)).toBeCloseTo(1, 5);
  });

  test('force and torque are minus the gradient of the energy', () => {
    const body = { position: { y: 0.1 }, rotation: 0.7, hull: { volume: 2, shape: 2 } };
    const { world, eid } = single([polygonBuoyancy(pool, hull)], body);
    const force = forceOn(world, eid);
    expect(force.y).toBeCloseTo(slope(world, eid).y, 3);
    const { angle } = world.components.Rotation;
    const at = (turned: number) => {
      angle[eid] = 0.7 + turned;
      return energy(world).potential;
    };
    expect(force.torque).toBeCloseTo(-(at(1e-5) - at(-1e-5)) / 2e-5, 3);
  });

  test('a damped hull rights itself, and other shape numbers are independent', () => {
    const forces = [uniformGravity({ y: -10 }), polygonBuoyancy(pool, hull), immersedDrag(pool), angularDrag()];
    const body = {
      mass: 1000,
      inertia: 400,
      rotation: 0.5,
      angularVelocity: {},
      hull: { volume: 2, shape: 2 },
      linearDrag: 1000,
      angularDrag: 1000,
    };
    const { world, eid, at } = single(forces, body);
    run(world, 60, 1 / 120);
    expect(world.components.Rotation.angle[eid]).toBeCloseTo(0, 3);
    expect(at().y).toBeCloseTo(0, 3);
    expect(lawOn(polygonBuoyancy(pool, hull), { hull: { volume: 2, shape: 3 } }).y).toBe(0);
  });

  test('a concave polygon counts only its immersed part', () => {
    // The polygon has two legs, joined at the top; the notch between them displaces no fluid.
    const bridge = [
      [-2, -1],
      [-1, -1],
      [-1, 0],
      [1, 0],
      [1, -1],
      [2, -1],
      [2, 1],
      [-2, 1],
    ].map(([x, y]) => ({ x, y }));
    const force = lawOn(polygonBuoyancy(pool, { shape: 2, vertices: bridge }), {
      position: { y: 0.5 },
      hull: { volume: 6, shape: 2 },
    });
    expect(force.y).toBeCloseTo(1000 * 10 * 2 * 0.5, 8);
  });

  test('without a surface the whole hull displaces fluid, and an off-centre hull rotates the body', () => {
    const { level: _, ...everywhere } = pool;
    // The centroid of this polygon is (1, 0).
    const aside = outline.map(({ x, y }) => ({ x: x + 1, y }));
    const body = { position: { y: 3 }, rotation: 0.7, hull: { volume: 2, shape: 2 } };
    const force = lawOn(polygonBuoyancy(everywhere, { shape: 2, vertices: aside }), body);
    expect(force.y).toBeCloseTo(2e4, 9);
    expect(force.torque).toBeCloseTo(2e4 * Math.cos(0.7), 8);
    // A hull far below a surface gives the same to the last digits.
    const deep = lawOn(polygonBuoyancy(pool, { shape: 2, vertices: aside }), { ...body, position: { y: -1e6 } });
    expect(deep.y).toBeCloseTo(force.y, 9);
    expect(deep.torque).toBeCloseTo(force.torque, 8);
    const { world, eid } = single([polygonBuoyancy(everywhere, { shape: 2, vertices: aside })], body);
    expect(forceOn(world, eid).y).toBeCloseTo(slope(world, eid).y, 3);
  });

  test('takes the shape of a body, with its centroid at the centre of mass', () => {
    const triangle = polygon([{ x: 0 }, { x: 3 }, { y: 3 }]);
    const body = { position: { x: 2, y: 0.3 }, rotation: 0.4, hull: { volume: 4.5, shape: 2 } };
    const about = [0, 3, 0].map((x, i) => ({ x: x - 1, y: [0, 0, 3][i] - 1 }));
    const force = lawOn(polygonBuoyancy(pool, { shape: 2, vertices: triangle }), body);
    const ofCorners = lawOn(polygonBuoyancy(pool, { shape: 2, vertices: about }), body);
    expect(force.torque).not.toBe(0);
    for (const component of ['y', 'torque'] as const)
      expect(force[component] / ofCorners[component]).toBeCloseTo(1, 12);
    // Wholly immersed it does not turn: 4.5·10⁴ N act at the centre, to rounding.
    const deep = lawOn(polygonBuoyancy(pool, { shape: 2, vertices: triangle }), { ...body, position: { y: -9 } });
    expect(Math.abs(deep.torque)).toBeLessThan(4.5e4 * 3 * 1e-14);
    const rounded = box(1, 1, { rounding: 0.1 });
    for (const vertices of [rounded, circle(1)]) {
      expect(() => polygonBuoyancy(pool, { shape: 2, vertices })).toThrow(/without rounding|round parts/);
    }
  });

  test('is refused in 3D', () => {
    const make = () => createPhysicsWorld({ dimensions: 3, forces: [polygonBuoyancy(pool, hull)] });
    expect(make).toThrow(/law "polygon buoyancy" requires 2 dimensions/);
  });

  test('refuses polygons without area', () => {
    expect(() => polygonBuoyancy(pool, { shape: 2, vertices: outline.slice(0, 2) })).toThrow(PhysicsError);
    expect(() => polygonBuoyancy(pool, { shape: 1, vertices: outline })).toThrow(PhysicsError);
    expect(() => buoyancy({ density: 0 })).toThrow(PhysicsError);
    expect(() => buoyancy({ density: 1, gravity: {} })).toThrow(/no direction/);
  });
});
