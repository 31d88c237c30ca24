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
