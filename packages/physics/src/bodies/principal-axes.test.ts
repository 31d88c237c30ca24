import { describe, expect, test } from 'vitest';
import {
  angularMomentum,
  boxInertia,
  createPhysicsWorld,
  createRandom,
  energy,
  type PrincipalAxes,
  principalAxes,
  spawn,
  step,
  type TensorInput,
  tensorOfParts,
} from '../index.ts';

type Axis = readonly [number, number, number];

/** The principal axes in the axes of the tensor: the columns of the rotation matrix of the quaternion. */
function axesOf({ orientation: { w, x, y, z } }: PrincipalAxes): [Axis, Axis, Axis] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** Σ Iₖ eₖ eₖᵀ over the principal axes. */
function rebuilt(result: PrincipalAxes): Required<TensorInput> {
  const axes = axesOf(result);
  const moments = [result.inertia.x, result.inertia.y, result.inertia.z];
  const element = (i: number, j: number) => axes.reduce((sum, axis, k) => sum + moments[k] * axis[i] * axis[j], 0);
  return {
    xx: element(0, 0),
    yy: element(1, 1),
    zz: element(2, 2),
    xy: element(0, 1),
    xz: element(0, 2),
    yz: element(1, 2),
  };
}

function largestDifference(a: Required<TensorInput>, b: Required<TensorInput>): number {
  return Math.max(...(['xx', 'yy', 'zz', 'xy', 'xz', 'yz'] as const).map((name) => Math.abs(a[name] - b[name])));
}

/** Point masses at random places: whatever they are, they make a body. */
function randomTensor(seed: number): Required<TensorInput> {
  const random = createRandom(seed);
  const place = () => ({ x: random.uniform(-2, 2), y: random.uniform(-1, 1), z: random.uniform(-0.3, 0.3) });
  return tensorOfParts(Array.from({ length: 6 }, () => ({ mass: random.uniform(0.1, 3), position: place() }))).tensor;
}

describe('principalAxes', () => {
  test('moments and axes give the tensor back, to rounding, whatever its scale', () => {
    for (let seed = 1; seed <= 200; seed++) {
      for (const scale of [1, 1e-30, 1e30]) {
        const { xx, yy, zz, xy, xz, yz } = randomTensor(seed);
        const given = {
          xx: scale * xx,
          yy: scale * yy,
          zz: scale * zz,
          xy: scale * xy,
          xz: scale * xz,
          yz: scale * yz,
        };
        const result = principalAxes(given);
        const { x, y, z } = result.inertia;
        // A dozen rotations, each of which rounds every element a few times.
        expect(largestDifference(rebuilt(result), given)).toBeLessThan(3e-15 * z);
        expect(x > 0 && x <= y && y <= z).toBe(true);
        expect(Math.hypot(...Object.values(result.orientation))).toBeCloseTo(1, 14);
      }
    }
  });

  test('a body that is given in its principal axes keeps them, and in another order gets them in ascending order', () => {
    const identity = { w: 1, x: 0, y: 0, z: 0 };
    expect(principalAxes({ xx: 1, yy: 2, zz: 2.5 })).toEqual({
      inertia: { x: 1, y: 2, z: 2.5 },
      orientation: identity,
    });
    expect(principalAxes({ xx: 2, yy: 2, zz: 2 })).toEqual({ inertia: { x: 2, y: 2, z: 2 }, orientation: identity });
    const turned = principalAxes({ xx: 2.5, yy: 1, zz: 2 });
    expect(turned.inertia).toEqual({ x: 1, y: 2, z: 2.5 });
    expect(axesOf(turned).flat()).toEqual([0, 1, 0, 0, 0, 1, 1, 0, 0]);
  });

  test('two equal masses askew: the tensor of a dumb-bell of thickness, its axis at 45°', () => {
    // Masses 1 at ±(1, 1, 0), each a ball of moment 0.4: 0.8 about their line, 0.8 + 2·2 across it.
    const part = (x: number) => ({ mass: 1, position: { x, y: x }, inertia: { x: 0.4, y: 0.4, z: 0.4 } });
    const { mass, centre, tensor } = tensorOfParts([part(1), part(-1)]);
    expect([mass, centre]).toEqual([2, { x: 0, y: 0, z: 0 }]);
    const result = principalAxes(tensor);
    expect(result.inertia.x).toBeCloseTo(0.8, 14);
    expect(result.inertia.y).toBeCloseTo(4.8, 14);
    expect(result.inertia.z).toBeCloseTo(4.8, 14);
    const [line] = axesOf(result);
    expect(line[0]).toBeCloseTo(Math.SQRT1_2, 14);
    expect(line[1]).toBeCloseTo(Math.SQRT1_2, 14);
  });

  test('without a torque the body keeps L and E, which are those of the tensor', () => {
    const given = randomTensor(4);
    const { inertia, orientation } = principalAxes(given);
    const world = createPhysicsWorld({ dimensions: 3, capacity: 2 });
    const spin = { x: 0.4, y: 2, z: -1.1 };
    spawn(world, { position: {}, mass: 1, orientation, inertiaTensor: inertia, angularVelocity: spin });
    const expected = {
      x: given.xx * spin.x + given.xy * spin.y + given.xz * spin.z,
      y: given.xy * spin.x + given.yy * spin.y + given.yz * spin.z,
      z: given.xz * spin.x + given.yz * spin.y + given.zz * spin.z,
    };
    const twiceEnergy = expected.x * spin.x + expected.y * spin.y + expected.z * spin.z;
    for (let i = 0; i <= 6000; i++) {
      if (i % 1000 === 0) {
        const momentum = angularMomentum(world);
        for (const axis of ['x', 'y', 'z'] as const) expect(momentum[axis]).toBeCloseTo(expected[axis], 9);
        expect(energy(world).kinetic).toBeCloseTo(twiceEnergy / 2, 9);
      }
      step(world, 1 / 100);
    }
  });

  test('refuses what belongs to no body, and says why', () => {
    const code = (name: string) => expect.objectContaining({ code: name });
    expect(() => principalAxes({ xx: 1, yy: 1, zz: 3 })).toThrow(/the largest exceeds the sum of the other two/);
    expect(() => principalAxes({ xx: 1, yy: 1, zz: 1, xy: 2 })).toThrow(/one is not positive/);
    expect(() => principalAxes({ xx: 1, yy: 1, zz: 1, xy: 2 })).toThrow(code('E_RANGE'));
    expect(() => principalAxes({ xx: 0, yy: 1, zz: 1 })).toThrow(code('E_RANGE'));
    expect(() => principalAxes({ xx: Number.NaN, yy: 1, zz: 1 })).toThrow(code('E_NONFINITE'));
    expect(() => principalAxes({ xx: 1, yy: 1, zz: 1, xz: Number.POSITIVE_INFINITY })).toThrow(code('E_NONFINITE'));
    expect(() => principalAxes({ xx: 1, yy: 1, zz: '1' } as never)).toThrow(code('E_TYPE'));
    expect(() => principalAxes({ xx: 1, yy: 1, zz: 1, yx: 0 } as never)).toThrow(code('E_UNKNOWN'));
    expect(() => principalAxes(undefined as never)).toThrow(code('E_TYPE'));
    // A flat body is a limit that exists: x + y = z.
    expect(principalAxes({ xx: 1, yy: 2, zz: 3 }).inertia.z).toBe(3);
  });
});

describe('tensorOfParts', () => {
  test('a box cut into eight has the moments of the whole, wherever it stands', () => {
    const size = { x: 2, y: 3, z: 5 };
    const corner = (i: number) => ({
      x: 7 + (i & 1 ? 0.5 : -0.5),
      y: -4 + (i & 2 ? 0.75 : -0.75),
      z: i & 4 ? 1.25 : -1.25,
    });
    const part = boxInertia(2, { x: 1, y: 1.5, z: 2.5 });
    const { mass, centre, tensor } = tensorOfParts(
      Array.from({ length: 8 }, (_, i) => ({ mass: 2, position: corner(i), inertia: part })),
    );
    expect([mass, centre]).toEqual([16, { x: 7, y: -4, z: 0 }]);
    const whole = boxInertia(16, size);
    expect([tensor.xx, tensor.yy, tensor.zz]).toEqual([whole.x, whole.y, whole.z].map((m) => expect.closeTo(m, 12)));
    for (const product of [tensor.xy, tensor.xz, tensor.yz]) expect(product).toBeCloseTo(0, 12);
  });

  test('refuses what is no part', () => {
    expect(() => tensorOfParts([])).toThrow(expect.objectContaining({ code: 'E_RANGE' }));
    expect(() => tensorOfParts(undefined as never)).toThrow(expect.objectContaining({ code: 'E_TYPE' }));
    expect(() => tensorOfParts([{ mass: -1 }])).toThrow(/parts\[0\]\.mass must be greater than 0/);
    expect(() => tensorOfParts([{ mass: 1, position: { x: Number.NaN } }])).toThrow(/parts\[0\]\.position\.x/);
  });
});
