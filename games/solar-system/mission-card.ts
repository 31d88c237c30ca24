/** The card of the mission: what to do, the change of velocity to set, and what will come of it. */
import type { BodyName } from '@principia/scenes';
import { element, inLanguage, speakNumbers, type ViewContext } from '@principia/shell';
import { indexOf, rounded } from './flight.ts';
import { type FlightPlan, MAX_WAIT } from './flight-plan.ts';
import { MISSIONS, type Mission, PASS } from './missions.ts';
import type { Page } from './page.ts';
import { flightLines, isOver, scoreOf, titleOf } from './report.ts';
import type { Settings } from './settings.ts';
import type { SolarGame } from './sim.ts';
import { DAY } from './solar-clock.ts';
import { TRACKED } from './track.ts';
import { difference, lengthOf } from './vectors.ts';
import { distanceText, speedText, WORDS } from './words.ts';

export interface MissionCard {
  readonly element: HTMLElement;
  update(sim: SolarGame): void;
}

/** Real seconds that a flight of the longest duration takes. */
const FLIGHT_SECONDS = 40;

export function createMissionCard(
  context: ViewContext<Settings, SolarGame>,
  page: Page,
  plan: FlightPlan,
): MissionCard {
  const element = document.createElement('div');
  let shown = '';
  let parts: Parts | undefined;
  const build = (sim: SolarGame) => {
    const { phase } = sim.flight;
    const { mission } = sim;
    parts = undefined;
    if (mission === undefined) {
      element.className = 'ss-menu';
      element.replaceChildren(
        paragraph('ss-hint', WORDS.welcome),
        ...MISSIONS.map((each) => button(WORDS.missions[each.id].title, () => page.startMission(context.sim(), each))),
      );
      return;
    }
    element.className = 'ss-card';
    const isWatched = sim.isReplay || isOver(sim);
    parts = isWatched
      ? watchedParts(context, page, mission, sim.isReplay)
      : controlParts(context, page, plan, mission, phase === 'ready');
    element.replaceChildren(...parts.elements);
  };
  return {
    element,
    update(sim) {
      const { phase, mission } = sim.flight;
      const state = `${mission} ${phase} ${sim.isReplay}`;
      if (state !== shown) build(sim);
      shown = state;
      // A paused page has not yet arrived where it begins.
      element.hidden = sim.clock.daysToTravel > 0 && phase === 'none';
      parts?.update(sim);
    },
  };
}

interface Parts {
  readonly elements: readonly HTMLElement[];
  update(sim: SolarGame): void;
}

/** A flight that is repeated, or over. */
function watchedParts(
  context: ViewContext<Settings, SolarGame>,
  page: Page,
  mission: Mission,
  isReplay: boolean,
): Parts {
  const text = paragraph('ss-say');
  const again = button(
    isReplay ? WORDS.tryIt : WORDS.flyAgain,
    () => page.startMission(context.sim(), mission),
    'ss-go',
  );
  return {
    elements: [heading(context, page, mission), text, row(again)],
    update(sim) {
      const [spent, nearest] = flightLines(sim, mission);
      const end = isOver(sim) ? `${titleOf(sim)} – ${WORDS.points(scoreOf(sim))}. ` : '';
      say(text, `${end}${spent}. ${nearest}.`);
    },
  };
}

function controlParts(
  context: ViewContext<Settings, SolarGame>,
  page: Page,
  plan: FlightPlan,
  mission: Mission,
  isReady: boolean,
): Parts {
  const words = WORDS.missions[mission.id];
  const goal = paragraph('ss-goal', words.goal);
  if (isReady) goal.append(element('span', '', {}, ` ${words.hint}`));
  const sliders = [WORDS.forward, WORDS.outward, WORDS.north].map((name, i) =>
    createSlider(name, mission.budget, (value) => {
      plan.set(plan.amounts.map((amount, axis) => (axis === i ? value : amount)));
    }),
  );
  const slides = document.createElement('div');
  slides.className = 'ss-slides';
  slides.append(...sliders.map(({ element }) => element));
  const [outlook, warning] = [paragraph('ss-say'), paragraph('ss-bad')];
  outlook.setAttribute('role', 'status');
  const go = button(isReady ? WORDS.launch : WORDS.burn, () => fire(context.sim(), page, plan, mission), 'ss-go');
  const aims = aimButtons(context, plan, mission);
  const waits = isReady
    ? [1, 10].map((days) =>
        button(WORDS.wait(days), () => {
          const sim = context.sim();
          if ((sim.clock.now - sim.flight.start) / DAY + days <= MAX_WAIT) sim.wait(days);
          plan.set(plan.amounts);
        }),
      )
    : [];
  return {
    elements: [heading(context, page, mission), goal, slides, outlook, warning, row(go, ...aims, ...waits)],
    update(sim) {
      for (const [i, slider] of sliders.entries()) slider.show(plan.amounts[i]);
      // On the way to the date of the launch there is nothing to see ahead.
      say(outlook, sim.clock.isTravelling ? '' : outlookOf(sim, plan, mission, isReady));
      const isTooMuch = !sim.canBurn(plan.size) && plan.size > 0;
      const canHelp = plan.canHelp(sim, mission);
      for (const aim of aims) aim.disabled = !canHelp;
      go.disabled = isTooMuch || plan.size === 0 || plan.aimState === 'running' || sim.clock.isTravelling;
      say(
        warning,
        isTooMuch
          ? WORDS.overBudget(inLanguage(String(mission.budget)))
          : plan.aimState === 'failed'
            ? WORDS.aimFailed
            : '',
      );
      warning.hidden = warning.textContent === '';
    },
  };
}

function fire(sim: SolarGame, page: Page, plan: FlightPlan, mission: Mission): void {
  const isLaunch = sim.flight.phase === 'ready';
  const [forward, outward, north] = plan.amounts;
  if (!sim.burn(forward, outward, north)) return;
  page.rememberFlight(sim);
  plan.set([0, 0, 0]);
  if (isLaunch) sim.clock.rate = (mission.maxDays * DAY) / FLIGHT_SECONDS;
}

function aimButtons(
  context: ViewContext<Settings, SolarGame>,
  plan: FlightPlan,
  mission: Mission,
): HTMLButtonElement[] {
  const { via, target, reach } = mission;
  const buttons: HTMLButtonElement[] = [];
  if (via !== undefined) {
    const ahead = PASS[via] ?? 0;
    const text = ahead > 0 ? WORDS.passBefore(nameOf(via)) : WORDS.passBehind(nameOf(via));
    buttons.push(button(text, () => plan.aim(context.sim(), via, ahead, 0.15 * Math.abs(ahead))));
  }
  buttons.push(button(WORDS.reach(nameOf(target)), () => plan.aim(context.sim(), target, 0, 0.4 * reach)));
  return buttons;
}

const nameOf = (name: BodyName): string => WORDS.bodies[name][0];

/** What the prepared burn leads to, or where the probe is. */
function outlookOf(sim: SolarGame, plan: FlightPlan, mission: Mission, isReady: boolean): string {
  if (plan.aimState === 'running') return WORDS.aiming;
  const { flight, clock } = sim;
  const { via, target } = mission;
  const speed = speedText(flight.deltaV + (isReady ? plan.size : 0));
  const spent = `${WORDS.spent(speed, inLanguage(String(mission.budget)))}.`;
  const start = isReady ? clock.now : flight.launch;
  const dateOf = (name: BodyName) => plan.closestAt[TRACKED.indexOf(name)];
  const pass = (name: BodyName) =>
    WORDS.pass(
      WORDS.bodies[name][1],
      distanceText(plan.closest[TRACKED.indexOf(name)]),
      Math.round((dateOf(name) - start) / DAY),
    );
  const isPast =
    via !== undefined && !isReady && flight.closestAt[indexOf(via)] < clock.now - DAY && dateOf(via) < clock.now + DAY;
  const ahead = via === undefined || isPast ? pass(target) : WORDS.both(pass(via), pass(target));
  const first = nameOf(via ?? target);
  const help = plan.canHelp(sim, mission) ? '' : ` ${WORDS.helpFrom(first, mission.helpFrom / 1e6)}`;
  if (isReady) return `${WORDS.willPass(ahead)} ${spent}${help}`;
  const now = distanceText(lengthOf(difference(sim.probeState().position, sim.bodyState(target).position)));
  const past = isPast ? `${WORDS.passed(nameOf(via), distanceText(flight.closest[indexOf(via)]))} ` : '';
  const day = WORDS.flying(Math.floor(sim.flightDays()), mission.maxDays, now, nameOf(target));
  return `${day} ${past}${WORDS.laterPasses(ahead)} ${spent}${help}`;
}

function heading(context: ViewContext<Settings, SolarGame>, page: Page, mission: Mission): HTMLElement {
  const element = document.createElement('h2');
  element.append(
    WORDS.missions[mission.id].title,
    button(WORDS.endMission, () => page.endMission(context.sim()), 'ss-end'),
  );
  return element;
}

function createSlider(name: string, budget: number, set: (value: number) => void) {
  const element = document.createElement('label');
  element.className = 'ss-slide';
  const limits = `min="${-budget}" max="${budget}"`;
  element.innerHTML = `<span>${name}</span><input type="range" ${limits} step="0.01" aria-label="${name}, km/s"><input class="ss-number" aria-label="${name}, km/s">`;
  const [slider, number] = element.querySelectorAll('input');
  speakNumbers(number, { min: -budget });
  for (const input of [slider, number]) {
    input.addEventListener('input', () => {
      const value = input.value.trim() === '' ? Number.NaN : Number(input.value);
      if (Number.isFinite(value)) set(Math.max(-budget, Math.min(budget, value)));
    });
  }
  let shown = Number.NaN;
  return {
    element,
    show(value: number) {
      if (value === shown) return;
      shown = value;
      slider.value = String(value);
      if (document.activeElement !== number) number.value = rounded(value).toFixed(3);
    },
  };
}

function button(text: string, press: () => void, className = ''): HTMLButtonElement {
  const element = document.createElement('button');
  element.type = 'button';
  element.className = className;
  element.textContent = text;
  element.addEventListener('click', press);
  return element;
}

const paragraph = (className: string, text = '') => element('p', className, {}, text);

function row(...parts: HTMLElement[]): HTMLElement {
  const element = document.createElement('div');
  element.className = 'ss-row';
  element.append(...parts);
  return element;
}

function say(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
