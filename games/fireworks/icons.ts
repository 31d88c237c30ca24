/** Icons of the shells, drawn as outlines. */

const turn = (angle: number, r: number): [number, number] => [12 + r * Math.cos(angle), 12 + r * Math.sin(angle)];
const at = ([x, y]: [number, number]) => `${x.toFixed(1)} ${y.toFixed(1)}`;
const around = (count: number, draw: (angle: number, i: number) => string) =>
  Array.from({ length: count }, (_, i) => draw((2 * Math.PI * i) / count - Math.PI / 2, i)).join('');
const dot = ([x, y]: [number, number], r: number) =>
  `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
const ray = (angle: number, from: number, to: number) => `M${at(turn(angle, from))}L${at(turn(angle, to))}`;

/** SVG path data by the index of the kind, to be stroked. */
export const SHELL_ICONS: readonly string[] = [
  around(12, (angle) => ray(angle, 4, 9.5)),
  [-7, -4.5, -1.5, 1.5, 4.5, 7].map((x) => `M12 6Q${12 + x} ${4 + Math.abs(x) / 3} ${12 + x} 20`).join(''),
  around(12, (angle) => dot(turn(angle, 8), 0.7)),
  around(7, (angle, i) => {
    const [x, y] = turn(angle, i % 2 === 0 ? 8 : 5);
    return `M${x - 2} ${y}h4M${x} ${y - 2}v4`;
  }),
  around(6, (angle) => {
    const [x, y] = turn(angle, 9.5);
    return `M12 12Q${at(turn(angle - 0.35, 7))} ${x.toFixed(1)} ${(y + 2).toFixed(1)}`;
  }),
  around(5, (angle) => `M12 12Q${at(turn(angle + 0.2, 8))} ${at(turn(angle + 1.1, 8.5))}`),
  around(4, (angle) => {
    const [x, y] = turn(angle, 7);
    return `M12 12L${at([x, y])}M${x - 2} ${y}L${x + 2} ${y}M${x} ${y - 2}L${x} ${y + 2}`;
  }),
  'M8 15Q4.5 9 8 5.5Q12 3 16 5.5Q19.5 9 16 15ZM9.5 15v2.5h5V15M12 20v1.5',
  dot([12, 12], 2) + around(5, (angle) => dot(turn(angle, 5), 0.9) + dot(turn(angle + 0.6, 9), 0.6)),
];

/** Icon of a random kind. */
export const SURPRISE_ICON = 'M8.5 9a3.5 3.5 0 1 1 5.2 3c-1.2.7-1.7 1.3-1.7 2.6M12 18.4v.4';

/** Icon of the barrage. */
export const BARRAGE_ICON =
  around(5, (angle) => dot(turn(angle, 3.5), 0.7)) +
  around(9, (angle) => dot(turn(angle + 0.3, 6.8), 0.7)) +
  around(14, (angle) => dot(turn(angle, 10), 0.7));

export function icon(path: string): string {
  return `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>`;
}
