/** An energy in as few characters as an axis has room for. */
export function joules(value: number): string {
  const size = Math.abs(value);
  const [factor, prefix] =
    size >= 1e6 ? [1e6, 'M'] : size >= 1e3 ? [1e3, 'k'] : size >= 1 || size === 0 ? [1, ''] : [1e-3, 'm'];
  return `${Number((value / factor).toPrecision(3))} ${prefix}J`;
}
