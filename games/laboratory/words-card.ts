import { element, type GameCard } from '@principia/shell';
import type { LabRun } from './lab-run.ts';
import { isDisturbed } from './on-display.ts';
import { plotSentence } from './plot-sentence.ts';
import { WORDS, WORDS_BY_LANGUAGE } from './words.ts';

/** What examples plot has English names, and a sentence has one language. */
const SENTENCE = WORDS_BY_LANGUAGE.en;

/** Milliseconds between two announcements while the run goes on; a reader of the screen needs time to speak. */
const INTERVAL = 10_000;

/** What the picture shows, in words: beside the canvas for everyone, announced when time stands still or now and then. */
export function createWordsCard(parent: HTMLElement): GameCard<LabRun> {
  const text = element('p', 'lab-words', { lang: 'en' });
  const spoken = element('p', 'lab-spoken', { role: 'status', lang: 'en' });
  parent.append(
    element(
      'section',
      'game-card',
      { 'aria-label': WORDS.inWords },
      element('h2', '', {}, WORDS.inWords),
      text,
      spoken,
    ),
  );
  const said = { tick: -1, at: Number.NEGATIVE_INFINITY };
  let last = -1;
  return {
    show(run) {
      const words = describe(run);
      if (text.textContent !== words) text.textContent = words;
      const { tick } = run.world;
      const stands = tick === last;
      last = tick;
      if (said.tick === tick || !(stands || performance.now() - said.at > INTERVAL)) return;
      said.tick = tick;
      said.at = performance.now();
      spoken.textContent = words;
    },
  };
}

function describe(run: LabRun): string {
  const values = run.plots.map(plotSentence);
  const time = run.world.time.toFixed(1);
  if (isDisturbed(run)) return SENTENCE.after(time, [...values, SENTENCE.tookPart].join('; '));
  const states = run.checkStates().filter(({ state }) => state !== 'not applicable' && state !== 'no figure');
  const passed = states.filter(({ state }) => state === 'passed').length;
  const failed = states.filter(({ state }) => state === 'failed').length;
  const checks = `${SENTENCE.proven(passed, states.length)}${failed > 0 ? SENTENCE.off(failed) : ''}`;
  return SENTENCE.after(time, [...values, checks].join('; '));
}
