/** Black hole: a ship among black holes, drawn by pixi.js. */
import { FOUR_WAYS, helpLines, startGame } from '@principia/shell';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { applyValue, createGame, type Input } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;

startGame({
  title: WORDS.title,
  scoresName: 'Black hole',
  home: '../index.html',
  settings,
  create: createGame,
  apply: applyValue,
  replay: (sim) => sim.again(),
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '↻', keys: ['n'], pad: [2], touch: false } },
    press: (sim, name) => sim.press(name === 'action' ? 'redraw' : (name as Input)),
    release: (sim, name) => name !== 'action' && sim.press('release'),
    letGo: (sim) => sim.letGo(),
    steer: (sim, x, y) => sim.steer(x, y),
  },
  outcome: outcomeOf,
  report: reportState,
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  help: helpLines(WORDS.help, ['keys']),
});
