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
    '2D f32': 'a5d19f9f2a538acd',
    '2D f64': '53ec76dd34e0b2ee',
    '3D f32': '392a4bd99888cfca',
    '3D f64': '74ea4dd9ad1713f5',
  });
});

it('240 steps of every scene end where they always ended', () => {
  expect(sceneHashes()).toMatchInlineSnapshot(`
    {
      "attractors": "2777c379c355bcec",
      "black-hole": "e70744aaf492d90f",
      "bouncing-balls": "c10de49e7693af71",
      "chains": "19a31649e3cc4b34",
      "circles": "6f26557c9b4c24bb",
      "cloth": "5dffac56cde82676",
      "crowd": "babc179e93d2dc6d",
      "discs": "dad8afc34e24858e",
      "elastic-discs": "ecd3224319613c4e",
      "emitters": "ffc1284ca166769f",
      "fireworks": "221c65b03e030b93",
      "galaxy": "702381d7d241eebf",
      "gas": "8a5c399a04e77aea",
      "joint-grid": "1a459e9a071e74a3",
      "many-pyramids": "753b3f54909359f5",
      "molecules": "424002f2118ba0ce",
      "nbody-direct": "39ef8796d15dfc35",
      "nbody-tree": "a5795ad16a5a978e",
      "particles": "dcd8a69771fd17d6",
      "plasma": "8088946b47a727e0",
      "pyramid": "a2407c8c64119079",
      "rope": "dd59fcd83d628992",
      "smash": "aa06f4fab3c208b2",
      "solar-system": "629d39c213fda8a5",
      "spinner": "e09cdad9c4264952",
      "springs": "2f827429c1ac197b",
      "tumbler": "1cf28ccde71c3b7a",
      "washer": "8ce084936d26726b",
    }
  `);
});

it('falling hinges come to rest as they always did, after as many steps', { timeout: 30_000 }, () => {
  expect(hingeHashes()).toEqual({
    f32: '372 45a215be786be829',
    f64: '303 9e33b776ee9479e4',
  });
});
