/** A flight simulator, drawn by three.js. */
import { FOUR_WAYS, helpLines, startGame } from '@principia/shell';
import { reasonOf } from './sentences.ts';
import { settings } from './settings.ts';
import { applyValue, createFlight, type Flight } from './sim.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;

function outcome({ log, mission }: Flight) {
  if (log.phase === 'flying') return undefined;
  const lines = [reasonOf(log), WORDS.points(log.score)];
  const title = log.phase === 'landed' && !log.isOnRunway ? WORDS.offRunway : WORDS[log.phase];
  return { title, score: log.score, lines, share: WORDS.share(WORDS.missions[mission], log.score) };
}

startGame({
  title: WORDS.title,
  scoresName: 'Flight simulator',
  home: '../index.html',
  settings,
  create: createFlight,
  apply: applyValue,
  outcome,
  hasEnded: ({ log }) => log.phase !== 'flying',
  report: ({ log, attitude, height, climb, pilot }) => ({
    phase: log.phase,
    reason: reasonOf(log),
    score: log.score,
    ring: log.ring,
    onGround: log.onGround,
    airspeed: attitude.airspeed,
    height,
    climb,
    throttle: pilot.throttle,
  }),
  renderers: {
    three: { label: '3D', dimensions: 3, open: async (context) => (await import('./view.ts')).openView(context) },
  },
  controls: {
    buttons: {
      ...FOUR_WAYS,
      more: { label: '⇧', keys: ['t', 'pageup'], pad: [7] },
      less: { label: '⇩', keys: ['g', 'pagedown'], pad: [6] },
      brake: { label: '■', keys: ['n'], pad: [0] },
      rudderLeft: { label: '↶', keys: ['a'], pad: [4], touch: false },
      rudderRight: { label: '↷', keys: ['d'], pad: [5], touch: false },
    },
    press: (flight, name) => flight.press(name, true),
    release: (flight, name) => flight.press(name, false),
    steer: (flight, x, y) => flight.stick(x, y),
  },
  help: helpLines(WORDS.help, ['mouse']),
});
