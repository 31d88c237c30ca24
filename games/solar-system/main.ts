/** The solar system as JPL knows it, and missions to fly in it, drawn by three.js. */
import { BODY_NAMES } from '@principia/scenes';
import { startGame } from '@principia/shell';
import { Page } from './page.ts';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { createGame } from './sim.ts';
import { RATES } from './solar-clock.ts';
import { WORDS } from './words.ts';

const page = new Page(location.hash);

/** Factor by which an arrow key changes the speed of time. */
const KEY_FACTOR = 2;

const digits = BODY_NAMES.slice(0, 10).map(
  (_, i) => [`follow ${i}`, { label: '', keys: [String(i)], touch: false }] as const,
);

await startGame({
  title: WORDS.title,
  home: '../index.html',
  settings,
  create: ({ values }) => createGame({ values, opening: page.opening }),
  apply(sim, name) {
    if (name !== 'moon') return true;
    page.keepDate(sim);
    return false;
  },
  replay: (sim) => sim.again(),
  outcome: outcomeOf,
  report: reportState,
  controls: {
    buttons: {
      faster: { label: '', keys: ['arrowright', 'arrowup'], pad: [5], touch: false },
      slower: { label: '', keys: ['arrowleft', 'arrowdown'], pad: [4], touch: false },
      ...Object.fromEntries(digits),
    },
    press({ clock }, name) {
      if (name.startsWith('follow')) page.followNumber(BODY_NAMES, Number(name.slice(6)));
      else {
        const rate = clock.rate * (name === 'faster' ? KEY_FACTOR : 1 / KEY_FACTOR);
        clock.rate = Math.min(RATES.max, Math.max(RATES.min, rate));
      }
    },
    release() {},
  },
  renderers: {
    three: {
      label: '3D',
      dimensions: 3,
      open: async (context) => (await import('./view.ts')).openView(context, page),
    },
  },
  help: [
    ['Tap a body, 0–9', 'follow it: 0 is the Sun, 3 the Earth, 9 Neptune'],
    ['Drag, wheel, pinch', 'turn the view and zoom'],
    ['Arrow keys', 'time runs twice as fast, or half as fast', 'keyboard'],
    ['Missions', 'launch a probe: set its change of velocity, and let planets pull it'],
    ['Forward', 'along the orbit: more of it leads farther from the Sun on the other side'],
    ['Outward, north', 'away from the Sun, and out of the plane'],
    ['Score', 'less fuel and fewer days give more points'],
  ],
});
