import { inLanguage } from './language.ts';

const PREFIXES = [
  [1e12, 'T'],
  [1e9, 'G'],
  [1e6, 'M'],
  [1e3, 'k'],
  [1, ''],
  [1e-3, 'm'],
  [1e-6, 'µ'],
  [1e-9, 'n'],
] as const;

/** Formats a number for a narrow axis: `12.3 mJ`, `5 km`. Compound units and pixels get no prefix. */
export function siNumber(value: number, unit: string): string {
  const size = Math.abs(value);
  if (size === 0 || unit === '') return `${short(value)}${unit === '' ? '' : ` ${unit}`}`;
  if (unit === 'px' || /[ /²³]/.test(unit)) return `${short(value)} ${unit}`;
  const [factor, prefix] = PREFIXES.find(([from]) => size >= from * (1 - 1e-12)) ?? [1e-9, 'n'];
  return `${short(value / factor)} ${prefix}${unit}`;
}

function short(value: number): string {
  const size = Math.abs(value);
  const isPlain = size === 0 || (size < 1e5 && size >= 1e-3);
  return inLanguage(isPlain ? String(Number(value.toPrecision(3))) : value.toExponential(1).replace('e+', 'e'));
}
