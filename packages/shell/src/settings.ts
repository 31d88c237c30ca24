import { words } from './words.ts';

/** A numeric setting. */
export interface NumberSetting {
  /** Says that it is a number. */
  readonly kind: 'number';
  /** Label in the panel. */
  readonly label: string;
  /** SI unit; empty for a dimensionless number. */
  readonly unit: string;
  /** The default value, from `min` to `max`. */
  readonly initial: number;
  /** The least value. */
  readonly min: number;
  /** The greatest value. Where it is a getter, the panel follows it. */
  readonly max: number;
  /** Whether only integers are allowed. */
  readonly integer: boolean;
  /** Step of the slider; default about a hundredth of the range, or 1 for integers. */
  readonly step?: number;
  /** `log` selects a logarithmic slider; `min` must then be positive. Default `linear`. */
  readonly scale?: 'linear' | 'log';
  /** Values with names, offered as a list below the slider. Default none. */
  readonly presets?: Readonly<Record<string, number>>;
  /** Tooltip of one line. Default none. */
  readonly about?: string;
  /** Language of label and tooltip. Default that of the page. */
  readonly lang?: string;
}

/** A setting that is on or off. */
export interface SwitchSetting {
  /** Says that it is a switch. */
  readonly kind: 'switch';
  /** Label in the panel. */
  readonly label: string;
  /** Whether it is on at first. */
  readonly initial: boolean;
  /** A key that toggles the setting, such as `t`. Default none. */
  readonly key?: string;
  /** Tooltip of one line. Default none. */
  readonly about?: string;
  /** Language of label and tooltip. Default that of the page. */
  readonly lang?: string;
}

/** A choice among several words. */
export interface ChoiceSetting {
  /** Says that it is a choice. */
  readonly kind: 'choice';
  /** Label in the panel. */
  readonly label: string;
  /** The default value, one of those in `choices`. */
  readonly initial: string;
  /** Values of the choices by their labels in the panel. */
  readonly choices: Readonly<Record<string, string>>;
  /** Tooltip of one line. Default none. */
  readonly about?: string;
  /** Language of label and tooltip. Default that of the page. */
  readonly lang?: string;
}

/** A setting of a game. */
export type Setting = NumberSetting | SwitchSetting | ChoiceSetting;
/** The settings of a game, by name. */
export type Settings = Readonly<Record<string, Setting>>;
/** The value of a setting: of a number, of a switch, of a choice. */
export type Value = number | boolean | string;

/** The values of a game's settings, by name. */
export type ValuesOf<S extends Settings> = {
  [Name in keyof S]: S[Name] extends NumberSetting ? number : S[Name] extends SwitchSetting ? boolean : string;
};

/** The description of a scene parameter; `SceneParameter` of the scenes package fits. */
export interface ParameterLike {
  /** What it is, for the tooltip. Default none. */
  readonly about?: string;
  /** SI unit; empty for a dimensionless number. */
  readonly unit: string;
  /** The default value. */
  readonly initial: number;
  /** The least value. */
  readonly min: number;
  /** The greatest value. */
  readonly max: number;
  /** Whether only integers are allowed. Default false. */
  readonly integer?: boolean;
}

/** Creates a setting from a scene parameter; `own` overrides its fields and adds those of the panel. */
export function numberSetting(
  parameter: ParameterLike,
  own: Partial<Omit<NumberSetting, 'kind'>> & { readonly label: string },
): NumberSetting {
  return { kind: 'number', integer: false, ...parameter, ...own };
}

/** Creates a setting that is on or off. @param own its key and its tooltip; default none */
export function switchSetting(label: string, initial: boolean, own: { key?: string; about?: string } = {}) {
  return { kind: 'switch', label, initial, ...own } as const satisfies SwitchSetting;
}

/** The default values of a game's settings. */
export function initialValues<S extends Settings>(settings: S): ValuesOf<S> {
  const names = Object.keys(settings);
  // Fields start as undefined: V8 then keeps later numbers in place, and snapshots read them without allocating.
  const values: Record<string, unknown> = Object.fromEntries(names.map((name) => [name, undefined]));
  for (const name of names) values[name] = settings[name].initial;
  return values as ValuesOf<S>;
}

/**
 * Returns the value if the setting accepts it.
 * @throws Error with a sentence that states the allowed values
 */
export function checkValue(name: string, setting: Setting, value: unknown): Value {
  const wrong = (wanted: string): never => {
    const was = typeof value === 'string' ? words().address.quoted(value) : String(value);
    throw new Error(words().address.wrong(name, wanted, was));
  };
  if (setting.kind === 'switch') return typeof value === 'boolean' ? value : wrong(words().address.onOrOff);
  if (setting.kind === 'choice') {
    const choices = Object.values(setting.choices);
    return choices.includes(value as string) ? (value as string) : wrong(choices.join(words().or));
  }
  const { min, max, integer, unit } = setting;
  const fits = typeof value === 'number' && value >= min && value <= max && (!integer || Number.isInteger(value));
  return fits ? value : wrong(min === max ? String(min) : words().address.range(integer, min, max, unit));
}

/** Parses a value from the address. @throws Error with a sentence that states the allowed values */
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
