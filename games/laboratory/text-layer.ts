/** Texts of a picture, upright and of the same size at any zoom. */
import 'pixi.js/text';
import { COLORS, type Picture } from '@principia/scenes/examples';
import { Container, Text } from 'pixi.js';
import { gridLines } from './grid-lines.ts';
import { plainNumber } from './number-text.ts';
import type { Pen } from './pen.ts';

type Spot = { readonly x: number; readonly y: number };

/** Distance of two lines, CSS pixels. */
const LINE = 15;

export class TextLayer {
  readonly container = new Container();
  readonly #texts: Text[] = [];
  readonly #isDown: boolean;
  #used = 0;
  #scale = 1;

  /** @param isDown whether the world's y axis points down */
  constructor(isDown: boolean) {
    this.#isDown = isDown;
  }

  begin(scale: number): void {
    this.#used = 0;
    this.#scale = scale;
  }

  /**
   * Writes to the upper right of a point.
   * @param offset distance from the point along both axes, m
   * @param row lines to leave free below, for texts of which several may stand at one point
   */
  write(at: Spot, text: string, color: number = COLORS.white, offset = 0, row = 0): void {
    const above = offset + (row * LINE) / this.#scale;
    this.#put({ x: at.x + offset, y: at.y + (this.#isDown ? -above : above) }, text, color, 0, 1);
  }

  /** Numbers and names of the axes of a graph. */
  axes({ view, graph }: Picture, pen: Pen): void {
    if (graph === undefined) return;
    const { minX, maxX, minY, maxY } = view;
    const gap = 6 / this.#scale;
    for (const x of gridLines(minX, maxX, graph.x.step)) {
      const spot = pen.place({ x, y: minY });
      this.#put({ x: spot.x, y: spot.y - gap }, plainNumber(x), COLORS.grey, 0.5, 0);
    }
    for (const y of gridLines(minY, maxY, graph.y.step)) {
      const spot = pen.place({ x: minX, y });
      this.#put({ x: spot.x - gap, y: spot.y }, plainNumber(y), COLORS.grey, 1, 0.5);
    }
    const [right, top] = [pen.place({ x: maxX, y: minY }), pen.place({ x: minX, y: maxY })];
    this.#put({ x: right.x, y: right.y - 4 * gap }, graph.x.label, COLORS.white, 1, 0);
    this.#put({ x: top.x + gap, y: top.y }, graph.y.label, COLORS.white, 0, 0);
  }

  /** Hides the texts that were not written since `begin`. */
  end(): void {
    for (let i = this.#used; i < this.#texts.length; i++) this.#texts[i].visible = false;
  }

  destroy(): void {
    this.container.destroy({ children: true });
  }

  #put(at: Spot, content: string, color: number, anchorX: number, anchorY: number): void {
    const text = this.#next();
    if (text.text !== content) text.text = content;
    if (text.tint !== color) text.tint = color;
    text.anchor.set(anchorX, anchorY);
    text.position.set(at.x, at.y);
    // The text is drawn at twice its size, for sharp screens.
    text.scale.set(0.5 / this.#scale, (this.#isDown ? 0.5 : -0.5) / this.#scale);
    text.visible = true;
  }

  #next(): Text {
    const known = this.#texts[this.#used++];
    if (known !== undefined) return known;
    const made = new Text({ text: '', style: { fontFamily: 'system-ui, sans-serif', fontSize: 26, fill: 0xffffff } });
    this.#texts.push(made);
    this.container.addChild(made);
    return made;
  }
}
