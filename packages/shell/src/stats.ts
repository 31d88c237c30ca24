import { element } from './element.ts';

/** The statistics of one update. */
export interface Statistics {
  /** Milliseconds per frame, per step, and per submission of the world to the renderer. */
  readonly frame: number;
  readonly step: number;
  readonly draw: number;
  readonly bodies: number;
  /** Contacts between bodies; undefined where the world does not count them. */
  readonly contacts: number | undefined;
  /** Simulated seconds. */
  readonly time: number;
}

/** A small table of statistics. */
export interface Stats {
  show(statistics: Statistics): void;
}

const thousands = new Intl.NumberFormat('en').format;
const milliseconds = (value: number) => `${value < 9.95 ? value.toFixed(value < 0.995 ? 2 : 1) : value.toFixed(0)} ms`;

export function createStats(parent: HTMLElement): Stats {
  const list = element('dl', 'game-stats');
  const cells = ['frame', 'bodies', 'step', 'contacts', 'draw', 'time'].map((label) => {
    const cell = element('dd', '', {}, '–');
    list.append(element('dt', '', {}, label), cell);
    return cell;
  });
  parent.append(element('section', 'game-card', { 'aria-label': 'Statistics' }, list));
  return {
    show({ frame, step, draw, bodies, contacts, time }) {
      // Texts are not made while the table is hidden.
      if (list.offsetParent === null) return;
      const texts = [milliseconds(frame), thousands(bodies), milliseconds(step)];
      texts.push(contacts === undefined ? '–' : thousands(contacts), milliseconds(draw), `${time.toFixed(1)} s`);
      for (const [i, text] of texts.entries()) if (cells[i].textContent !== text) cells[i].textContent = text;
    },
  };
}
