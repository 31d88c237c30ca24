import { inLanguage } from '@principia/shell';

/** A number with six digits, in powers of ten only where it must be. */
export function plainNumber(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e7))
    return inLanguage(value.toExponential(2)).replace('e+', 'e').replaceAll('-', '−');
  return inLanguage(String(Number(value.toPrecision(6)))).replace('-', '−');
}

/** A fraction in per cent with two digits. */
export function percentage(fraction: number): string {
  const percent = 100 * fraction;
  if (percent === 0) return '0 %';
  return `${percent < 1e-3 ? percent.toExponential(0).replace('e-', 'e−') : inLanguage(String(Number(percent.toPrecision(2))))} %`;
}
