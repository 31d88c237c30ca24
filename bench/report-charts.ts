// The charts of the report as SVG text, without scripts: a <title> serves as tooltip.
import { ms } from './report-table.ts';
import { histogram, summarise } from './statistics.ts';

const WIDTH = 720;
const LEFT = 64;
const RIGHT = 12;
/** Outliers above this multiple of the median are clipped, because they would flatten the rest. */
const MAX_MEDIANS = 4;

/** Step times in order, with the median and the 99th percentile as lines; the scale ends slightly above the latter. */
export function traceChart(series: ArrayLike<number>, warmup: number): string {
  const HEIGHT = 220;
  const BOTTOM = 32;
  const { median, p99 } = summarise(series);
  const top = Math.max(Math.min(p99 * 1.15, median * MAX_MEDIANS), median * 1.5);
  const ticks = niceTicks(top, 4);
  const x = (i: number) => LEFT + ((i + 0.5) / series.length) * (WIDTH - LEFT - RIGHT);
  const y = (time: number) => 10 + (1 - Math.min(time, top) / top) * (HEIGHT - BOTTOM - 10);
  const points = Array.from(series, (time, i) => `${x(i).toFixed(1)},${y(time).toFixed(1)}`).join(' ');
  const dots = Array.from(series, (time, i) =>
    series.length <= 2000
      ? `<circle cx="${x(i).toFixed(1)}" cy="${y(time).toFixed(1)}" r="5"><title>step ${warmup + i + 1}: ${ms(time)}</title></circle>`
      : '',
  ).join('');
  return svg(HEIGHT, [
    ...ticks.map((time) => gridLine(y(time), time === 0 ? '0' : ms(time))),
    `<polyline class="trace" points="${points}"/>`,
    p99 < top ? level(y(p99), `99 % under ${ms(p99)}`) : '',
    level(y(median), `median ${ms(median)}`),
    `<g class="hover">${dots}</g>`,
    axisText(LEFT, HEIGHT - 10, 'start', `step ${warmup + 1}`),
    axisText(WIDTH - RIGHT, HEIGHT - 10, 'end', `step ${warmup + series.length}`),
  ]);
}

/** Histogram of the step times; the last bin collects all larger values. */
export function histogramChart(series: ArrayLike<number>): string {
  const HEIGHT = 200;
  const BOTTOM = 32;
  const BINS = 40;
  const { from, to, counts } = histogram(series, BINS, MAX_MEDIANS * summarise(series).median);
  const most = Math.max(...counts);
  const width = (WIDTH - LEFT - RIGHT) / BINS;
  const y = (count: number) => 10 + (1 - count / most) * (HEIGHT - BOTTOM - 10);
  const bars = counts.map((count, bin) => {
    const start = from + ((to - from) * bin) / BINS;
    const label = `${count} steps from ${ms(start)}${bin === BINS - 1 ? ' up' : ` to ${ms(start + (to - from) / BINS)}`}`;
    const left = LEFT + bin * width;
    return `<rect class="bar" x="${(left + 1).toFixed(1)}" y="${y(count).toFixed(1)}" width="${(width - 2).toFixed(1)}" height="${(HEIGHT - BOTTOM - y(count)).toFixed(1)}" rx="1"><title>${label}</title></rect>`;
  });
  return svg(HEIGHT, [
    ...niceTicks(most, 4)
      .filter((count) => Number.isInteger(count))
      .map((count) => gridLine(y(count), String(count))),
    ...bars,
    axisText(LEFT, HEIGHT - 10, 'start', ms(from)),
    axisText(WIDTH - RIGHT, HEIGHT - 10, 'end', `${ms(to)} and more`),
  ]);
}

/** Parts of a step as one bar, with labels below it. */
export function stackChart(parts: Readonly<Record<string, number>>): string {
  const busy = Object.entries(parts).filter(([, time]) => time > 0);
  const total = busy.reduce((sum, [, time]) => sum + time, 0);
  let left = 0;
  const bar = busy.map(([phase, time], i) => {
    const width = (time / total) * WIDTH;
    const rect = `<rect class="part-${i % 8}" x="${left.toFixed(1)}" y="0" width="${Math.max(0.5, width - 2).toFixed(1)}" height="36" rx="3"><title>${phase}: ${ms(time)}</title></rect>`;
    left += width;
    return rect;
  });
  const legend = busy.map(
    ([phase, time], i) =>
      `<li><i class="part-${i % 8}"></i>${phase} <b>${ms(time)}</b> <span>${((100 * time) / total).toFixed(0)} %</span></li>`,
  );
  return `${svg(36, bar)}<ul class="legend">${legend.join('')}</ul>`;
}

/** Horizontal bars with labels, ours first. */
export function barsChart(rows: readonly { name: string; value: number; note: string }[]): string {
  const ROW = 40;
  const most = Math.max(...rows.map(({ value }) => value));
  const bars = rows.map(({ name, value, note }, i) => {
    const y = i * ROW;
    const width = Math.max(2, (value / most) * (WIDTH - 240));
    return `<text class="name" x="0" y="${y + 12}">${escapeHtml(name)}</text>
<rect class="${i === 0 ? 'ours' : 'theirs'}" x="0" y="${y + 18}" width="${width.toFixed(1)}" height="14" rx="3"><title>${escapeHtml(name)}: ${ms(value)}</title></rect>
<text class="note" x="${(width + 8).toFixed(1)}" y="${y + 30}">${escapeHtml(note)}</text>`;
  });
  return svg(rows.length * ROW, bars);
}

function svg(height: number, parts: readonly string[]): string {
  return `<svg viewBox="0 0 ${WIDTH} ${height}" role="img">\n${parts.join('\n')}\n</svg>`;
}

function gridLine(y: number, label: string): string {
  return `<line class="grid" x1="${LEFT}" x2="${WIDTH - RIGHT}" y1="${y.toFixed(1)}" y2="${y.toFixed(1)}"/>${axisText(LEFT - 8, y + 4, 'end', label)}`;
}

function level(y: number, label: string): string {
  return `<line class="level" x1="${LEFT}" x2="${WIDTH - RIGHT}" y1="${y.toFixed(1)}" y2="${y.toFixed(1)}"/>
<text class="level-name" x="${WIDTH - RIGHT - 4}" y="${(y - 5).toFixed(1)}" text-anchor="end">${label}</text>`;
}

function axisText(x: number, y: number, anchor: string, text: string): string {
  return `<text class="axis" x="${x}" y="${y.toFixed(1)}" text-anchor="${anchor}">${text}</text>`;
}

/** About `count` round numbers from zero to `top`. */
function niceTicks(top: number, count: number): number[] {
  const rough = top / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const unit = ([1, 2, 5, 10].find((step) => step * power >= rough) ?? 10) * power;
  return Array.from({ length: Math.floor(top / unit) + 1 }, (_, i) => i * unit);
}

export function escapeHtml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
}
