/** A cloth that tears, drawn by pixi.js. */
import { startGame } from '@principia/shell';
import { settings } from './settings.ts';
import { applyValue, brokenThreads, createSim } from './sim.ts';

await startGame({
  title: 'A cloth to tear',
  home: '../index.html',
  settings,
  create: createSim,
  apply: applyValue,
  report: (sim) => ({ broken: brokenThreads(sim) }),
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: [['Drag', 'pull and tear the cloth; every finger can grab it']],
});
