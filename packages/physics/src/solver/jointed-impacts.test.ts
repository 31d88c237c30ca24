// Impacts at bodies that joints hold: what is struck answers with all that hangs on it.
import {
  box,
  circle,
  createJoint,
  energy,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  prismatic,
  revolute,
  softStep,
  spawn,
  step,
  weld,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, disc, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

function floor(world: PhysicsWorld): void {
  spawn(world, { position: { y: -1 }, collider: { shape: box(100, 2), restitution: 1, friction: 0 } });
}

/** Steps until a body flies upwards, and returns its speed then, and that of its fall at the start of that step. */
function bounce(world: PhysicsWorld, body: number): { fall: number; rise: number } {
  const { y } = world.components.Velocity;
  let fall = 0;
  for (; (y[body] as number) <= 0; step(world, DT)) fall = -(y[body] as number);
  return { fall, rise: y[body] as number };
}

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const weightless = (options: PhysicsWorldOptions = {}) => rigidWorld({ precision, forces: [], ...options });
  /** Speeds are solved to a thousandth of the threshold of 1 m/s, and joints give way by 1e-4 of that of an impact. */
  const digits = 2;

  it.each([1, 100])('a disc of 1 kg that falls with %i kg welded upon it bounces with it', (mass) => {
    const world = rigidWorld({ precision });
    floor(world);
    const below = disc(world, { y: 5.5 });
    const above = disc(world, { y: 6.5, mass });
    createJoint(world, weld({ a: below, b: above, anchor: { x: 0, y: 6 } }));
    const { fall, rise } = bounce(world, below);
    // The impact is somewhere in a step, whose gravity is g Δt.
    expect(Math.abs(rise - fall)).toBeLessThan(G * DT);
    expect(Math.abs((world.components.Velocity.y[above] as number) - rise)).toBeLessThan(0.01 * rise);
  });

  it('a ball that hits the end of a welded pair leaves with what the momenta say', () => {
    const world = weightless();
    const [a, b] = [disc(world, {}), disc(world, { y: 1 })];
    createJoint(world, weld({ a, b, anchor: { x: 0, y: 0.5 } }));
    const hitting = disc(world, { x: -3, vx: 5 });
    run(world, 0.6);
    // Mass 2, and moment of inertia 2 (r²/2 + l²) about the middle, l = r = 0.5 m from the line of the impact.
    const inertia = 2 * (0.5 ** 2 / 2 + 0.5 ** 2);
    const impulse = (2 * 5) / (1 + 1 / 2 + 0.25 / inertia);
    const { x } = world.components.Velocity;
    expect(x[hitting]).toBeCloseTo(5 - impulse, digits);
    expect(((x[a] as number) + (x[b] as number)) / 2).toBeCloseTo(impulse / 2, digits);
    expect(world.components.AngularVelocity.z[a]).toBeCloseTo((0.5 * impulse) / inertia, digits);
    expect(energy(world).kinetic).toBeCloseTo(12.5, 2);
  });

  it('a disc with an arm hinged at its middle has the ninth part of the arm across it, and all of it along it', () => {
    // Across: m I/(I + m l²) with I = m r²/2 and l = 1 m. A ball of the same mass as what it hits stops dead.
    for (const [along, mass] of [
      [false, 1 + 1 / 9],
      [true, 2],
    ] as const) {
      const world = weightless();
      const struck = disc(world, {});
      const arm = disc(world, along ? { x: 1 } : { y: 1 });
      createJoint(world, revolute({ a: struck, b: arm, anchor: { x: 0, y: 0 } }));
      const hitting = disc(world, { x: -3, vx: 5, mass });
      const { x } = world.components.Velocity;
      for (let i = 0; i < 60 && x[struck] === 0; i++) step(world, DT);
      expect(Math.abs(x[hitting] as number)).toBeLessThan(10 ** -digits);
      // What is left of the step turns the arm by 5 m/s Δt, which bends its way by 5 Δt/2 at most.
      expect(Math.abs((x[struck] as number) - 5)).toBeLessThan(along ? 10 ** -digits : 5 * DT);
    }
  });

  it('a row that is welded passes an impact on to the ball at its end', () => {
    const world = weightless();
    const row = [0, 1, 2].map((i) => disc(world, { x: i }));
    for (const i of [1, 2]) {
      createJoint(world, weld({ a: row[i - 1] as number, b: row[i] as number, anchor: { x: i - 0.5, y: 0 } }));
    }
    const [last, hitting] = [disc(world, { x: 3, mass: 3 }), disc(world, { x: -3, vx: 5, mass: 3 })];
    run(world, 1);
    const { x } = world.components.Velocity;
    expect(x[last]).toBeCloseTo(5, digits);
    for (const id of [...row, hitting]) expect(Math.abs(x[id] as number)).toBeLessThan(10 ** -digits);
  });

  it('the two ends of a rod that lands flat are alike', () => {
    const world = rigidWorld({ precision });
    floor(world);
    const row = [-2, -1, 0, 1, 2].map((x) => disc(world, { x, y: 3.5 }));
    row.slice(1).forEach((b, i) => {
      createJoint(world, weld({ a: row[i] as number, b, anchor: { x: i - 1.5, y: 3.5 } }));
    });
    const { fall, rise } = bounce(world, row[0] as number);
    const { y } = world.components.Velocity;
    expect(Math.abs(rise - fall)).toBeLessThan(G * DT);
    for (const id of row) expect(Math.abs((y[id] as number) - rise)).toBeLessThan(0.01 * rise);
    expect(Math.abs(world.components.AngularVelocity.z[row[2] as number] as number)).toBeLessThan(0.02);
  });

  const kinds = {
    hinges: (a: number, b: number, anchor: { x: number; y: number }) => revolute({ a, b, anchor }),
    'hinges with limits': (a: number, b: number, anchor: { x: number; y: number }) =>
      revolute({ a, b, anchor, limits: { lower: -0.5, upper: 0.5 } }),
    'sliders with limits': (a: number, b: number, anchor: { x: number; y: number }) =>
      prismatic({ a, b, anchor, axis: { x: 1, y: 0 }, limits: { lower: -0.3, upper: 0.3 } }),
    welds: (a: number, b: number, anchor: { x: number; y: number }) => weld({ a, b, anchor }),
  };

  const mixes: readonly (readonly number[])[] = [
    [1, 5, 0.3],
    [1, 30, 0.03],
  ];
  const cases = Object.entries(kinds).flatMap(([kind, joint]) => mixes.map((masses) => ({ kind, masses, joint })));

  it.each(cases)(
    'chains of $kind, of bodies of $masses kg, that bounce about a room gain no energy',
    ({ masses, joint }) => {
      const world = rigidWorld({ precision, integrator: softStep({ sleepTime: 0 }) });
      floor(world);
      for (const x of [-9, 9]) {
        spawn(world, { position: { x, y: 10 }, collider: { shape: box(2, 24), restitution: 1, friction: 0 } });
      }
      for (let chain = 0; chain < 6; chain++) {
        let before = 0;
        for (let i = 0; i < 6; i++) {
          const position = { x: i - 3 + 0.2 * chain, y: 2 + 1.4 * chain + 0.1 * i };
          const body = spawn(world, {
            position,
            velocity: { x: 3 * Math.sin(7 * chain + i), y: -4 },
            mass: masses[(i + chain) % 3] as number,
            collider: { shape: i % 2 === 0 ? box(0.8, 0.4) : circle(0.35), restitution: 0.9, friction: 0.3 },
          });
          if (i > 0) createJoint(world, joint(before, body, { x: position.x - 0.5, y: position.y }));
          before = body;
        }
      }
      let before = energy(world).total;
      const start = before;
      for (let i = 0; i < 600; i++) {
        step(world, DT);
        const { total } = energy(world);
        // Overlap that is pushed out lifts what lies on it.
        expect(total - before).toBeLessThan(0.01 * start);
        before = total;
      }
    },
  );
});
