/**
 * Names of the columns of a plot, each with the quantity and the unit of its axis.
 * @param labels of the lines @param y label of the vertical axis @param x label of the horizontal axis, if it is not the time
 */
export function csvNames(labels: readonly string[], y: string, x?: string): string[] {
  const ofLine = (label: string) => [...(x === undefined ? [] : [`${x} (${label})`]), `${y} (${label})`];
  return ['t, s', ...labels.flatMap(ofLine)];
}
