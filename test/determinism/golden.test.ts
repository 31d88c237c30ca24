/**
 * The hashes of chaotic scenes, as they were when this file was last touched.
 *
 * They change whenever the arithmetic of any body changes by one bit: another order of additions, another formula,
 * another draw of the random numbers. That breaks every recording and replay made before. So update them only for a
 * change that is meant to change trajectories, in the same commit, and say so in CHANGELOG.md; for any other change a
 * new value here is a fault that was found. `test/browser/determinism.test.ts` holds browsers to the same scenes.
 */
import { expect, it } from 'vitest';
import { chaosHashes } from '../support/chaos.ts';
import { hingeHashes } from '../support/falling-hinges.ts';
import { sceneHashes } from '../support/scene-hashes.ts';

it('1 500 steps of chaotic scenes end where they always ended', { timeout: 30_000 }, () => {
  expect(chaosHashes()).toEqual({
    '2D f32': 'eadeabeb4a12eaf8',
    '2D f64': 'b5f33039123b9a26',
    '3D f32': 'b9f36703e07e0fd8',
    '3D f64': '7eb4e407a4e19d2f',
  });
});

it('240 steps of every scene end where they always ended', () => {
  expect(sceneHashes()).toMatchInlineSnapshot(`
    {
      "attractors": "2777c379c355bcec",
      "black-hole": "e70744aaf492d90f",
      "bouncing-balls": "cfaf83aa9bde98f3",
      "chains": "19a31649e3cc4b34",
      "circles": "6f26557c9b4c24bb",
      "cloth": "5dffac56cde82676",
      "crowd": "3f6a67b7f39f8369",
      "discs": "0c01376fcaa15685",
      "elastic-discs": "e8b51bd9e7592784",
      "emitters": "ffc1284ca166769f",
      "fireworks": "221c65b03e030b93",
      "galaxy": "702381d7d241eebf",
      "gas": "8a5c399a04e77aea",
      "joint-grid": "1a459e9a071e74a3",
      "many-pyramids": "5bffd36ff27a64ac",
      "molecules": "424002f2118ba0ce",
      "nbody-direct": "39ef8796d15dfc35",
      "nbody-tree": "a5795ad16a5a978e",
      "particles": "dcd8a69771fd17d6",
      "plasma": "8088946b47a727e0",
      "pyramid": "3f0a9303651e8015",
      "rope": "dd59fcd83d628992",
      "smash": "e63fa89ded802f9c",
      "solar-system": "629d39c213fda8a5",
      "spinner": "293483a452ce6074",
      "springs": "2f827429c1ac197b",
      "tumbler": "b88e2067c63da790",
      "washer": "4ff1d51be1f026c2",
    }
  `);
});

it('falling hinges come to rest as they always did, after as many steps', { timeout: 30_000 }, () => {
  expect(hingeHashes()).toEqual({
    f32: '285 744569d47e050be1',
    f64: '279 c3a3417ae0f1c1ba',
  });
});
