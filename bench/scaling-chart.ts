// The cost of a step against the count on logarithmic axes, as SVG text without a style sheet.
export interface ScalingLine {
  readonly name: string;
  readonly points: readonly { readonly count: number; readonly msPerStep: number }[];
}

const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [720, 420, 72, 560, 20, 380];
const COLOURS = ['#2563eb', '#d97706', '#0d9488', '#9333ea', '#dc2626'];

/** Each line with its name at its end; the dashed line grows as N log N from the first point of the first line. */
export function scalingChart(lines: readonly ScalingLine[]): string {
  const all = lines.flatMap(({ points }) => points);
  const [left, right] = decades(all.map(({ count }) => count));
  const [low, high] = decades(all.map(({ msPerStep }) => msPerStep));
  const x = (count: number) => LEFT + ((Math.log10(count) - left) / (right - left)) * (RIGHT - LEFT);
  const y = (ms: number) => BOTTOM - ((Math.log10(ms) - low) / (high - low)) * (BOTTOM - TOP);
  const place = (count: number, ms: number) => `${x(count).toFixed(1)},${y(ms).toFixed(1)}`;
  const grid: string[] = [];
  for (let power = left; power <= right; power++) {
    grid.push(rule(x(10 ** power), TOP, x(10 ** power), BOTTOM));
    grid.push(label(x(10 ** power), BOTTOM + 20, (10 ** power).toLocaleString('en'), 'middle'));
  }
  for (let power = low; power <= high; power++) {
    grid.push(rule(LEFT, y(10 ** power), RIGHT, y(10 ** power)));
    grid.push(label(LEFT - 8, y(10 ** power) + 4, duration(10 ** power), 'end'));
  }
  const first = lines[0].points[0];
  const guide = lines[0].points.map(({ count }) =>
    place(count, (first.msPerStep * count * Math.log(count)) / (first.count * Math.log(first.count))),
  );
  const drawn = lines.map(({ name, points }, i) => {
    const colour = COLOURS[i % COLOURS.length];
    const end = points[points.length - 1];
    const dots = points.map(
      ({ count, msPerStep }) =>
        `<circle cx="${x(count).toFixed(1)}" cy="${y(msPerStep).toFixed(1)}" r="4" fill="${colour}"><title>${count.toLocaleString('en')}: ${msPerStep.toPrecision(3)} ms</title></circle>`,
    );
    return `<polyline fill="none" stroke="${colour}" stroke-width="2" points="${points.map(({ count, msPerStep }) => place(count, msPerStep)).join(' ')}"/>
${dots.join('')}${label(x(end.count) + 10, y(end.msPerStep) + 4, name, 'start', colour)}`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" font-family="system-ui, Helvetica, Arial, sans-serif" font-size="12">
<title>Time of a step by the number of bodies</title>
${grid.join('\n')}
<polyline fill="none" stroke="#98a2b3" stroke-width="1.5" stroke-dasharray="6 5" points="${guide.join(' ')}"><title>N log N</title></polyline>
${label(RIGHT + 10, BOTTOM, 'dashed: N log N', 'start')}
${drawn.join('\n')}
</svg>`;
}

/** Powers of ten that enclose the given numbers. */
function decades(values: readonly number[]): [number, number] {
  const logs = values.map((value) => Math.log10(value));
  const low = Math.floor(Math.min(...logs) + 1e-9);
  return [low, Math.max(low + 1, Math.ceil(Math.max(...logs) - 1e-9))];
}

function duration(ms: number): string {
  if (ms >= 1000) return `${(ms / 1000).toLocaleString('en')} s`;
  return ms >= 1 ? `${ms} ms` : `${Number((1000 * ms).toPrecision(3))} µs`;
}

function rule(x1: number, y1: number, x2: number, y2: number): string {
  return `<line stroke="#98a2b3" stroke-opacity="0.35" x1="${x1.toFixed(1)}" y1="${y1.toFixed(1)}" x2="${x2.toFixed(1)}" y2="${y2.toFixed(1)}"/>`;
}

function label(x: number, y: number, text: string, anchor: string, colour = '#667085'): string {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" text-anchor="${anchor}" style="fill:${colour}">${text}</text>`;
}
