/** The solar system as JPL knows it, and missions to fly in it, drawn by three.js. */
import { BODY_NAMES } from '@principia/scenes';
import { followPastedLinks, helpLines, startGame } from '@principia/shell';
import { Page } from './page.ts';
import { outcomeOf, reportState } from './report.ts';
import { settings } from './settings.ts';
import { createGame } from './sim.ts';
import { RATES } from './solar-clock.ts';
import { WORDS } from './words.ts';

document.title = WORDS.title;
const page = new Page(location.hash);
followPastedLinks();

/** The world's masses are G m in km³/s², its lengths km; momenta and energies have the factor G as well. */
const UNITS = {
  m: 'km',
  'm/s': 'km/s',
  kg: 'km³/s²',
  'kg m/s': 'km⁴/s³',
  'kg m²/s': 'km⁵/s³',
  J: 'km⁵/s⁴',
};

/** Factor by which an arrow key changes the speed of time. */
const KEY_FACTOR = 2;

const digits = BODY_NAMES.slice(0, 10).map(
  (_, i) => [`follow ${i}`, { label: '', keys: [String(i)], touch: false }] as const,
);

startGame({
  title: WORDS.title,
  scoresName: 'Solar system',
  home: '../index.html',
  settings,
  units: UNITS,
  create: ({ values }) => createGame({ values, opening: page.opening }),
  apply(sim, name) {
    if (name !== 'moon') return true;
    page.keepDate(sim);
    return false;
  },
  replay: (sim) => sim.again(),
  outcome: outcomeOf,
  attempt: ({ missionsBegun }) => missionsBegun,
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
  help: helpLines(WORDS.help, ['time']),
});
