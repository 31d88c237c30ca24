import { step } from '@principia/physics';
import { SHELL_NAMES, STAR_COLORS } from '@principia/scenes';
import { describe, expect, it } from 'vitest';
import { PlayerControls } from './controls.ts';
import { GALLERY, secondsOf } from './gallery.ts';
import { LAST_TICK, quantize, readShow, writeShow } from './show.ts';
import { createGame, SWARM } from './sim.ts';

const LEAST_SHELLS = 12;

const create = () =>
  createGame({ values: { wind: 0, barrage: false, sparks: 1000 }, seed: 3, dimensions: 2, opening: [], isDemo: true });

describe.each(GALLERY)('the show $name', ({ cues }) => {
  it('is what a link can carry: known shells at known places, sorted by time', () => {
    expect(cues.length).toBeGreaterThanOrEqual(LEAST_SHELLS);
    expect(readShow(writeShow(cues))).toEqual(cues.map(quantize));
    for (const { tick, x, y, z, kind, color, power } of cues) {
      const kept = quantize({ tick, x, y, z, kind, color, power });
      // A tenth of a second; half the resolution of a place and of a power. What lies outside is moved farther.
      expect(tick).toBeLessThanOrEqual(LAST_TICK);
      expect(Math.abs(kept.tick - tick)).toBeLessThanOrEqual(3);
      for (const [is, was] of [
        [kept.x, x],
        [kept.y, y],
        [kept.z, z],
      ])
        expect(Math.abs(is - was)).toBeLessThanOrEqual(0.2001);
      expect(Math.abs(kept.power - power)).toBeLessThanOrEqual(0.5 / 15 + 1e-9);
      expect(SHELL_NAMES[kind]).toBeDefined();
      expect(STAR_COLORS[color]).toBeDefined();
      // A swarm is not launched, and its power is a time.
      expect(kind).not.toBe(SWARM);
    }
  });

  it('launches every shell, shows light within three seconds, and is over when the list says so', () => {
    const game = create();
    const controls = new PlayerControls('');
    controls.load(game, cues);
    expect(controls.editor.cues).toEqual(cues.map(quantize));
    let [first, last] = [Number.POSITIVE_INFINITY, 0];
    const seconds = secondsOf(cues);
    for (let tick = 1; tick < 60 * (seconds + 3); tick++) {
      step(game.world, game.dt);
      if (game.scene.alive === 0) continue;
      first = Math.min(first, tick / 60);
      last = tick / 60;
    }
    expect(game).toMatchObject({ refused: 0, isShowing: false, isDemo: false });
    expect(first).toBeLessThan(3);
    expect(Math.abs(last - seconds)).toBeLessThan(1);
  });
});

it('a show takes the place of the one being made, which undo brings back', () => {
  const game = create();
  const controls = new PlayerControls('');
  controls.editor.add({ x: 0, y: 30, z: 0, kind: 1, color: 2, power: 0.4 });
  const { cues, cursor } = controls.editor;
  controls.load(game, GALLERY[0].cues);
  expect(controls.editor.cues).toHaveLength(GALLERY[0].cues.length);
  expect(controls.editor.cursor).toBeGreaterThan(controls.editor.cues.at(-1)?.tick ?? 0);
  controls.editor.undo();
  expect(controls.editor).toMatchObject({ cues, cursor });
});
