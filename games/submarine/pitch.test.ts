import { step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DENSITY, GRAVITY, HULL } from './hull.ts';
import { buoyancyTorque, INERTIA, type Pitch, PLANES, STABILITY, STRIPS, stepPitch } from './pitch.ts';
import { createGame } from './sim.ts';

const DEEP = { depth: 50, volume: HULL.volume, speed: 0 };
const BUOYANCY = DENSITY * GRAVITY * HULL.volume;
const at = (pitch: number): Pitch => ({ pitch, rate: 0, planes: 0, facing: 1 });

function run(state: Pitch, seconds: number, place = DEEP, wanted = 0, each: (time: number) => void = () => {}): Pitch {
  for (let i = 0; i < 60 * seconds; i++) {
    stepPitch(state, wanted, place, 1 / 60);
    each((i + 1) / 60);
  }
  return state;
}

describe('the torque of the buoyancy', () => {
  it('is −B h sin θ deep down', () => {
    for (const pitch of [-0.6, 0.1, 1.2]) {
      expect(buoyancyTorque(50, pitch, HULL.volume) / (-BUOYANCY * STABILITY * Math.sin(pitch))).toBeCloseTo(1, 12);
    }
  });

  it('has the waterline of a ship as well when half of the hull is out of the water', () => {
    // Second moment of the waterline, V/(2 R) L²/12; n strips have 1 − 1/n² of it.
    const line =
      DENSITY * GRAVITY * (HULL.volume / (2 * HULL.halfHeight)) * (HULL.length ** 2 / 12) * (1 - STRIPS ** -2);
    const pitch = 1e-3;
    const expected = -(line + (BUOYANCY / 2) * STABILITY) * pitch;
    // Of the next order, θ².
    expect(Math.abs(buoyancyTorque(0, pitch, HULL.volume) / expected - 1)).toBeLessThan(1e-5);
  });
});

describe('the pitch', () => {
  it('swings with the period 2π √(I/(B h)), and drag across the hull damps it', () => {
    const crossings: number[] = [];
    let before = 0.02;
    const state = at(0.02);
    run(state, 60, DEEP, 0, (time) => {
      if (before > 0 && state.pitch <= 0) crossings.push(time);
      before = state.pitch;
    });
    const period = (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
    // Crossings are known to a sixtieth of a second, of 16 s; drag of the second order in 0.02 changes less.
    expect(period / (2 * Math.PI * Math.sqrt(INERTIA / (BUOYANCY * STABILITY)))).toBeCloseTo(1, 2);
    expect(Math.abs(run(at(0.5), 300).pitch)).toBeLessThan(0.05);
  });

  it('rests where planes and buoyancy balance: sin θ = ½ ρ A C_L l u²/(B h)', () => {
    const { pitch } = run(at(0), 120, { ...DEEP, speed: 5 }, 1);
    const planes = 0.5 * DENSITY * PLANES.area * PLANES.lift * PLANES.arm * 25;
    expect(Math.sin(pitch)).toBeCloseTo(planes / (BUOYANCY * STABILITY), 6);
    // Astern the same planes push the nose down.
    expect(run(at(0), 120, { ...DEEP, speed: -5 }, 1).pitch).toBeCloseTo(-pitch, 6);
  });
});

describe('in the game', () => {
  function sail(keys: readonly string[], seconds: number) {
    const game = createGame({ values: { level: 1 }, seed: 1 });
    game.world.components.Position.y[game.sub] = -30;
    game.world.components.Position.x[game.sub] = 280;
    game.boat.fill = 0.5;
    for (const key of keys) game.press(key);
    for (let i = 0; i < 60 * seconds; i++) step(game.world, game.dt);
    return game;
  }

  it('points the nose where the keys lead, to the right and to the left, and the propeller pushes along the hull', () => {
    for (const way of ['right', 'left']) {
      const up = sail([way, 'up'], 5);
      const down = sail([way, 'down'], 5);
      expect(up.tilt.pitch).toBeGreaterThan(0.1);
      expect(down.tilt.pitch).toBeLessThan(-0.1);
      expect(up.tilt.facing).toBe(way === 'right' ? 1 : -1);
      const { Thrust } = up.world.components;
      expect(Thrust.y[up.sub] / Math.abs(Thrust.x[up.sub])).toBeCloseTo(Math.tan(up.tilt.pitch), 1);
    }
    // Without way on, planes do nothing.
    expect(Math.abs(sail(['down'], 2).tilt.pitch)).toBeLessThan(0.03);
  });
});
