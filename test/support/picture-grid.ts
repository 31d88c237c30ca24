/**
 * Pictures as text: the mean colour of each cell of a grid, and how much of the picture is bright and coloured.
 *
 * Two renderers that draw the same picture differ along edges alone, where each estimates how much of a pixel is
 * covered. With four samples a pixel either is off by at most 1/8, so they differ by 1/4; an edge that crosses a cell of
 * side s and comes back touches 2 s of its s² pixels. So cells of equal pictures differ by at most 2 s · 1/4 · 255 / s².
 */
import { PNG } from 'pngjs';

export interface PictureGrid {
  readonly columns: number;
  readonly rows: number;
  /** Pixels along a cell's edge. */
  readonly side: number;
  /** Mean red, green and blue of each cell, row by row, 0 to 255. */
  readonly cells: Float64Array;
  /** Share of pixels whose largest channel is above 150, and of those with channels farther apart than 60. */
  readonly bright: number;
  readonly colored: number;
}

const BRIGHT = 150;
const COLORED = 60;

/** @param side pixels along a cell's edge; what is left over at the right and below is left out */
export function gridOf(png: Buffer, side = 20): PictureGrid {
  const { data, width, height } = PNG.sync.read(png);
  const [columns, rows] = [Math.floor(width / side), Math.floor(height / side)];
  const cells = new Float64Array(3 * columns * rows);
  let [bright, colored] = [0, 0];
  for (let y = 0; y < rows * side; y++) {
    for (let x = 0; x < columns * side; x++) {
      const from = 4 * (y * width + x);
      const to = 3 * (Math.floor(y / side) * columns + Math.floor(x / side));
      for (let c = 0; c < 3; c++) cells[to + c] += data[from + c] / (side * side);
      const [low, high] = [
        Math.min(data[from], data[from + 1], data[from + 2]),
        Math.max(data[from], data[from + 1], data[from + 2]),
      ];
      if (high > BRIGHT) bright++;
      if (high - low > COLORED) colored++;
    }
  }
  const pixels = columns * rows * side * side;
  return { columns, rows, side, cells, bright: bright / pixels, colored: colored / pixels };
}

/** A line for the statistics, and one a row of cells, in hexadecimal numbers. */
export function writeGrid({ columns, rows, side, cells, bright, colored }: PictureGrid): string {
  const hex = (value: number) => Math.round(value).toString(16).padStart(2, '0');
  const lines = Array.from({ length: rows }, (_, row) =>
    Array.from(cells.subarray(3 * row * columns, 3 * (row + 1) * columns), hex).join(''),
  );
  return `${[columns, rows, side, bright.toFixed(5), colored.toFixed(5)].join(' ')}\n${lines.join('\n')}\n`;
}

export function readGrid(text: string): PictureGrid {
  const [head, ...lines] = text.trim().split('\n');
  const [columns, rows, side, bright, colored] = head.split(' ').map(Number);
  const bytes = lines.join('').match(/../g) ?? [];
  return { columns, rows, side, bright, colored, cells: Float64Array.from(bytes, (byte) => Number.parseInt(byte, 16)) };
}

/** What two pictures of the same thing may differ by in a cell: the edges, and the rounding of what was written. */
export function tolerance(side: number): number {
  return (2 * side * 0.25 * 255) / (side * side) + 0.5;
}

/** Cells that differ by more than equal pictures do, as “column,row: by how much”; and statistics that do. */
export function differences(seen: PictureGrid, wanted: PictureGrid): string[] {
  if (seen.columns !== wanted.columns || seen.rows !== wanted.rows || seen.side !== wanted.side) {
    return [`the picture is ${seen.columns} by ${seen.rows} cells, not ${wanted.columns} by ${wanted.rows}`];
  }
  const found: string[] = [];
  const most = tolerance(wanted.side);
  for (let cell = 0; cell < wanted.columns * wanted.rows; cell++) {
    const off = [0, 1, 2].map((c) => seen.cells[3 * cell + c] - wanted.cells[3 * cell + c]);
    if (Math.max(...off.map(Math.abs)) <= most) continue;
    found.push(
      `${cell % wanted.columns},${Math.floor(cell / wanted.columns)}: ${off.map((value) => value.toFixed(0)).join(' ')}`,
    );
  }
  for (const what of ['bright', 'colored'] as const) {
    // A fifth of what is there, and a thousandth of the picture: edges are about as many as that.
    if (Math.abs(seen[what] - wanted[what]) <= 0.2 * wanted[what] + 1e-3) continue;
    found.push(`${what}: ${(100 * seen[what]).toFixed(2)} % of the picture, not ${(100 * wanted[what]).toFixed(2)} %`);
  }
  return found;
}
