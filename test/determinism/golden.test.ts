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
    '3D f32': '5b66bc626bbb58c8',
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
      "circles": "1890c4b42d51cf66",
      "cloth": "5dffac56cde82676",
      "crowd": "81664da0e668c650",
      "discs": "ba656a60497c9ff8",
      "elastic-discs": "e8b51bd9e7592784",
      "emitters": "ffc1284ca166769f",
      "fireworks": "221c65b03e030b93",
      "galaxy": "702381d7d241eebf",
      "gas": "8a5c399a04e77aea",
      "joint-grid": "1a459e9a071e74a3",
      "many-pyramids": "802eecabae7b4ffa",
      "molecules": "424002f2118ba0ce",
      "nbody-direct": "39ef8796d15dfc35",
      "nbody-tree": "a5795ad16a5a978e",
      "particles": "dcd8a69771fd17d6",
      "plasma": "8088946b47a727e0",
      "pyramid": "c83f148a16fcb59c",
      "rope": "dd59fcd83d628992",
      "smash": "a9f1eab2a1dc7919",
      "solar-system": "629d39c213fda8a5",
      "spinner": "1f3e4c3ac5610b8b",
      "springs": "2f827429c1ac197b",
      "tumbler": "d5bf4e240897272f",
      "washer": "4ac4a06e418ecda3",
    }
  `);
});

it('falling hinges come to rest as they always did, after as many steps', { timeout: 30_000 }, () => {
  expect(hingeHashes()).toEqual({
    f32: '283 0f7883cd9013f8cc',
    f64: '305 0cfcdc2956d09a59',
  });
});
