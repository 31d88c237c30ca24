/** The controls of the reader's plot: what is plotted, of which body, and against what. */
import type { PhysicsWorld } from '@principia/physics';
import { element } from './element.ts';
import type { PlotChoice } from './plot-choice.ts';
import { isCompound } from './plot-options.ts';
import {
  columnsInUse,
  type OwnQuantities,
  type PathChoice,
  type PlotSource,
  quantitySource,
  sourceOf,
  totalsOf,
} from './plot-sources.ts';
import { siNumber } from './si-number.ts';
import { words } from './words.ts';

const ANY = 'Any value';
const PLOTS = ['Energy', 'Momentum', 'Angular momentum'] as const;
/** Value of the horizontal axis over time. */
const TIME = '';

/** The controls and their card. */
export class PlotControls {
  readonly card: HTMLElement;
  readonly #own: OwnQuantities;
  readonly #choice: HTMLSelectElement;
  readonly #column = select(words().value, []);
  readonly #body = element('input', '', {
    type: 'number',
    min: '0',
    step: '1',
    value: '0',
    'aria-label': words().bodyTitle,
  });
  readonly #against = select(words().againstHint, [[TIME, words().againstTime]]);
  readonly #which: HTMLElement;
  readonly #names = element('span', '');
  readonly #every = element('small', '', { title: words().plotEvery });

  /** @param own quantities of the game's own @param save hands the numbers to the reader */
  constructor(
    parent: HTMLElement,
    own: OwnQuantities,
    onChange: () => void,
    choose: (kind: 'path' | 'phase') => void,
    save: () => void,
  ) {
    this.#own = own;
    // A quantity of the game's takes the place of the one that is called as it.
    const options = new Map(PLOTS.map((name) => [words().plots[name], this.#ownFor(name)]));
    for (const [name, label] of this.#ownOptions()) options.set(label, name);
    this.#choice = select(words().plot, [
      ...[...options].map(([label, name]) => [name, label] as const),
      [ANY, words().plots[ANY]],
    ]);
    const { plot, body, bodyHint, against, path, pathHint, phasePortrait, phaseHint, saveNumbers } = words();
    const label = element('label', '', { title: bodyHint }, `${body} `, this.#body);
    this.#which = element('div', 'game-plot-column', {}, this.#column, label);
    const axis = element('label', 'game-plot-column', { title: words().againstHint }, `${against} `, this.#against);
    const buttons = element(
      'div',
      'game-plot-buttons',
      {},
      button(path, pathHint, () => choose('path')),
      button(phasePortrait, phaseHint, () => choose('phase')),
      button('CSV', saveNumbers, save),
    );
    const heading = element('h2', '', {}, this.#choice, this.#every, this.#names);
    this.card = element('section', 'game-card', { 'aria-label': plot }, heading, this.#which, axis, buttons);
    parent.append(this.card);
    for (const control of [this.#choice, this.#column, this.#body, this.#against]) {
      control.addEventListener('change', onChange);
    }
  }

  /** Whether the horizontal axis is another quantity than the time. */
  get isPath(): boolean {
    return this.#against.value !== TIME;
  }

  /** Name of what is plotted: a column, or a total in the language of the page. */
  get chosen(): string {
    const { value } = this.#choice;
    if (value === ANY) return this.#column.value;
    return this.#own[value]?.label ?? words().plots[value as (typeof PLOTS)[number]];
  }

  /** Shows the next plot; hides the card after the last one. */
  next(): void {
    const { length } = this.#choice.options;
    const at = this.card.hidden ? 0 : this.#choice.selectedIndex + 1;
    this.card.hidden = at === length;
    this.#choice.selectedIndex = at % length;
  }

  /** Chooses one column against another. */
  choose({ y, x, body }: PathChoice): void {
    this.choice = { what: y, against: x, body };
  }

  /** What is chosen, by the names that the source has. */
  get choice(): PlotChoice {
    const { value } = this.#choice;
    return { what: value === ANY ? this.#column.value : value, against: this.#against.value, body: this.body };
  }

  set choice({ what, against, body }: PlotChoice) {
    const isColumn = what.includes('.');
    this.#choice.value = isColumn ? ANY : this.#ownFor(what);
    if (isColumn) setValue(this.#column, what);
    setValue(this.#against, against);
    this.#body.value = String(body);
  }

  /** Number of the chosen body, or 0 for all. */
  get body(): number {
    const body = Number(this.#body.value);
    return Number.isInteger(body) && body > 0 ? body : 0;
  }

  /** Offers what the world has, and reads what is chosen: the lines, and the quantity along the horizontal axis. */
  read(world: PhysicsWorld | undefined): { source: PlotSource; against: PlotSource | undefined } {
    const isColumn = this.#choice.value === ANY;
    this.#which.hidden = !isColumn && !this.#against.value.includes('.');
    this.#column.hidden = !isColumn;
    const dimensions = world?.dimensions ?? 2;
    if (world !== undefined) this.#offer(world);
    const { body } = this;
    return {
      source: sourceOf(isColumn ? this.#column.value || 'Energy' : this.#choice.value, body, dimensions, this.#own),
      against: this.isPath ? quantitySource(this.#against.value, body, dimensions, this.#own) : undefined,
    };
  }

  /** Says how far apart rows are where they are fewer than steps. @param interval s; 0 says nothing */
  showInterval(interval: number): void {
    this.#every.textContent = interval === 0 ? '' : `Δt ${siNumber(interval, 's')}`;
  }

  /** The quantities of the game's own with their names on the page. */
  #ownOptions(): Options {
    return Object.entries(this.#own).map(([name, { label }]) => [name, label] as const);
  }

  /** The name of the game's own quantity that is called as a total, or else the total itself. */
  #ownFor(total: string): string {
    const { plots } = words();
    const label = (plots as Readonly<Record<string, string>>)[total];
    return this.#ownOptions().find(([, own]) => own === label)?.[0] ?? total;
  }

  #offer(world: PhysicsWorld): void {
    const columns = columnsInUse(world).map(({ component, field }) => `${component}.${field}`);
    fill(this.#column, columns, []);
    const owns = this.#ownOptions();
    const others = [...totalsOf(world.dimensions), ...columns].filter(
      (name) => !owns.some(([, label]) => label === labelOf(name)),
    );
    fill(this.#against, others, [[TIME, words().againstTime], ...owns]);
  }

  /** Names the lines in their colours, with units that are too long for the axes. */
  showNames({ series, unit }: PlotSource, against: PlotSource | undefined, colors: readonly string[]): void {
    const lines = series.flatMap((name, i) =>
      name === '' ? [] : [element('i', '', { style: `--mark: ${colors[i]}` }, words().names[name] ?? name)],
    );
    const axes: [string, string][] =
      against === undefined
        ? [['', unit]]
        : [
            ['y: ', unit],
            ['x: ', against.unit],
          ];
    const units = axes.filter(([, each]) => isCompound(each));
    const small = units.map(([axis, each]) => element('small', '', {}, `${axis}${each}`));
    this.#names.replaceChildren(...lines, ...small);
  }
}

function button(label: string, title: string, action: () => void): HTMLButtonElement {
  const made = element('button', '', { type: 'button', title }, label);
  made.addEventListener('click', action);
  return made;
}

type Options = readonly (readonly [value: string, label: string])[];

function select(label: string, options: Options): HTMLSelectElement {
  const made = element('select', '', { 'aria-label': label });
  for (const [value, shown] of options) made.append(element('option', '', { value }, shown));
  return made;
}

/** Chooses a value, which the list then has. */
function setValue(list: HTMLSelectElement, value: string): void {
  if (![...list.options].some((option) => option.value === value)) list.append(element('option', '', { value }, value));
  list.value = value;
}

/** Offers names after some first options, and keeps the selection. */
function fill(list: HTMLSelectElement, names: readonly string[], first: Options): void {
  const chosen = list.value;
  const options = [...first, ...names.map((name) => [name, labelOf(name)] as const)];
  list.replaceChildren(...options.map(([value, label]) => element('option', '', { value }, label)));
  if (chosen !== '') setValue(list, chosen);
  else if (options.length > 0) list.value = options[0][0];
}

/** Totals have names in the language of the page; columns are called as in the source. */
function labelOf(name: string): string {
  const [plot, part] = name.split('.');
  const { plots, names } = words();
  return plot in plots ? `${plots[plot as keyof typeof plots]}, ${names[part] ?? part}` : name;
}
