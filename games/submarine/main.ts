/** A submarine that brings up crates from a dark sea, drawn by pixi.js. */
import { FOUR_WAYS, helpLines, startGame } from '@principia/shell';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { createGame } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;

startGame({
  title: WORDS.title,
  scoresName: 'Submarine',
  home: '../index.html',
  settings,
  create: createGame,
  apply: (_, name) => name !== 'level',
  outcome: outcomeOf,
  report: reportState,
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '●', keys: ['x', 'enter'], pad: [0] } },
    press: (sim, name) => sim.press(name),
    release: (sim, name) => sim.release(name),
    letGo: (sim) => sim.steer(0, 0),
    exclusive: [
      ['left', 'right'],
      ['up', 'down'],
    ],
  },
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: helpLines(WORDS.help),
});
