import { addComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { forceOn, run, single } from '../../../../test/support/laws.ts';
import {
  columnsOf,
  createPhysicsWorld,
  defineComponent,
  evaluateForces,
  PhysicsError,
  piecewiseLinear,
  realField,
  spawn,
  step,
  uniformGravity,
  type WingOptions,
  wing,
} from '../index.ts';

/** Thin-airfoil lift up to a stall at 15°, and a drag that grows with the square of the angle. */
const DEGREE = Math.PI / 180;
const LIFT: WingOptions['lift'] = [
  [-15 * DEGREE, -1.5],
  [15 * DEGREE, 1.5],
  [25 * DEGREE, 0.8],
];
const DRAG: WingOptions['drag'] = [
  [-15 * DEGREE, 0.1],
  [0, 0.02],
  [15 * DEGREE, 0.1],
  [90 * DEGREE, 1.8],
];
const WING = { area: 16, density: 1.2, lift: LIFT, drag: DRAG };
/** Lift coefficient per radian. */
const SLOPE = 1.5 / (15 * DEGREE);

describe('the force', () => {
  test.each([2, 3] as const)('is ½ ρ A v² C_L across the flow and C_D along it, in %dD', (dimensions) => {
    const { world, eid } = single([wing(WING)], { velocity: { x: 40, y: -40 * Math.tan(6 * DEGREE) } }, { dimensions });
    const { x, y } = forceOn(world, eid);
    // The flow comes from 6° below: lift leans forwards, drag backwards.
    const pressure = (0.5 * 1.2 * 16 * 40 ** 2) / Math.cos(6 * DEGREE) ** 2;
    const [lift, drag] = [0.6 * pressure, (0.02 + 0.08 * 0.4) * pressure];
    expect(x).toBeCloseTo(lift * Math.sin(6 * DEGREE) - drag * Math.cos(6 * DEGREE), 8);
    expect(y).toBeCloseTo(lift * Math.cos(6 * DEGREE) + drag * Math.sin(6 * DEGREE), 8);
  });

  test('falls behind the stall, where the drag grows', () => {
    const at = (degrees: number) => {
      const incidence = degrees * DEGREE;
      const { world, eid } = single([wing({ ...WING, incidence })], { velocity: { x: 40 } }, { dimensions: 3 });
      return forceOn(world, eid);
    };
    expect(at(25).y / at(15).y).toBeCloseTo(0.8 / 1.5, 12);
    expect(at(25).x / at(15).x).toBeCloseTo((0.1 + (1.7 * 10) / 75) / 0.1, 10);
    expect(at(60).y).toBeCloseTo(at(25).y, 8);
  });

  test('of air that moves with the body is zero, and a velocity along the span makes none', () => {
    const wind = { x: 30, y: 2, z: -4 };
    const carried = single([wing({ ...WING, wind })], { velocity: wind }, { dimensions: 3 });
    expect(forceOn(carried.world, carried.eid)).toEqual({ x: 0, y: 0, z: 0, torque: 0 });
    const sideways = single([wing(WING)], { velocity: { z: 50 } }, { dimensions: 3 });
    expect(forceOn(sideways.world, sideways.eid)).toEqual({ x: 0, y: 0, z: 0, torque: 0 });
  });

  test('turns with the body: upside down it pushes down', () => {
    const orientation = { x: 1, w: 0 };
    const { world, eid } = single(
      [wing({ ...WING, incidence: 0.1 })],
      { velocity: { x: 40 }, orientation },
      { dimensions: 3 },
    );
    expect(forceOn(world, eid).y).toBeCloseTo(-0.5 * 1.2 * 16 * 1600 * SLOPE * 0.1, 8);
  });
});

/** Creates a body that rotates, under the forces. */
function aircraft(forces: Parameters<typeof single>[0], body: Parameters<typeof single>[1] = {}) {
  const inertiaTensor = { x: 1000, y: 2500, z: 1800 };
  const rest = { mass: 1000, orientation: {}, angularVelocity: {}, inertiaTensor };
  return single(forces, { ...rest, ...body }, { dimensions: 3 });
}

describe('the torque', () => {
  test('of a wing that is not at the centre of mass is r × F', () => {
    const position = { x: -5, y: 1, z: 2 };
    const { world, eid } = aircraft([wing({ ...WING, position, incidence: 0.1 })], { velocity: { x: 40 } });
    const force = forceOn(world, eid);
    expect(force.torque).toBeCloseTo(-5 * force.y - 1 * force.x, 8);
    evaluateForces(world, world.ranges, 0);
    expect(world.scratch.torque.x[eid]).toBeCloseTo(1 * force.z - 2 * force.y, 8);
  });

  test('of two wings damps rolling: -ρ A v C_Lα p y² for small angles', () => {
    const [p, z] = [0.05, 3];
    const drag: WingOptions['drag'] = [
      [-1, 0],
      [1, 0],
    ];
    const wings = [-z, z].map((at) => wing({ ...WING, drag, position: { z: at } }));
    const { world, eid } = aircraft(wings, { velocity: { x: 40 }, angularVelocity: { x: p } });
    forceOn(world, eid);
    // The local angle is p z/v = 0.00375; its cube is left out, 1e-5 of it.
    const expected = -1.2 * 16 * 40 * SLOPE * p * z * z;
    expect(world.scratch.torque.x[eid] / expected).toBeCloseTo(1, 4);
  });

  test('of a control surface is proportional to its effectiveness and deflection', () => {
    const Elevator = defineComponent({ fields: { angle: realField('rad'), trim: realField('rad') } });
    const deflection = { component: Elevator, field: 'angle', effectiveness: 0.5 };
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 4,
      components: [Elevator],
      forces: [wing({ ...WING, position: { x: -5 }, deflection })],
    });
    const body = { position: {}, velocity: { x: 40 }, mass: 1000, orientation: {}, angularVelocity: {} };
    const eid = spawn(world, { ...body, inertiaTensor: { x: 1000, y: 2500, z: 1800 } });
    addComponent(world, eid, set(columnsOf(world, Elevator), { angle: 0.1 }));
    expect(forceOn(world, eid).torque).toBeCloseTo(-5 * 0.5 * 1.2 * 16 * 1600 * SLOPE * 0.05, 6);
  });
});

describe('flight', () => {
  test('glides without engine at the slope C_D/C_L, with the speed that carries the weight', () => {
    // Without rotation the body stays level, so the angle of attack is incidence plus glide angle.
    const incidence = 3 * DEGREE;
    const glider = single([uniformGravity(), wing({ ...WING, incidence })], { mass: 600, velocity: { x: 28 } });
    run(glider.world, 300, 1 / 60);
    const { x, y } = glider.going();
    const slope = Math.atan2(-y, x);
    const alpha = incidence + slope;
    const [lift, drag] = [SLOPE * alpha, 0.02 + (0.08 * alpha) / (15 * DEGREE)];
    expect(Math.tan(slope)).toBeCloseTo(drag / lift, 6);
    const weight = 600 * 9.80665;
    expect(glider.speed()).toBeCloseTo(Math.sqrt((2 * weight) / (1.2 * 16 * Math.hypot(lift, drag))), 6);
  });

  test('a tail behind the centre of mass brings the nose back into the flow', () => {
    const tail = wing({ ...WING, area: 3, position: { x: -5 } });
    const { world, eid } = aircraft([tail], { velocity: { x: 40 }, angularVelocity: { z: 0.05 } });
    const { Orientation: q, Velocity: v } = world.components;
    // Angle of attack: attitude less path.
    const attack = () => 2 * Math.atan2(q.z[eid], q.w[eid]) - Math.atan2(v.y[eid], v.x[eid]);
    let first = 0;
    let largest = 0;
    for (let t = 0; t < 4; t += 1 / 120) {
      const before = attack();
      step(world, 1 / 120);
      if (first === 0 && before > 0 && attack() <= 0) first = t;
      if (first > 0 && t > first + 0.1) largest = Math.max(largest, Math.abs(attack()));
    }
    // Half the period of θ'' = -½ ρ A v² C_Lα l/I θ - ½ ρ A v C_Lα l²/I θ', to 10 %, since the path bends a little.
    const stiffness = (0.5 * 1.2 * 3 * 1600 * SLOPE * 5) / 1800;
    const damping = (0.5 * 1.2 * 3 * 40 * SLOPE * 25) / 1800;
    const rate = Math.sqrt(stiffness - damping ** 2 / 4);
    expect(first / (Math.PI / rate)).toBeGreaterThan(0.9);
    expect(first / (Math.PI / rate)).toBeLessThan(1.1);
    expect(largest).toBeLessThan(0.01);
  });
});

describe('bad input', () => {
  test('is named', () => {
    const bad = (options: object) => () => wing({ ...WING, ...options } as WingOptions);
    expect(bad({ area: -1 })).toThrow(/wing.area/);
    expect(bad({ lift: [[0, 1]] })).toThrow(/2 to 64/);
    expect(
      bad({
        lift: [
          [0, 1],
          [0, 2],
        ],
      }),
    ).toThrow(/ascending/);
    expect(
      bad({
        drag: [
          [0, Number.NaN],
          [1, 2],
        ],
      }),
    ).toThrow(/wing.drag\[0\]\[1\]/);
    expect(bad({ span: { z: 0 } })).toThrow(PhysicsError);
    expect(bad({ forward: { z: 2 } })).toThrow(/across the span/);
    expect(bad({ deflection: { component: {}, field: 'x' } })).toThrow(/component/);
    expect(bad({ deflection: { component: defineComponent({ fields: { a: realField('') } }), field: 'b' } })).toThrow(
      /no field/,
    );
    expect(() => piecewiseLinear(1, [])).toThrow(/2 to 64/);
  });
});
