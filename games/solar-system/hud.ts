/** The controls over the picture: date and speed of time, the errors against JPL, and the card of the mission. */
import type { ViewContext } from '@principia/shell';
import { createAccuracy } from './accuracy.ts';
import { dayText, julianDate, readDay, timeText } from './dates.ts';
import type { FlightPlan } from './flight-plan.ts';
import { HUD_STYLE } from './hud-style.ts';
import { createMissionCard } from './mission-card.ts';
import type { Page } from './page.ts';
import type { Settings } from './settings.ts';
import { DATES, type SolarGame } from './sim.ts';
import { createSkyList } from './sky-list.ts';
import type { Covered } from './solar-camera.ts';
import { RATES } from './solar-clock.ts';
import { rateText, WORDS } from './words.ts';

export interface Hud {
  /** The element for names beside bodies. */
  readonly labels: HTMLElement;
  /** What panels cover of the picture. */
  covered(): Covered;
  /** Called once a frame. */
  update(seconds: number): void;
  destroy(): void;
}

/** Seconds between two updates of the texts. */
const INTERVAL = 0.12;
const LOG_RANGE = Math.log(RATES.max / RATES.min);

export function createHud(context: ViewContext<Settings, SolarGame>, page: Page, plan: FlightPlan): Hud {
  const root = document.createElement('div');
  root.className = 'ss';
  root.innerHTML = `<style>${HUD_STYLE}</style><div class="ss-labels" data-filmed="all"></div>
<div class="ss-date" data-filmed><b></b><span></span><em role="status"></em>
<div class="ss-pick"><input type="date" aria-label="${WORDS.date}" title="${WORDS.goToDate}" min="${dayText(DATES.first)}" max="${dayText(DATES.last)}">
<button type="button">${WORDS.today}</button></div></div>
<div class="ss-foot"><div class="ss-time"><span>${WORDS.slowest}</span><input type="range" min="0" max="1" step="0.002" aria-label="${WORDS.timeSpeed}">
<span>${WORDS.fastest}</span></div></div>`;
  context.element.append(root);
  const find = <E extends HTMLElement>(selector: string) => root.querySelector(selector) as E;
  const foot = find('.ss-foot');
  const accuracy = createAccuracy(find('.ss-date'), page);
  const sky = createSkyList(find('.ss-date'), page, context.sim);
  const card = createMissionCard(context, page, plan);
  foot.prepend(card.element);
  const time = createTimeControls(find, context, page);
  let since = INTERVAL;
  let updates = 0;
  const covered = { left: 0, right: 0, bottom: 0 };
  const showCovered = () => {
    const { offsetWidth, offsetHeight } = root;
    const top = foot.offsetTop;
    const box = card.element.getBoundingClientRect();
    // On a wide, low window the card stands at the side.
    const isBeside = box.height > 0 && getComputedStyle(card.element).position === 'fixed';
    // There the lists at the left, one below the other, reach down to where the planets are.
    covered.left = isBeside ? find('.ss-jpl').getBoundingClientRect().right : 0;
    covered.right = isBeside ? offsetWidth - box.left : 0;
    covered.bottom = isBeside ? 0 : offsetHeight - Math.min(top, isBeside ? top : box.height > 0 ? box.top : top);
  };
  if (page.problems.length > 0) context.showMessage(page.problems.join('\n'));
  page.problems = [];
  return {
    labels: find('.ss-labels'),
    covered: () => covered,
    update(seconds) {
      sky.search(context.sim());
      since += seconds;
      if (since < INTERVAL) return;
      since = 0;
      const sim = context.sim();
      time.update(sim);
      accuracy.update(sim);
      card.update(sim);
      // Reading the layout costs a millisecond.
      if (updates++ % 4 === 0) showCovered();
    },
    destroy: () => {
      time.destroy();
      root.remove();
    },
  };
}

function createTimeControls(
  find: <E extends HTMLElement>(selector: string) => E,
  context: ViewContext<Settings, SolarGame>,
  page: Page,
) {
  const [date, rate, note] = [find('.ss-date b'), find('.ss-date > span'), find('.ss-date > em')];
  const slider = find<HTMLInputElement>('.ss-time input');
  const picker = find<HTMLInputElement>('.ss-pick input');
  slider.addEventListener('input', () => {
    context.sim().clock.rate = RATES.min * Math.exp(slider.valueAsNumber * LOG_RANGE);
  });
  picker.addEventListener('change', () => {
    const chosen = readDay(picker.value);
    if (chosen !== undefined) page.goTo(context.sim(), chosen);
  });
  find('.ss-pick button').addEventListener('click', () => {
    const now = new Date();
    page.goTo(context.sim(), julianDate(now.getUTCFullYear(), now.getUTCMonth() + 1, now.getUTCDate()));
  });
  const shown = { date: '', rate: '', note: '', slider: -1 };
  const stop = () => slider.blur();
  slider.addEventListener('pointerup', stop);
  return {
    update({ clock, flight }: SolarGame) {
      const day = `${dayText(clock.julianDate)}<small>${timeText(clock.julianDate)}</small>`;
      if (day !== shown.date) {
        date.innerHTML = day;
        if (document.activeElement !== picker) picker.value = dayText(clock.julianDate);
      }
      shown.date = day;
      const isWaiting = flight.phase !== 'none' && flight.phase !== 'flying';
      const isLimited = clock.limit !== 'none';
      const speed =
        clock.daysToTravel > 0
          ? WORDS.travelling(Math.ceil(clock.daysToTravel / 365.25))
          : rateText(isWaiting ? 0 : isLimited ? clock.actualRate : clock.rate);
      if (speed !== shown.rate) rate.textContent = speed;
      shown.rate = speed;
      const text = WORDS.limits[clock.limit];
      if (text !== shown.note) note.textContent = text;
      shown.note = text;
      const place = Math.log(clock.rate / RATES.min) / LOG_RANGE;
      if (Math.abs(place - shown.slider) > 1e-4) slider.value = String(place);
      shown.slider = place;
    },
    destroy() {},
  };
}
