import { element } from './element.ts';

/** The figures of a moment. */
export interface Figures {
  /** Milliseconds from picture to picture, of one step, and of handing the world to the renderer. */
  readonly frame: number;
  readonly step: number;
  readonly draw: number;
  readonly bodies: number;
  /** Contacts between bodies; undefined where the world has none to count. */
  readonly contacts: number | undefined;
  /** Simulated seconds. */
  readonly time: number;
}

/** A small table of figures. */
export interface Stats {
  show(figures: Figures): void;
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
  parent.append(element('section', 'game-card', { 'aria-label': 'Figures' }, list));
  return {
    show({ frame, step, draw, bodies, contacts, time }) {
      // Nobody sees it: no words are made.
      if (list.offsetParent === null) return;
      const texts = [milliseconds(frame), thousands(bodies), milliseconds(step)];
      texts.push(contacts === undefined ? '–' : thousands(contacts), milliseconds(draw), `${time.toFixed(1)} s`);
      for (const [i, text] of texts.entries()) if (cells[i].textContent !== text) cells[i].textContent = text;
    },
  };
}
