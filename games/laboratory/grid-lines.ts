/** Round positions of grid lines from `min` to `max`, about `count` of them. */
export function gridLines(min: number, max: number, step?: number, count = 8): number[] {
  const raw = (max - min) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const round = ([1, 2, 5].find((factor) => factor * power >= raw) ?? 10) * power;
  const spacing = step ?? round;
  const lines: number[] = [];
  for (let i = Math.ceil(min / spacing - 1e-9); i * spacing <= max + 1e-9 * spacing; i++) {
    lines.push(Number((i * spacing).toPrecision(12)));
  }
  return lines;
}
