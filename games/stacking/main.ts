/** A sandbox of rigid bodies, drawn by pixi.js. */
import { startGame } from '@principia/shell';
import { applyColors } from './colors.ts';
import { settings } from './settings.ts';
import { applyValue, blast, createSim, dropBlock, report, throwBall } from './sim.ts';

const ACTIONS = { action: throwBall, up: dropBlock, down: blast } as const;

await startGame({
  title: 'Stack and smash',
  home: '../index.html',
  settings,
  create: createSim,
  apply: applyValue,
  applyColors: (sim, { seed, safeColors }) => applyColors(sim, seed, safeColors),
  report,
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  controls: {
    buttons: {
      action: { label: '●', keys: ['c'] },
      up: { label: '■', keys: ['n'] },
      down: { label: '✶', keys: ['t'] },
    },
    press: (sim, name) => ACTIONS[name as keyof typeof ACTIONS](sim),
    release() {},
  },
  help: [
    ['C, ●', 'throw a heavy ball'],
    ['N, ■', 'drop a block'],
    ['T, ✶', 'blow up the middle'],
    ['Drag a body', 'move it, stack it, release to throw it'],
  ],
});
