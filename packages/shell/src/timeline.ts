import { element } from './element.ts';
import { inLanguage } from './language.ts';
import { words } from './words.ts';

/** What the bar shows. */
export interface RecordedTime {
  /** Number of recorded moments, and the index of the one that the world stands at. */
  readonly moments: number;
  readonly moment: number;
  /** Time of the world, s. */
  readonly time: number;
}

/** A bar below the picture, with a place for each recorded moment. */
export interface Timeline {
  /** Brings the bar up to date; call it a few times a second. */
  show(): void;
}

/**
 * @param recorded is read whenever the bar is shown
 * @param seek goes to a moment
 * @param pause pauses or resumes: the space bar, which does nothing else on the bar
 */
export function createTimeline(
  parent: HTMLElement,
  recorded: RecordedTime,
  seek: (moment: number) => void,
  pause: () => void,
): Timeline {
  const label = words().timeline;
  const range = element('input', '', { type: 'range', min: '0', max: '1', value: '1', 'aria-label': label });
  const time = element('output', '');
  parent.append(element('div', 'game-timeline', { title: label, 'data-covers': 'bottom' }, range, time));
  const now = { moments: 0, moment: 0, time: Number.NaN };
  const show = () => {
    const { moments, moment, time: seconds } = recorded;
    if (moments === now.moments && moment === now.moment && seconds === now.time) return;
    Object.assign(now, { moments, moment, time: seconds });
    const last = Math.max(1, moments - 1);
    range.max = String(last);
    range.value = String(moments > 1 ? moment : last);
    range.style.setProperty('--done', String(Number(range.value) / last));
    time.textContent = secondsText(seconds);
    range.setAttribute('aria-valuetext', time.textContent);
  };
  range.addEventListener('input', () => {
    seek(Number(range.value));
    show();
  });
  // A bar that was clicked keeps the focus, for the arrow keys.
  range.addEventListener('keydown', (event) => {
    if (event.key !== ' ' || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    pause();
  });
  return { show };
}

/** Four digits at most, of which the last one changes slowly enough to be read. */
function secondsText(time: number): string {
  const size = Math.abs(time);
  const isPlain = size === 0 || (size >= 0.01 && size < 1e6);
  const digits = size < 1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0;
  return `${inLanguage(isPlain ? time.toFixed(digits) : time.toExponential(2).replace('e+', 'e'))} s`;
}
