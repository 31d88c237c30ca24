/** The list of events in the sky of the Earth to come: transits, oppositions, conjunctions. A click leads to their date. */
import { type SkyEvent, SkyEventFinder, type SkyEventKind } from '@principia/scenes';
import { dayText, timeText } from './dates.ts';
import type { Page } from './page.ts';
import { DATES, type SolarGame } from './sim.ts';
import { distanceText, WORDS } from './words.ts';

export interface SkyList {
  /** Searches on for a few milliseconds while the list is open and not full; call it once a frame. */
  search(sim: SolarGame): void;
}

const GROUPS: Readonly<Record<keyof typeof WORDS.sky.groups, readonly SkyEventKind[]>> = {
  transits: ['transit'],
  oppositions: ['opposition'],
  meetings: ['meeting'],
  conjunctions: ['inferior', 'superior', 'transit'],
};

const ROWS = 8;
/** Time for the search in a frame, ms, and how far it goes at most, days. */
const BUDGET = 6;
const FARTHEST = 120 * 365.25;
/** A jump leads to this long before the event, days, at an hour a second. */
const EARLIER = 0.25;
const SLOW = 3600;

export function createSkyList(parent: HTMLElement, page: Page, present: () => SolarGame): SkyList {
  const card = document.createElement('details');
  card.className = 'ss-jpl ss-sky';
  // With one name, opening one of the lists closes the other.
  card.name = 'ss-list';
  card.innerHTML = `<summary>${WORDS.sky.title}</summary><select aria-label="${WORDS.sky.title}">${Object.entries(
    WORDS.sky.groups,
  ).map(([name, label]) => `<option value="${name}">${label}</option>`)}</select><div></div><p role="status"></p>`;
  const select = card.querySelector('select') as HTMLSelectElement;
  const list = card.querySelector('div') as HTMLElement;
  const note = card.querySelector('p') as HTMLElement;
  parent.append(card);
  const search = new Search();
  let shown = 0;
  const kinds = () => GROUPS[select.value as keyof typeof GROUPS];
  const show = () => {
    const fitting = search.events.filter(({ kind }) => kinds().includes(kind)).slice(0, ROWS);
    if (fitting.length !== shown || fitting.length === 0) {
      list.replaceChildren(...fitting.map((event) => rowOf(event, () => jump(page, present(), event))));
    }
    shown = fitting.length;
    const isDone = shown === ROWS || search.isOver;
    const text = isDone ? WORDS.sky.note : WORDS.sky.searching(dayText(search.julianDate).slice(0, 4));
    if (note.textContent !== text) note.textContent = text;
    return isDone;
  };
  const begin = () => {
    shown = -1;
    search.end();
  };
  select.addEventListener('change', begin);
  card.addEventListener('toggle', begin);
  let mission = '';
  return {
    search(sim) {
      // A mission needs the room for its path.
      if (sim.flight.mission !== mission && sim.flight.mission !== '') card.open = false;
      mission = sim.flight.mission;
      if (!card.open || sim.clock.isTravelling) return;
      search.follow(sim);
      const until = performance.now() + BUDGET;
      for (let isDone = show(); !isDone && performance.now() < until; ) {
        search.advance();
        isDone = show();
      }
    },
  };
}

/** The events from a date on, in the world of one game. */
class Search {
  events: SkyEvent[] = [];
  #finder: SkyEventFinder | undefined;
  #sim: SolarGame | undefined;
  #from = Number.NaN;

  get julianDate(): number {
    return this.#finder?.julianDate ?? Number.NaN;
  }

  get isOver(): boolean {
    return this.julianDate > Math.min(DATES.last, this.#from + FARTHEST);
  }

  end(): void {
    this.#from = Number.NaN;
  }

  /** Begins at the date of a game, unless the list begins shortly before it. */
  follow(sim: SolarGame): void {
    const { julianDate } = sim.clock;
    const next = this.events.find((event) => event.julianDate > julianDate);
    const isKnown = sim === this.#sim && julianDate >= this.#from && (next !== undefined || this.events.length === 0);
    if (isKnown) return;
    if (sim !== this.#sim) this.#finder = new SkyEventFinder(sim.system.ids.moon !== undefined);
    this.#sim = sim;
    this.#from = julianDate;
    this.events = [];
    this.#finder?.begin(julianDate, (name) => sim.bodyState(name));
  }

  advance(): void {
    this.events.push(...(this.#finder?.advance() ?? []));
  }
}

function jump(page: Page, sim: SolarGame, { julianDate }: SkyEvent): void {
  page.goTo(sim, julianDate - EARLIER);
  sim.clock.rate = SLOW;
}

function rowOf(event: SkyEvent, press: () => void): HTMLElement {
  const { kind, body, other, julianDate, separation, distance } = event;
  const row = document.createElement('button');
  row.type = 'button';
  row.addEventListener('click', press);
  const name = WORDS.bodies[body][0];
  const { sky } = WORDS;
  const angle = angleText(separation);
  const texts = {
    transit: () => sky.transit(name, angle),
    inferior: () => sky.inferior(name),
    superior: () => sky.superior(name, body === 'mercury' || body === 'venus'),
    opposition: () => sky.opposition(name, distanceText(distance)),
    meeting: () => sky.meeting(name, WORDS.bodies[other ?? 'sun'][0], angle),
  };
  const date = document.createElement('b');
  date.textContent = `${dayText(julianDate)} ${timeText(julianDate)}`;
  row.append(date, ` ${texts[kind]()}`);
  return row;
}

/** Degrees, or minutes of arc below a degree. */
function angleText(angle: number): string {
  const degrees = (angle * 180) / Math.PI;
  return degrees < 1 ? WORDS.sky.minutes(60 * degrees) : WORDS.sky.degrees(degrees);
}
