/**
 * What lies over the picture, painted into the frames of clips and films: the title of the game, the card of its result, and
 * what a game marks with the attribute `data-filmed`. A browser records canvases only, so their texts, plain boxes and
 * canvases are painted by hand; buttons, which nobody can press in a video, are left out unless the mark is `all`.
 */

/** Paints what lies over a picture. */
export type FilmOverlay = (frame: HTMLCanvasElement, picture: HTMLCanvasElement) => void;

/** Space between the title and the corner of the picture, and the height of its line, CSS pixels. */
const TITLE = { margin: 20, size: 20 } as const;
const SHADOW = '#0d1226';

/** @param root holds everything on the page of the game */
export function createFilmOverlay(root: HTMLElement, title: string): FilmOverlay {
  return (frame, picture) => {
    const context = frame.getContext('2d', { alpha: false });
    const box = picture.getBoundingClientRect();
    if (context === null || box.width === 0) return;
    context.save();
    context.scale(frame.width / box.width, frame.height / box.height);
    context.translate(-box.left, -box.top);
    paintTitle(context, box, title, getComputedStyle(root).fontFamily);
    for (const marked of root.querySelectorAll<HTMLElement>('[data-filmed]')) paintTree(context, marked, marked);
    context.restore();
  };
}

type Context = CanvasRenderingContext2D;

function paintTitle(context: Context, { left, top }: DOMRect, title: string, family: string): void {
  context.globalAlpha = 1;
  context.font = `650 ${TITLE.size}px ${family}`;
  context.textBaseline = 'middle';
  cast(context, 6);
  context.fillStyle = '#eef1fb';
  context.fillText(title, left + TITLE.margin, top + TITLE.margin + TITLE.size / 2);
}

/** Paints an element and, from back to front, what it holds. */
function paintTree(context: Context, element: HTMLElement, marked: HTMLElement): void {
  const style = getComputedStyle(element);
  if (style.display === 'none') return;
  const before = context.globalAlpha;
  if (element === marked) context.globalAlpha = opacityOf(element);
  else context.globalAlpha *= Number(style.opacity);
  if (style.visibility === 'visible' && context.globalAlpha > 0.01) {
    paintBox(context, element, style);
    if (element instanceof HTMLCanvasElement) paintCanvas(context, element);
  }
  for (const child of element.childNodes) {
    if (child instanceof Text && style.visibility === 'visible') paintText(context, child, style);
    if (child instanceof HTMLElement && isPainted(child, marked)) paintTree(context, child, marked);
  }
  context.globalAlpha = before;
}

function isPainted(element: HTMLElement, marked: HTMLElement): boolean {
  if (element.matches('style, [data-filmed]')) return false;
  return marked.dataset.filmed === 'all' || !element.matches('button, a, input, select, details');
}

function opacityOf(element: HTMLElement): number {
  let opacity = 1;
  for (let each: HTMLElement | null = element; each !== null; each = each.parentElement)
    opacity *= Number(getComputedStyle(each).opacity);
  return opacity;
}

function paintBox(context: Context, element: HTMLElement, style: CSSStyleDeclaration): void {
  // The first colour stands for a gradient.
  const color = /rgba?\([^)]*\)/.exec(style.backgroundImage)?.[0] ?? style.backgroundColor;
  if (/^rgba.*, 0\)$/.test(color)) return;
  const { left, top, width, height } = element.getBoundingClientRect();
  cast(context, 0);
  context.fillStyle = color;
  context.beginPath();
  context.roundRect(left, top, width, height, Math.min(Number.parseFloat(style.borderTopLeftRadius) || 0, height / 2));
  context.fill();
}

function paintCanvas(context: Context, canvas: HTMLCanvasElement): void {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const { paddingLeft, paddingTop } = getComputedStyle(canvas);
  // The box of a scaled canvas is that of its style times the scale.
  const scale = width / canvas.offsetWidth;
  const [x, y] = [scale * Number.parseFloat(paddingLeft), scale * Number.parseFloat(paddingTop)];
  if (canvas.width > 0) context.drawImage(canvas, left + x, top + y, width - 2 * x, height - 2 * y);
}

/** Paints word by word, each where the browser has put it, so that lines break where they do on the page. */
function paintText(context: Context, text: Text, style: CSSStyleDeclaration): void {
  const range = document.createRange();
  context.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  context.letterSpacing = style.letterSpacing === 'normal' ? '0px' : style.letterSpacing;
  context.textBaseline = 'middle';
  context.fillStyle = style.color;
  cast(context, style.textShadow === 'none' ? 0 : 4);
  for (const { index, 0: word } of text.data.matchAll(/\S+/g)) {
    range.setStart(text, index);
    range.setEnd(text, index + word.length);
    const [box] = range.getClientRects();
    if (box === undefined || box.height === 0) continue;
    context.fillText(word, box.left, box.top + box.height / 2, box.width);
  }
}

function cast(context: Context, blur: number): void {
  context.shadowColor = blur === 0 ? 'transparent' : SHADOW;
  context.shadowBlur = blur;
}
