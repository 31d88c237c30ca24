import { observe, onAdd } from 'bitecs';
import { describe, expect, test } from 'vitest';
import { warnedWorld } from '../../../../test/support/warned-world.ts';
import { spawn } from '../bodies/spawn.ts';
import { angularMomentum, energy, momentum } from '../diagnostics/energy.ts';
import { stateHash } from '../diagnostics/hash.ts';
import { linearDrag } from '../forces/drag.ts';
import { springs } from '../forces/springs.ts';
import { uniformGravity } from '../forces/uniform-gravity.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { createPhysicsWorld, type PhysicsWorldOptions } from '../world/create-world.ts';
import { step } from '../world/step.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { maxStrain } from '../xpbd/stretch.ts';
import { xpbd } from '../xpbd/xpbd.ts';
import { createCloth } from './cloth.ts';
import { clothWind } from './cloth-wind.ts';
import { movePin, pin, unpin } from './pins.ts';
import { createRope } from './rope.ts';
import { createSoftBody } from './soft-body.ts';

const DRAGGED = { linearDrag: 1 };

function network(options: PhysicsWorldOptions = {}): PhysicsWorld {
  const forces = [uniformGravity({ y: -10 }), linearDrag(), springs()];
  return createPhysicsWorld({ capacity: 2000, integrator: xpbd(), forces, ...options });
}

function run(world: PhysicsWorld, steps: number, dt = 1 / 60): void {
  for (let s = 0; s < steps; s++) step(world, dt);
}

/**
 * Returns the sag of a catenary between two pins of equal height: 2 a sinh(gap/2a) = length, sag a (cosh(gap/2a) -
 * 1).
 */
function catenarySag(length: number, gap: number): number {
  let [low, high] = [gap / 16, 10 * gap];
  for (let i = 0; i < 60; i++) {
    const a = (low + high) / 2;
    if (2 * a * Math.sinh(gap / 2 / a) > length) low = a;
    else high = a;
  }
  return low * (Math.cosh(gap / 2 / low) - 1);
}

/** The Bessel function J₀ by its series, exact to rounding for |x| < 10. */
function besselJ0(x: number): number {
  let [sum, term] = [1, 1];
  for (let k = 1; k < 40; k++) {
    term *= -(x * x) / 4 / (k * k);
    sum += term;
  }
  return sum;
}

describe('a rope', () => {
  test.each([2, 3] as const)('hangs as a catenary between two pins, in %iD', (dimensions) => {
    const world = network({ dimensions });
    const ends = { from: { x: -4 }, to: { x: 4 }, pins: 'both' } as const;
    const rope = createRope(world, { ...ends, length: 10, nodes: 61, mass: 1, components: { linearDrag: 0.05 } });
    run(world, 1200);
    expect(Math.abs(-world.components.Position.y[rope.nodes[30]] / catenarySag(10, 8) - 1)).toBeLessThan(2e-3);
    expect(maxStrain(world)).toBeLessThan(1e-9);
  });

  test('is not created inside a step, which names the functions that make networks', () => {
    const world = network();
    world.phases.finish.push(() => {
      expect(() => createRope(world, { from: {}, to: { x: 8 }, nodes: 3, mass: 1 })).toThrow(
        /E_REENTRANT: createRope, createCloth and createSoftBody cannot run inside a step\. Call it after the step/,
      );
    });
    step(world, 0.1);
    expect(world.lastId).toBe(0);
  });

  test.each([
    ['f32', false],
    ['f32', true],
    ['f64', false],
  ] as const)(
    'of a thousand links swings and settles unstretched, in %s, tension-only: %s',
    (precision, tensionOnly) => {
      const count = 1000;
      const world = network({ capacity: 4 * count, precision, integrator: xpbd({ substeps: 4 }) });
      const ends = { from: {}, to: { x: 8 }, length: 10, pins: 'both' } as const;
      const { nodes } = createRope(world, {
        ...ends,
        tensionOnly,
        nodes: count,
        mass: 1,
        components: { linearDrag: 2 / count },
      });
      // Rods start straight from the pins to the middle; tension-only links start slack.
      const { y } = world.components.Position;
      if (!tensionOnly) {
        nodes.forEach((node, i) => {
          y[node] = 3 * (Math.abs((2 * i) / (count - 1) - 1) - 1);
        });
      }
      for (let s = 0; s < 600; s++) {
        step(world, 1 / 60);
        // Coordinates up to 8 m are rounded to 4.8e-7 m in f32, and a link is 0.01 m long.
        expect(maxStrain(world)).toBeLessThan(precision === 'f32' ? 1e-4 : 1e-9);
      }
      expect(Math.abs(-y[nodes[500]] / catenarySag(10, 8) - 1)).toBeLessThan(0.01);
      expect(world.faults.faults).toEqual([]);
    },
  );

  test.each([
    [1, 2.404826],
    [2, 5.520078],
    [3, 8.653728],
  ])('hanging freely swings in Bessel modes: ω = j/2 √(g/L), mode %i', (_, zero) => {
    const [count, length] = [201, 2];
    const world = network({ integrator: xpbd({ substeps: 8 }), forces: [uniformGravity({ y: -10 }), springs()] });
    const { nodes } = createRope(world, { from: {}, to: { y: -length }, nodes: count, mass: 1 });
    const { x, y } = world.components.Position;
    // The mode shape is J₀(j √(s/L)), s the height above the free end (Daniel Bernoulli 1738).
    const mode = Array.from(nodes, (_node, i) => besselJ0(zero * Math.sqrt(1 - i / (count - 1))));
    const swing = 1e-3;
    for (let i = 1; i < count; i++) {
      x[nodes[i]] = swing * mode[i];
      const across = x[nodes[i]] - x[nodes[i - 1]];
      y[nodes[i]] = y[nodes[i - 1]] - Math.sqrt((length / (count - 1)) ** 2 - across * across);
    }
    const amplitude = () => nodes.reduce((sum, node, i) => sum + mode[i] * x[node], 0);
    let before = amplitude();
    for (;;) {
      step(world, 1 / 240);
      const now = amplitude();
      if (now <= 0) {
        const quarter = world.time - now / (now - before) / 240;
        // Two hundred links approximate a chain to 1/200 of its length; backward Euler lags by less, (ω h)²/3.
        expect(Math.abs(Math.PI / 2 / quarter / ((zero / 2) * Math.sqrt(10 / length)) - 1)).toBeLessThan(0.01);
        return;
      }
      before = now;
    }
  });

  test('of elastic springs stretches by the load below each link (ch13-rope)', () => {
    for (const integrator of [xpbd({ substeps: 4 }), velocityVerlet]) {
      const world = network({ integrator });
      const rope = createRope(world, {
        from: {},
        to: { y: -280 },
        nodes: 15,
        mass: 150,
        stiffness: 500,
        damping: 20,
        components: { linearDrag: 20 },
      });
      run(world, 3000, 1 / 30);
      const { y } = world.components.Position;
      for (let j = 1; j < 15; j++) {
        const stretch = y[rope.nodes[j - 1]] - y[rope.nodes[j]] - 20;
        expect(stretch).toBeCloseTo(0.2 * (15 - j), 3);
      }
    }
  });

  test('tethers keep the length of a thousand links within 1 %', () => {
    const world = network({ capacity: 14_000, precision: 'f32', integrator: xpbd({ substeps: 10, iterations: 1 }) });
    const rope = createRope(world, { from: {}, to: { y: -10 }, nodes: 1000, mass: 1, tethers: true });
    run(world, 120);
    expect(-world.components.Position.y[rope.nodes[999]]).toBeLessThan(10.1);
    expect(maxStrain(world)).toBeLessThan(0.01);
  });
});

test('a network beyond capacity or with invalid options creates nothing', () => {
  const world = network({ capacity: 15 });
  const size = { from: {}, to: { x: 1 }, nodes: 10, mass: 1 };
  expect(() => createRope(world, size)).toThrow(/E_CAPACITY/);
  expect(() => createRope(world, { ...size, nodes: 4, damping: -1 })).toThrow(/E_RANGE/);
  expect(() => createRope(world, { ...size, nodes: 1 })).toThrow(/E_RANGE/);
  expect(() => createRope(world, { ...size, lenght: 1 } as never)).toThrow(/E_UNKNOWN/);
  const body = { centre: {}, radius: 1, mass: 1, stiffness: 1, pressure: 1, detail: 3 };
  expect(() => createSoftBody(world, { ...body, ambient: Number.NaN })).toThrow(/E_NONFINITE: softBody.ambient/);
  expect(world.lastId).toBe(0);
  expect(createRope(world, { ...size, nodes: 4 }).springs).toHaveLength(3);
});

describe('a cloth', () => {
  test('carries its weight with its pins and stretches by the load below each row', () => {
    const world = network({ dimensions: 3, integrator: xpbd({ substeps: 4 }) });
    const stiffness = 2000;
    const size = { corner: {}, columns: 7, rows: 6, spacing: 0.1, mass: 4.2 };
    const cloth = createCloth(world, { ...size, structural: stiffness, damping: 0.5, components: DRAGGED });
    run(world, 1500);
    const { y } = world.components.Position;
    for (let row = 1; row < 6; row++) {
      let tension = 0;
      for (let column = 0; column < 7; column++) {
        tension += stiffness * (y[cloth.at(column, row - 1)] - y[cloth.at(column, row)] - 0.1);
      }
      // Seven nodes of 0.1 kg per row, at g = 10 m/s².
      expect(tension).toBeCloseTo(7 * (6 - row), 3);
    }
  });

  test.each(['f32', 'f64'] as const)('is inextensible in the limit, in %s', (precision) => {
    const stretch = (structural: number, substeps: number) => {
      const world = network({ dimensions: 3, precision, integrator: xpbd({ substeps }) });
      const size = { corner: {}, columns: 10, rows: 10, spacing: 0.1, mass: 1, shear: 100 };
      createCloth(world, { ...size, structural, components: DRAGGED });
      run(world, 300);
      return maxStrain(world, structural);
    };
    const [soft, stiff] = [stretch(100, 10), stretch(1e4, 10)];
    expect(soft).toBeGreaterThan(5 * stiff);
    expect(stretch(Infinity, 20)).toBeLessThan(0.01);
  });

  test('receives the analytic force of a steady wind', () => {
    const windSpeed = 5;
    const world = network({ dimensions: 3, forces: [uniformGravity({ y: -10 }), springs()] });
    const cloth = createCloth(world, { corner: {}, columns: 2, rows: 2, spacing: 1, mass: 1, pins: 'top' });
    world.forces.push(
      clothWind({ triangles: cloth.triangles, velocity: { z: windSpeed }, density: 1.2, tangential: 0 }),
    );
    step(world, 1e-6);
    let total = 0;
    for (const node of cloth.nodes) total += world.scratch.force.z[node];
    // The force is ρ A u² for c_n = 2, pinned nodes included.
    expect(total).toBeCloseTo(1.2 * windSpeed * windSpeed, 3);
  });

  test('refuses wind in 2D and incomplete triangles', () => {
    const world = network();
    world.forces.push(clothWind({ triangles: [] }));
    expect(() => step(world, 0.01)).toThrow(/E_RANGE.*needs a 3D world/);
    expect(() => clothWind({ triangles: [1, 2] })).toThrow(/E_RANGE/);
  });

  test('refuses places outside the grid', () => {
    const cloth = createCloth(network(), { corner: {}, columns: 4, rows: 3, spacing: 1, mass: 1 });
    expect(cloth.at(3, 2)).toBe(cloth.nodes[11]);
    for (const [column, row] of [
      [4, 0],
      [-1, 1],
      [0, 3],
      [0.5, 0],
    ]) {
      expect(() => cloth.at(column, row)).toThrow(/E_RANGE.*cloth\.at: (column|row)/);
    }
  });

  test('can be pinned, moved and unpinned', () => {
    const world = network({ dimensions: 3 });
    const size = { corner: {}, columns: 4, rows: 4, spacing: 0.1, mass: 1 };
    const cloth = createCloth(world, { ...size, pins: [[0, 0]] });
    const { Position } = world.components;
    const corner = cloth.at(3, 0);
    const mass = pin(world, corner);
    expect(mass).toBeCloseTo(1 / 16, 12);
    run(world, 20);
    expect(Position.x[corner]).toBeCloseTo(0.3, 12);
    expect(Position.y[corner]).toBe(0);
    for (let s = 1; s <= 10; s++) {
      movePin(world, corner, { x: 0.3, y: 0.01 * s }, 1 / 60);
      step(world, 1 / 60);
    }
    expect(Position.y[corner]).toBeCloseTo(0.1, 12);
    pin(world, corner);
    unpin(world, corner, mass);
    run(world, 30);
    expect(Position.y[corner]).toBeLessThan(0.05);
    expect(Position.y[cloth.at(0, 0)]).toBe(0);
  });
});

test('movePin warns of what is not pinned, once', () => {
  const { world, messages } = warnedWorld();
  const still = spawn(world, { position: {}, velocity: {}, mass: 1 });
  const lift = spawn(world, { position: {}, velocity: {}, mass: 1, kinematic: {} });
  const wall = spawn(world, { position: {}, velocity: {} });
  pin(world, still);
  for (const id of [still, lift, wall]) movePin(world, id, { x: 1 }, 0.1);
  expect(messages()).toBe('');
  unpin(world, still, 1);
  for (let i = 0; i < 3; i++) movePin(world, still, { x: 1 }, 0.1);
  expect(messages()).toBe(
    `movePin gave body ${still} a velocity, but it is not pinned: forces, springs and contacts change that velocity.`,
  );
});

describe('a soft body', () => {
  test.each([2, 3] as const)('oscillates about its equilibrium radius and conserves energy, in %iD', (dimensions) => {
    const world = createPhysicsWorld({ dimensions, capacity: 2000, forces: [springs()] });
    const options = { centre: { x: 3 }, radius: 1, mass: 1, stiffness: 200, pressure: 50 };
    const body = createSoftBody(world, { ...options, detail: dimensions === 2 ? 32 : 2 });
    const before = energy(world).total;
    run(world, 2000, 2e-4);
    // The limit is relative to pressure times volume.
    expect(Math.abs(energy(world).total - before)).toBeLessThan(2e-5 * 150);
    expect(Math.abs(momentum(world).x)).toBeLessThan(1e-12);
    expect(Math.abs(angularMomentum(world).z)).toBeLessThan(1e-12);
    // The body has moved, and all nodes by the same distance.
    const { x, y, z } = world.components.Position;
    const radii = Array.from(body.nodes, (node) => Math.hypot(x[node] - 3, y[node], z[node]));
    expect(Math.max(...radii)).not.toBeCloseTo(1, 3);
    if (dimensions === 2) expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(1e-9);
  });

  test('the force of the gas is the gradient of its potential', () => {
    const world = createPhysicsWorld({ dimensions: 3, capacity: 2000 });
    const options = { centre: {}, radius: 1, mass: 1, stiffness: 1, pressure: 50, ambient: 20, detail: 1 };
    const body = createSoftBody(world, options);
    const node = body.nodes[1];
    const { x } = world.components.Position;
    step(world, 1e-9);
    const force = world.scratch.force.x[node];
    const at = x[node];
    const potential = (shift: number) => {
      x[node] = at + shift;
      return body.gas.potential?.(world) ?? 0;
    };
    expect((potential(-1e-5) - potential(1e-5)) / 2e-5).toBeCloseTo(force, 5);
    expect(Math.abs(force)).toBeGreaterThan(0.1);
  });
});

describe('input of cloths and springs', () => {
  const sheet = { corner: {}, columns: 4, rows: 3, spacing: 0.1, mass: 1 };

  test('takes directions of any length, and refuses those of a cloth that would be strained', () => {
    const world = createPhysicsWorld({ integrator: xpbd() });
    const { nodes } = createCloth(world, { ...sheet, right: { x: 3, y: 4 }, down: { x: 4, y: -3 } });
    const { x, y } = world.components.Position;
    expect(Math.hypot(x[nodes[3]], y[nodes[3]])).toBeCloseTo(0.3, 14);
    expect(maxStrain(world)).toBeLessThan(1e-14);
    const before = stateHash(world);
    expect(() => createCloth(world, { ...sheet, right: {} })).toThrow('cloth.right has no direction');
    expect(() => createCloth(world, { ...sheet, right: { y: 1 } })).toThrow('must not be parallel');
    expect(stateHash(world)).toBe(before);
    createCloth(world, { ...sheet, right: { x: 1, y: -0.5 }, shear: 10, bend: 1 });
    expect(maxStrain(world)).toBeLessThan(1e-14);
  });

  test('counts the room for all of a cloth at once', () => {
    const world = createPhysicsWorld({ integrator: xpbd(), capacity: 30 });
    const braced = { ...sheet, shear: 10, bend: 1 };
    // 12 nodes, 17 structural springs, 12 diagonals and 10 over two spacings.
    expect(() => createCloth(world, braced)).toThrow('51');
    expect(createCloth(createPhysicsWorld({ integrator: xpbd(), capacity: 51 }), braced).springs.length).toBe(39);
  });

  test('makes a rod of Infinity in the column of stiffness, as of Infinity that is set', () => {
    const world = createPhysicsWorld({ integrator: xpbd(), forces: [uniformGravity(), springs()] });
    const { Spring, Position } = world.components;
    const [a, b] = [spawn(world, { position: {} }), spawn(world, { position: { y: -1 }, mass: 1 })];
    const spring = spawn(world, { spring: { a, b, length: 1, stiffness: 1000, tensionOnly: true } });
    Spring.stiffness[spring] = Infinity;
    for (let i = 0; i < 300; i++) step(world, 1 / 60);
    expect([Spring.stiffness[spring], Spring.tensionOnly[spring], world.faults.faults.length]).toEqual([1e30, 1, 0]);
    expect(Position.y[b]).toBeCloseTo(-1, 12);
  });
});

test('what fails half way leaves nothing behind', () => {
  const world = network();
  const blob = { centre: {}, radius: 1, mass: 1, stiffness: 1, pressure: 0 };
  // Springs as long as that are refused, as is more gas than there are numbers for, and a volume that rounds to 0.
  expect(() => createSoftBody(world, { ...blob, radius: 1e14 })).toThrow(/E_RANGE/);
  expect(() => createSoftBody(world, { ...blob, radius: 1e3, pressure: 1e30 })).toThrow(/E_RANGE/);
  expect(() => createSoftBody(world, { ...blob, radius: 1e-200 })).toThrow(/E_RANGE/);
  const ends = observe(world, onAdd(world.components.Spring), () => {
    throw new Error('no springs here');
  });
  expect(() => createRope(world, { from: {}, to: { x: 1 }, nodes: 5, mass: 1 })).toThrow('no springs here');
  ends();
  expect([world.lastId, world.internal.counts.Position, world.internal.counts.Spring]).toEqual([0, 0, 0]);
  expect(world.forces).toHaveLength(3);
});
