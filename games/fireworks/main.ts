/** Fireworks: one scene, drawn in 2D by pixi.js and in 3D by three.js. */
import { startGame } from '@principia/shell';
import { DEMO_SHOW } from './demo-show.ts';
import { Desk } from './desk.ts';
import { settings } from './settings.ts';
import { applyValue, createGame } from './sim.ts';

const desk = new Desk();

await startGame({
  title: 'Fireworks',
  settings,
  create: (options) => createGame({ ...options, opening: DEMO_SHOW }),
  apply: applyValue,
  tell: (sim) => ({ hash: sim.hash(), log: [...sim.log.entries], alive: sim.scene.alive, fired: sim.fired }),
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (stage) => (await import('./view-2d.ts')).openView2D(stage, desk) },
    three: {
      label: '3D',
      dimensions: 3,
      open: async (stage) => (await import('./view-3d.ts')).openView3D(stage, desk),
    },
  },
  help: [['Press, touch', 'sends a shell up to there; hold for a larger one']],
});
