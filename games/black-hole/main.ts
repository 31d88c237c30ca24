/** Black hole: a ship among black holes, drawn by pixi.js. */
import { FOUR_WAYS, startGame } from '@principia/shell';
import { outcomeOf, tell } from './report.ts';
import { settings } from './settings.ts';
import { applyValue, createGame, type Input } from './sim.ts';

await startGame({
  title: 'Black hole',
  settings,
  create: createGame,
  apply: applyValue,
  replay: (sim) => sim.again(),
  controls: {
    buttons: { ...FOUR_WAYS, action: { label: '↻', keys: ['n'], pad: [2] } },
    press: (sim, name) => sim.press(name === 'action' ? 'redraw' : (name as Input)),
    release: (sim, name) => name !== 'action' && sim.press('release'),
  },
  outcome: outcomeOf,
  tell,
  renderers: {
    pixi: { label: '2D', dimensions: 2, open: async (stage) => (await import('./view.ts')).openView(stage) },
  },
  help: [
    ['Arrow keys', 'push up, left, down or right; the last key decides, any key let go cuts the thrust'],
    ['Press, touch', 'push towards the finger or the mouse; the d-pad or stick of a gamepad works too'],
    ['The aim', 'cross the line at the top: as many points as there are holes, then there is one more'],
    ['Beware', 'the dark disc of a hole takes one of three lives'],
    ['N, double click', 'other holes, as often as you like; the level then gives no bonus'],
    ['Bonus', 'for fuel left over, and for every slingshot round a hole'],
  ],
});
