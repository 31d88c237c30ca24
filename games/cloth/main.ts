/** A cloth to tear, drawn by pixi.js. */
import { startGame } from '@principia/shell';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, createSim } from './sim.ts';

await startGame({
  title: 'A cloth to tear',
  settings,
  create: createSim,
  apply: applyValue,
  tell: (sim) => ({ broken: brokenThreads(sim) }),
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (stage) => (await import('./view.ts')).openView(stage) },
  },
  help: [['Drag', 'pull the cloth, and tear it; every finger may hold a piece']],
});
