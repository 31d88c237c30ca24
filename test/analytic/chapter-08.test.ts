// Springs and oscillations. y points down.
import {
  centreOfMass,
  discMass,
  gaussRadau,
  type Integrator,
  linearDrag,
  positionFirstEuler,
  rungeKutta4,
  velocityVerlet,
} from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import bungee from '../../packages/scenes/src/examples/ch08/bungee.ts';
import coupledChain from '../../packages/scenes/src/examples/ch08/coupled-chain.ts';
import damped from '../../packages/scenes/src/examples/ch08/damped.ts';
import dampedAnalytic from '../../packages/scenes/src/examples/ch08/damped-analytic.ts';
import dragSpring from '../../packages/scenes/src/examples/ch08/drag-spring.ts';
import forcedPeriodic from '../../packages/scenes/src/examples/ch08/forced-periodic.ts';
import forcedRandom from '../../packages/scenes/src/examples/ch08/forced-random.ts';
import stickman from '../../packages/scenes/src/examples/ch08/stickman.ts';
import { dragBodies } from '../../packages/shell/src/dragging.ts';
import { forceOn, read, run, started } from '../support/laws.ts';
import { crossings } from '../support/orbits.ts';

describe('damped', () => {
  const gamma = 0.25;
  const omega = Math.sqrt(10 - gamma * gamma);
  const exact = (x: number, v: number, t: number) =>
    Math.exp(-gamma * t) * (x * Math.cos(omega * t) + ((v + gamma * x) / omega) * Math.sin(omega * t));
  /** Id of the ball on its spring, in each of these examples. */
  const BALL = 2;
  const onSpring = (integrator: Integrator, damping = 0.5) =>
    started(damped, { values: { damping }, integrator }, BALL);

  test('ch08-damped: period 1.993156 s, ratio 0.607569 a period; critical and stronger damping do not oscillate', () => {
    for (const integrator of [velocityVerlet, rungeKutta4]) {
      const { world, at } = onSpring(integrator);
      run(world, 1.993156, 1e-2 / 6);
      expect((at().x - 350) / -250 / 0.607569).toBeCloseTo(1, 3);
    }
    const ball = onSpring(rungeKutta4);
    const times = crossings(ball.world, () => ball.at().x, 350, 10, 1e-3);
    expect(times[1] - times[0]).toBeCloseTo(1.993156, 4);
    for (const c of [2 * Math.sqrt(10), 20]) {
      const slow = onSpring(rungeKutta4, c);
      run(slow.world, 20, 1 / 60, () => expect(slow.at().x).toBeLessThan(350 + 1e-9));
    }
  });

  test('ch08-damped-analytic: largest error over 20 s', () => {
    // Runge-Kutta 4 turns by ω⁵h⁴t/120 too little: of the amplitude 250 exp(-t/4) that is at most, after 4 s, 7.4e-5 at
    // 60 steps a second. It takes 120 of them, or a higher order, to come below 1e-5.
    for (const [integrator, dt, low, high] of [
      [positionFirstEuler, 1 / 60, 5.1, 5.3],
      [rungeKutta4, 1 / 60, 0, 8e-5],
      [rungeKutta4, 1 / 120, 0, 1e-5],
      [gaussRadau(), 1 / 60, 0, 1e-10],
    ] as const) {
      const { world, at } = started(dampedAnalytic, { integrator }, BALL);
      const centre = { x: at().x + 250, y: at().y };
      let error = 0;
      run(world, 20, dt, () => {
        const { x, y } = at();
        const [ex, ey] = [exact(-250, 0, world.time), exact(0, 200, world.time)];
        error = Math.max(error, Math.abs(x - centre.x - ex), Math.abs(y - centre.y - ey));
      });
      expect(error).toBeGreaterThanOrEqual(low);
      expect(error).toBeLessThan(high);
    }
  });

  test.each([
    ['2ω', 2 * omega, 9.454],
    ['ω/2', omega / 2, 37.429],
    ['ω', omega, 179.306],
    ['resonance', 3.14245, 179.447],
  ] as const)('ch08-forced-periodic: amplitude at %s', (_, angularFrequency, amplitude) => {
    const { world, at } = started(forcedPeriodic, { values: { omega: angularFrequency } }, BALL);
    run(world, 60);
    let [low, high] = [at().x, at().x];
    run(world, (4 * Math.PI) / angularFrequency, 1 / 240, () => {
      low = Math.min(low, at().x);
      high = Math.max(high, at().x);
    });
    expect((high - low) / 2 / amplitude).toBeCloseTo(1, 3);
  });

  test('ch08-forced-random: mean 50 of a one-sided force; rms 11.785 of noise, for every step', () => {
    // Bodies, and times of 8 s after each other, in which a square forgets all but e^(-c t/m) = 2 %.
    const [count, times] = [2000, 5];
    for (const dt of [1 / 30, 1 / 60]) {
      const { world } = started(forcedRandom, { values: { push: 500 } });
      let [centre, square] = [0, 0];
      run(world, 8, dt);
      for (let time = 0; time < times; time++) {
        run(world, 8, dt);
        for (const x of world.components.Position.x.subarray(1, count + 1)) {
          centre += x / (count * times);
          square += (x - 50) ** 2 / (count * times);
        }
      }
      // Three and a half standard errors: 1/√N of the rms for the mean, 1/√2N for the rms, which the scheme itself may
      // miss by ω² dt²/4.
      const standardErrors = 3.5 / Math.sqrt(count * times);
      expect(Math.abs(centre - 50)).toBeLessThan(11.785 * standardErrors);
      expect(Math.abs(Math.sqrt(square) / 11.785 - 1)).toBeLessThan(standardErrors / Math.SQRT2 + (10 * dt * dt) / 4);
    }
  });
});

test('ch08-stickman: a body of 20 and a head of 10 balance at a fifth of the distance of their middles', () => {
  const { world, at } = started(stickman);
  expect(at().y).toBeCloseTo(30 / 5, 12);
  expect(at().y).toBeCloseTo((discMass(1, 10) * 30) / (discMass(1, 20) + discMass(1, 10)), 12);
  expect(centreOfMass(world).y).toBeCloseTo(30 / 5, 12);
});

describe('ch08-bungee', () => {
  /** The jumper is the second body, after the bridge. */
  const jump = (drag: number) => started(bungee, { values: { drag } }, 2);

  test('ch08-bungee: free fall to 63.246 in 3.162 s, lowest at 361.94, or 356.1 with drag; rest at 222', () => {
    const free = jump(0);
    run(free.world, Math.sqrt(10));
    expect(free.at().y).toBeCloseTo(150, 6);
    expect(free.going().y).toBeCloseTo(63.246, 2);
    for (const [drag, lowest] of [
      [0, 361.94],
      [0.02, 356.1],
    ]) {
      const { world, at } = jump(drag);
      let low = 0;
      run(world, 12, 1 / 60, () => {
        low = Math.max(low, at().y);
      });
      expect(Math.abs(low / lowest - 1)).toBeLessThan(0.005);
    }
    // Drag of the square of the speed would never bring it quite to rest.
    const resting = jump(0);
    resting.world.forces.push(linearDrag());
    addComponent(resting.world, resting.eid, set(resting.world.components.LinearDrag, 90));
    run(resting.world, 80);
    // Damped by exp(-t/2), it comes to rest where its steps are less than half an ulp, 1.4e-14: at 60 · 1.4e-14 a
    // second, the drag of which holds 90/25 of that.
    expect(Math.abs(resting.at().y - 222)).toBeLessThan((90 / 25) * 60 * 1.4e-14);
  });
});

describe('ch08-drag-spring', () => {
  /** Ids of the figure that is dragged, and of that without drag. */
  const [FIGURE, FREE] = [2, 5];

  test('ch08-drag-spring: rests at 270, oscillates with 2π, and swings with 2π √(220/20) = 20.84', () => {
    const bouncing = started(dragSpring, {}, FREE);
    const bounces = crossings(bouncing.world, () => bouncing.at().y, 270, 20, 1 / 240);
    expect(bounces[1] - bounces[0]).toBeCloseTo(2 * Math.PI, 2);
    const swinging = started(dragSpring, { values: { other: 1 } }, FREE);
    const swings = crossings(swinging.world, () => swinging.at().x, 600, 45, 1 / 240);
    // By θ² = (4/220)² a spring that gives way and a swing that is not small may shift it.
    expect(Math.abs((swings[1] - swings[0]) / 20.84 - 1)).toBeLessThan((4 / 220) ** 2);
  });

  test('ch08-drag-spring: is dragged to where the pointer is, and released without a jump', () => {
    const { world, eid, at, speed } = started(dragSpring, {}, FIGURE);
    const hand = dragBodies(world);
    hand.grab(1, eid, at().x, at().y);
    hand.move(1, 420, 200);
    run(world, 5);
    expect(Math.hypot(at().x - 420, at().y - 200)).toBeLessThan(2);
    const before = at();
    hand.release(1, 0, 0);
    run(world, 1e-6, 1e-6);
    expect(Math.hypot(at().x - before.x, at().y - before.y)).toBeLessThan(1e-3);
    expect(speed()).toBeLessThan(1);
  });
});

describe('ch08-coupled-chain', () => {
  const rests = [112, 172, 230, 286, 340, 392];
  /** After the support come balls and springs in turn. */
  const balls = rests.map((_, i) => 2 + 2 * i);
  const chain = (damping: number, mode: number) =>
    started(coupledChain, { values: { swing: 0, damping, mode } }, balls[5]);
  /** Below it hang the others: each spring is stretched by the weight it carries. */
  const restOf = (i: number) => {
    let y = 50;
    for (let j = 0; j <= i; j++) y += 50 + ((6 - j) * 20) / 10;
    return y;
  };

  test('ch08-coupled-chain: starts and stays in equilibrium', () => {
    rests.forEach((rest, i) => {
      expect(restOf(i)).toBeCloseTo(rest, 2);
    });
    const { world } = chain(0.5, 1);
    run(world, 80);
    balls.forEach((ball, i) => {
      expect(read(world, ball).at().y).toBeCloseTo(rests[i], 2);
    });
  });

  test('ch08-coupled-chain: the vertical normal modes', () => {
    [0.7623, 2.2427, 3.5928, 4.734, 5.6001, 6.1408].forEach((omega, j) => {
      const { world, at } = chain(0, j + 1);
      const times = crossings(world, () => at().y, 392, 20, 1 / 240);
      expect((2 * Math.PI) / (times[1] - times[0]) / omega).toBeCloseTo(1, 2);
      expect(Math.abs((2 * Math.PI) / (times[1] - times[0]) / omega - 1)).toBeLessThan(0.005);
    });
    const { world } = chain(0, 1);
    balls.forEach((ball, i) => {
      world.components.Position.y[ball] = restOf(i);
    });
    for (const ball of balls) expect(forceOn(world, ball).y).toBeCloseTo(0, 9);
  });
});
