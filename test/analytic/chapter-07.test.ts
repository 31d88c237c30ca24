// Contact and fluid forces. y points down where screens are meant.
import {
  buoyancy,
  energy,
  gaussRadau,
  gusts,
  lift,
  linearDrag,
  planeSupport,
  quadraticDrag,
  step,
  stringTension,
  uniformGravity,
  vortex,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import airplane from '../../packages/scenes/src/examples/ch07/airplane.ts';
import apparentWeight from '../../packages/scenes/src/examples/ch07/apparent-weight.ts';
import balloon from '../../packages/scenes/src/examples/ch07/balloon.ts';
import parachute from '../../packages/scenes/src/examples/ch07/parachute.ts';
import sliding from '../../packages/scenes/src/examples/ch07/sliding.ts';
import { forceOn, lawOn, run, single, started } from '../support/laws.ts';

test('ch07-normal-tension: a block on a slope, and a hanging mass', () => {
  const angle = 0.4;
  const normal = { x: Math.sin(angle), y: Math.cos(angle) };
  const block = single([uniformGravity({ y: -10 }), planeSupport({ normal })], { mass: 3 });
  const { x, y } = forceOn(block.world, block.eid);
  const reaction = Math.hypot(x, y + 30);
  expect(reaction).toBeCloseTo(30 * Math.cos(angle), 12);
  const hanging = single([uniformGravity({ y: -10 }), stringTension({ length: 2 })], { position: { y: -2 }, mass: 3 });
  expect(forceOn(hanging.world, hanging.eid).y).toBe(0);
});

describe('ch07-sliding', () => {
  // Down a slope of 100 in 400.
  const root = Math.sqrt(17);
  const slide = (still: number, moving: number) => {
    const block = started(sliding, { values: { still, moving } });
    return { ...block, foot: block.at() };
  };

  test('ch07-sliding: exactly at the threshold it stays at rest', () => {
    const { world, eid, at, speed, foot } = slide(0.25, 0.2);
    const { x, y } = forceOn(world, eid);
    expect(Math.hypot(x, y)).toBeLessThan(2e-15);
    run(world, 30);
    expect(speed()).toBeLessThan(1e-12);
    expect(at().x).toBeCloseTo(foot.x, 10);
  });

  test('ch07-sliding: beyond it, a = g (sinθ - μ cosθ), and 412.31 take 41.23 s', () => {
    for (const [still, moving, expected] of [
      [0.24, 0.2, 0.48507],
      [0, 0, 2.42536],
    ]) {
      const { world, at, speed, foot } = slide(still, moving);
      run(world, 4);
      expect(speed() / 4).toBeCloseTo(expected, 5);
      expect((10 * (1 - 4 * moving)) / root / (speed() / 4)).toBeCloseTo(1, 6);
      expect((at().y - foot.y) / (at().x - foot.x)).toBeCloseTo(0.25, 9);
      if (moving === 0) continue;
      run(world, Math.sqrt((2 * 100 * root) / expected) - 4);
      expect(world.time).toBeCloseTo(41.23, 2);
      expect(at().x - foot.x).toBeCloseTo(400, 2);
    }
  });
});

test('ch07-pressure-depth: under 10 m of water the pressure is 98.1 kPa above that at the surface', () => {
  // A column of one square metre that stands out of the water: only the pressure on its foot pushes it up.
  const law = buoyancy({ density: 1000, gravity: { y: -9.81 }, level: 0 });
  const pressureAt = (depth: number) => {
    const column = { position: { y: 20 - depth }, hull: { volume: 40, halfHeight: 20, shape: 1 } };
    return lawOn(law, column).y / 1000;
  };
  for (const [depth, pressure] of [
    [0, 0],
    [1, 9.81],
    [10, 98.1],
  ]) {
    // Three products and a share of the immersed volume, each rounded by 2⁻⁵³ of the 392 kPa of the whole column: 2e-13.
    expect(Math.abs(pressureAt(depth) - pressure)).toBeLessThan(1e-12);
  }
});

test('ch07-apparent-weight: (ρ - ρ_fluid) V g; floats 90 % immersed; neutral when equal', () => {
  const deep = { density: 1000, gravity: { y: -10 } };
  const weight = (mass: number) => {
    const { world, eid } = single([uniformGravity({ y: -10 }), buoyancy(deep)], { mass, hull: 2 });
    return forceOn(world, eid).y;
  };
  expect(weight(2500)).toBe(-5000);
  expect(Math.abs(weight(2000) / 2000)).toBeLessThan(1e-12);
  const pool = { ...deep, level: 0 };
  // A box of half height 1 with a tenth of it in the air.
  const ice = { position: { y: -0.8 }, mass: 1800, hull: { volume: 2, halfHeight: 1, shape: 1 } };
  const { world, eid } = single([uniformGravity({ y: -10 }), buoyancy(pool)], ice);
  expect(forceOn(world, eid).y).toBeCloseTo(0, 10);
});

test('ch07-apparent-weight: lead of 11.3 keeps 10.3 of its weight in water, and hangs at rest within the minute', () => {
  expect(apparentWeight.presets).toEqual([{ label: 'Cork and lead', values: { light: 0.2, heavy: 11.3 } }]);
  const { world, at } = started(apparentWeight, { values: { light: 0.2, heavy: 11.3 } }, 3);
  run(world, 60);
  // The hook is at 2 m, the spring 3 m long, and its stiffness 8 N/m for each kilogram. Of the 0.64 m at first, drag leaves
  // exp(-0.3 · 60), 1e-8 m.
  expect(Math.abs(at().y - (2 - 3 - (10.3 * 10) / (8 * 11.3)))).toBeLessThan(1e-8);
});

describe('balloon', () => {
  const rising = (drag: number) => started(balloon, { values: { density: 1.1, drag } });

  test('ch07-balloon: a₀ = g(ρ/ρ_b - 1), v = v_T tanh(a₀t/v_T), neutral at 1.2', () => {
    const { world, eid, going } = rising(0.01);
    expect(-forceOn(world, eid).y).toBeCloseTo(0.90909, 5);
    run(world, 10);
    expect(-going().y / 7.0685).toBeCloseTo(1, 3);
    run(world, 90);
    expect(-going().y / 9.5346).toBeCloseTo(1, 3);
    const neutral = rising(0.01);
    neutral.world.components.Hull.volume[neutral.eid] = 1 / 1.2;
    expect(Math.abs(forceOn(neutral.world, neutral.eid).y)).toBeLessThan(1e-14);
  });

  test('ch07-balloon-no-drag: height ½ · 0.90909 t², and the energy closes', () => {
    const { world, at } = rising(0);
    const before = energy(world).total;
    const start = at().y;
    run(world, 10);
    expect(start - at().y).toBeCloseTo(0.5 * (10 / 11) * 100, 9);
    expect(energy(world).total).toBeCloseTo(before, 9);
  });
});

test('ch07-parachute: 30 before opening, 10 after, and the distance between', () => {
  // It opens itself after 50 s, and drag becomes nine times as large.
  const { world, speed } = started(parachute, { values: { opening: 50, growth: 9 } });
  run(world, 5);
  expect(speed() / 27.154).toBeCloseTo(1, 3);
  run(world, 45);
  expect(speed()).toBeCloseTo(30, 3);
  run(world, 1);
  const opened = 10 / Math.tanh(0.9 + Math.atanh(1 / 3));
  expect(speed() / opened).toBeCloseTo(1, 3);
  run(world, 30);
  expect(speed()).toBeCloseTo(10, 3);
});

test('ch07-lift: k v² across the velocity', () => {
  const { x, y } = lawOn(lift(), { velocity: { x: 6, y: 8 }, lift: 0.5 });
  expect(Math.hypot(x, y)).toBeCloseTo(50, 12);
  expect(x * 6 + y * 8).toBeCloseTo(0, 12);
});

test('ch07-airplane: rolls as 22.361 tanh(0.22361 t), lifts off at 20 after 6.456 s and 130.47', () => {
  const { world, at, going } = started(airplane, { values: { push: 5, wing: 0.025 } });
  run(world, 5);
  expect(going().x / (22.361 * Math.tanh(0.22361 * 5))).toBeCloseTo(1, 4);
  // On the ground but for the roundings of forces that cancel.
  expect(Math.abs(at().y)).toBeLessThan(1e-13);
  let taken: { time: number; x: number; v: number } | undefined;
  for (let i = 0; i < 180 && taken === undefined; i++) {
    step(world, 1 / 60);
    if (going().y > 1e-9) taken = { time: world.time, x: at().x, v: going().x };
  }
  expect((taken?.time ?? 0) / 6.456).toBeCloseTo(1, 2);
  expect((taken?.v ?? 0) / 20).toBeCloseTo(1, 2);
  expect((taken?.x ?? 0) / 130.47).toBeCloseTo(1, 2);
});

test('ch07-wind: at wind speed nothing, and from rest w = w₀/(1 + k w₀ t/m)', () => {
  const law = quadraticDrag({ x: 40 });
  expect(lawOn(law, { velocity: { x: 40 }, quadraticDrag: 5e-4 }).x).toBeCloseTo(0, 15);
  const { world, going } = single([law], { quadraticDrag: 5e-4 });
  run(world, 30);
  expect(40 - going().x).toBeCloseTo(40 / (1 + 5e-4 * 40 * 30), 4);
});

test('ch07-bubbles-wind: still-air rise speeds, and the drift in a wind', () => {
  const bubble = (r: number) => {
    const mass = (4 / 3) * Math.PI * r ** 3;
    return { mass, hull: mass / 0.99, quadraticDrag: 0.01 * Math.PI * r * r };
  };
  const forces = (wind: number) => [
    uniformGravity({ y: 10 }),
    buoyancy({ density: 1, gravity: { y: 10 } }),
    quadraticDrag({ x: wind }),
  ];
  for (const [r, rise] of [
    [5, 8.206],
    [15, 14.213],
    [25, 18.349],
  ]) {
    const still = single(forces(0), bubble(r));
    expect(-forceOn(still.world, still.eid).y / bubble(r).mass).toBeCloseTo(0.10101, 5);
    run(still.world, 2000, 0.1);
    expect(-still.going().y / rise).toBeCloseTo(1, 4);
    const blown = single(forces(40), { ...bubble(r), velocity: { x: 10 } });
    run(blown.world, 10);
    expect(-blown.going().y).toBeLessThan(0.10101 * 10);
    run(blown.world, 10_000, 0.1);
    const { x, y } = blown.going();
    expect(x / 40).toBeCloseTo(1, 2);
    expect(((0.0075 / r) * Math.hypot(x - 40, y) ** 2) / 0.10101).toBeCloseTo(1, 2);
  }
});

describe('ch07-bubbles-turbulence', () => {
  const options = { mean: { x: 20 }, spread: { x: 500, y: 500 }, interval: 0.125, seed: 4 };
  /** Standard deviation of the uniform distribution within ±500. */
  const deviation = 500 / Math.sqrt(3);

  test('ch07-bubbles-turbulence: gusts of mean (20, 0) ± 289/√N', () => {
    const wind = gusts(options);
    const count = 20_000;
    const sum = { x: 0, y: 0, xx: 0, yy: 0 };
    for (let i = 0; i < count; i++) {
      const { x, y } = wind((i + 0.5) * options.interval);
      sum.x += (x - 20) / count;
      sum.y += y / count;
      sum.xx += (x - 20) ** 2 / count;
      sum.yy += y ** 2 / count;
    }
    // Three and a half standard errors; that of a mean square is √((9/5 - 1)/N) of it, as ⟨w⁴⟩ = 9/5 ⟨w²⟩².
    const standardErrors = 3.5 / Math.sqrt(count);
    for (const mean of [sum.x, sum.y]) expect(Math.abs(mean)).toBeLessThan(289 * standardErrors);
    for (const square of [sum.xx, sum.yy]) {
      expect(Math.abs(square / deviation ** 2 - 1)).toBeLessThan(Math.sqrt(0.8) * standardErrors);
    }
  });

  test.each([8, 16, 64])(
    'ch07-bubbles-turbulence: the exact path through held gusts, at %d frames a second',
    (rate) => {
      // This scheme asks for no force at the end of a step, where the next gust blows already.
      const { world, at, going } = single(
        [linearDrag(gusts(options))],
        { linearDrag: 1 },
        { integrator: gaussRadau() },
      );
      run(world, 2, 1 / rate);
      const wind = gusts(options);
      const fade = Math.exp(-options.interval);
      for (const axis of ['x', 'y'] as const) {
        let [position, velocity] = [0, 0];
        // While a gust w lasts: v = w + (v₀ - w) exp(-t), and x by its integral.
        for (let i = 0; i < 2 / options.interval; i++) {
          const w = wind((i + 0.5) * options.interval)[axis];
          position += w * options.interval + (velocity - w) * (1 - fade);
          velocity = w + (velocity - w) * fade;
        }
        // Speeds of 500, rounded by 2⁻⁵³ of that some ten times in each of at most 128 steps: 7e-11.
        expect(Math.abs(at()[axis] - position)).toBeLessThan(1e-10);
        expect(Math.abs(going()[axis] - velocity)).toBeLessThan(1e-10);
      }
    },
  );
});

test('ch07-vortex: k r₀ on both sides of the rim, outwards inside and inwards outside', () => {
  const law = vortex({ strength: 3, radius: 2 });
  expect(lawOn(law, { position: { x: 2 } }).x).toBe(6);
  expect(lawOn(law, { position: { x: 2 * (1 + 1e-12) } }).x).toBeCloseTo(-6, 9);
  expect(lawOn(law, { position: { x: 4 } }).x).toBe(-3 * 4 * 0.5 ** 4);
});
