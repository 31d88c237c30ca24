/** A number the player may change. */
export interface NumberSetting {
  readonly kind: 'number';
  /** What the panel calls it. */
  readonly label: string;
  /** SI unit; empty for a pure number. */
  readonly unit: string;
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  readonly integer: boolean;
  /** Distance between two places of the slider; default a thousandth of the range, or one where whole. */
  readonly step?: number;
  /** `log` gives every factor of ten the same length of slider; `min` must then be above zero. */
  readonly scale?: 'linear' | 'log';
  /** One line for whoever rests the pointer on it. */
  readonly about?: string;
}

/** Something that is on or off. */
export interface SwitchSetting {
  readonly kind: 'switch';
  readonly label: string;
  readonly initial: boolean;
  /** A key that toggles it, such as `t`. */
  readonly key?: string;
  readonly about?: string;
}

/** One of several words. */
export interface ChoiceSetting {
  readonly kind: 'choice';
  readonly label: string;
  readonly initial: string;
  /** The value of each choice by what the panel calls it. */
  readonly choices: Readonly<Record<string, string>>;
  readonly about?: string;
}

export type Setting = NumberSetting | SwitchSetting | ChoiceSetting;
export type Settings = Readonly<Record<string, Setting>>;
export type Value = number | boolean | string;

/** The values of a game's settings, by name. */
export type ValuesOf<S extends Settings> = {
  [Name in keyof S]: S[Name] extends NumberSetting ? number : S[Name] extends SwitchSetting ? boolean : string;
};

/** What a scene says of one of its numbers; `SceneParameter` of the scenes package is one. */
export interface ParameterLike {
  readonly about?: string;
  readonly unit: string;
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  readonly integer?: boolean;
}

/** A setting for a parameter of a scene; `own` says what differs, and what only a panel knows. */
export function numberSetting(
  parameter: ParameterLike,
  own: Partial<Omit<NumberSetting, 'kind'>> & { readonly label: string },
): NumberSetting {
  return { kind: 'number', integer: false, ...parameter, ...own };
}

export function switchSetting(label: string, initial: boolean, own: { key?: string; about?: string } = {}) {
  return { kind: 'switch', label, initial, ...own } as const satisfies SwitchSetting;
}

/** The values a game starts with when nobody says otherwise. */
export function initialValues<S extends Settings>(settings: S): ValuesOf<S> {
  const names = Object.keys(settings);
  // Nothing first: in a field that has held something else, a number is read without making another, as snapshots do.
  const values: Record<string, unknown> = Object.fromEntries(names.map((name) => [name, undefined]));
  for (const name of names) values[name] = settings[name].initial;
  return values as ValuesOf<S>;
}

/**
 * The value, if the setting takes it.
 * @throws Error with a sentence that says what it takes
 */
export function checkValue(name: string, setting: Setting, value: unknown): Value {
  const wrong = (wanted: string): never => {
    throw new Error(`${name} must be ${wanted}, but it was ${typeof value === 'string' ? `“${value}”` : value}.`);
  };
  if (setting.kind === 'switch') return typeof value === 'boolean' ? value : wrong('on or off');
  if (setting.kind === 'choice') {
    const choices = Object.values(setting.choices);
    return choices.includes(value as string) ? (value as string) : wrong(choices.join(' or '));
  }
  const { min, max, integer, unit } = setting;
  const fits = typeof value === 'number' && value >= min && value <= max && (!integer || Number.isInteger(value));
  return fits
    ? value
    : wrong(`a ${integer ? 'whole ' : ''}number from ${min} to ${max}${unit === '' ? '' : ` ${unit}`}`);
}

/** The value a word of the address bar stands for. @throws Error with a sentence that says what it takes */
export function parseValue(name: string, setting: Setting, text: string): Value {
  if (setting.kind === 'choice') return checkValue(name, setting, text);
  if (setting.kind === 'switch') {
    if (/^(1|on|true|yes|)$/i.test(text)) return true;
    if (/^(0|off|false|no)$/i.test(text)) return false;
    return checkValue(name, setting, text);
  }
  const number = text.trim() === '' ? Number.NaN : Number(text);
  return checkValue(name, setting, Number.isNaN(number) ? text : number);
}
