/** The list of bodies: how far each is from JPL's position, on the last date for which that is stored. */
import { BODY_NAMES } from '@principia/scenes';
import { LOOKS } from './bodies.ts';
import { dayText } from './dates.ts';
import type { Page } from './page.ts';
import type { SolarGame } from './sim.ts';
import { difference, lengthOf } from './vectors.ts';
import { distanceText, shareText, WORDS } from './words.ts';

export interface Accuracy {
  update(sim: SolarGame): void;
}

export function createAccuracy(parent: HTMLElement, page: Page): Accuracy {
  const card = document.createElement('details');
  card.className = 'ss-jpl';
  card.name = 'ss-list';
  card.open = innerWidth >= 760 && innerHeight >= 560;
  const rows = BODY_NAMES.map((name) => {
    const row = document.createElement('tr');
    row.innerHTML = `<td><button type="button" style="color: ${LOOKS[name].color}">${WORDS.bodies[name][0]}</button></td><td></td><td></td>`;
    row.querySelector('button')?.addEventListener('click', () => {
      page.follow = name;
    });
    const [, error, share] = row.querySelectorAll('td');
    return { name, row, error, share, text: '' };
  });
  const table = document.createElement('table');
  table.append(...rows.map(({ row }) => row));
  const summary = document.createElement('summary');
  summary.textContent = WORDS.accuracy;
  const note = document.createElement('p');
  card.append(summary, table, note);
  parent.append(card);
  let shownNote = '';
  let mission = '';
  return {
    update(sim) {
      // A mission needs the room for its path.
      if (sim.flight.mission !== mission && sim.flight.mission !== '') card.open = false;
      mission = sim.flight.mission;
      if (!card.open) return;
      for (const [i, row] of rows.entries()) {
        row.row.classList.toggle('on', page.follow === row.name);
        const error = sim.errors[i];
        // The Sun is where they are measured from; of the outer planets fewer positions are stored.
        const text = row.name === 'sun' ? '' : Number.isNaN(error) ? '–' : distanceText(error);
        if (text === row.text) continue;
        row.text = text;
        row.error.textContent = text;
        row.share.textContent = Number.isNaN(error) ? '' : shareText(error / distanceOf(sim, row.name));
      }
      const last = Math.max(0, ...sim.errorDates);
      const text = last === 0 ? WORDS.noReference : WORDS.errorsOn(dayText(last));
      if (text !== shownNote) note.textContent = text;
      shownNote = text;
    },
  };
}

function distanceOf(sim: SolarGame, name: (typeof BODY_NAMES)[number]): number {
  const centre = name === 'moon' ? 'earth' : 'sun';
  return lengthOf(difference(sim.bodyState(name).position, sim.bodyState(centre).position));
}
