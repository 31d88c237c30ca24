/** What plots of one quantity against another draw by themselves. */
import type uPlot from 'uplot';

/** Draws an upright line over a plot where the time of the world is. @param time s; nothing is drawn if not a number */
export function drawTimeMark(chart: uPlot, time: number): void {
  if (Number.isNaN(time)) return;
  const { left, top, width, height } = chart.bbox;
  const x = Math.round(chart.valToPos(time, 'x', true));
  if (!(x >= left && x <= left + width)) return;
  const { ctx } = chart;
  ctx.fillStyle = '#ffffff99';
  ctx.fillRect(x, top, Math.max(1, Math.round(devicePixelRatio)), height);
}

const HALF_PIXEL = 0.5;
/** Radius of a dot, CSS pixels. */
const DOT_RADIUS = 4;

/** Draws a dot at the point (x, y) of a plot. */
export function drawDot({ ctx, valToPos }: uPlot, x: number, y: number, color: string): void {
  ctx.fillStyle = color;
  ctx.beginPath();
  ctx.arc(valToPos(x, 'x', true), valToPos(y, 'y', true), DOT_RADIUS * devicePixelRatio, 0, 2 * Math.PI);
  ctx.fill();
}

/**
 * Joins the points of a series in the order of time, where uPlot itself would sort them: the `paths` of a series in mode 2,
 * whose data are `[null, [xs, ys], …]`.
 */
export function drawPath(chart: uPlot, series: number): null {
  const [xs, ys] = (chart.data as unknown as [null, ...[number[], number[]][]])[series] as [number[], number[]];
  const { ctx } = chart;
  const { left, top, width, height } = chart.bbox;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, height);
  ctx.clip();
  ctx.beginPath();
  let [lastX, lastY] = [Number.NaN, Number.NaN];
  for (let i = 0; i < xs.length; i++) {
    const x = chart.valToPos(xs[i], 'x', true);
    const y = chart.valToPos(ys[i], 'y', true);
    // There are rows for each step, and nobody sees half a pixel.
    if (Math.abs(x - lastX) < HALF_PIXEL && Math.abs(y - lastY) < HALF_PIXEL) continue;
    ctx.lineTo(x, y);
    lastX = x;
    lastY = y;
  }
  const stroke = chart.series[series].stroke as unknown;
  ctx.strokeStyle = typeof stroke === 'function' ? stroke(chart, series) : String(stroke);
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.stroke();
  ctx.restore();
  return null;
}
