/** Bouncing balls: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { startGame } from '@principia/shell';
import { applyColors } from './colors.ts';
import { settings } from './settings.ts';
import { applyValue, clampToRoom, countContacts, createBalls } from './sim.ts';

await startGame({
  title: 'Bouncing balls',
  home: '../index.html',
  variesSeed: true,
  settings,
  create: createBalls,
  applyColors: (sim, { seed, safeColors }) => applyColors(sim, seed, safeColors),
  apply: (sim, name, values) => name === 'trails' || name === 'sound' || applyValue(sim, name, values),
  dragLimit: clampToRoom,
  contacts: countContacts,
  renderers: {
    three: { label: '3D', dimensions: 3, open: async (context) => (await import('./view-3d.ts')).openView3D(context) },
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view-2d.ts')).openView2D(context) },
  },
  controls: {
    buttons: { action: { label: 'Pour', keys: ['v'], pad: [0] } },
    press: ({ log }) => log.add({ kind: 'pour', isOpen: true }),
    release: ({ log }) => log.add({ kind: 'pour', isOpen: false }),
  },
  help: [
    ['Tap, click', 'blow up what is there'],
    ['Press and hold', 'a magnet: balls fly there, and follow the pointer'],
    ['Hold V, Pour', 'pour balls from the ceiling'],
    ['Drag a ball', 'grab it, release to throw it; every finger can grab one'],
    ['Tilt', 'on phones and tablets: gravity follows the way the device is held'],
    ['Drag elsewhere', 'in 3D: rotate the view'],
    ['Wheel, two fingers', 'zoom and move the view; so does a drag with the right button'],
  ],
});
