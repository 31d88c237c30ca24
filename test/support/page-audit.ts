/** Looks for what makes a page hard to read, to press or to reach by keyboard. Runs in the page, so it imports nothing. */
import type { Page } from 'playwright-core';

/** Contrast that WCAG 2.2, success criterion 1.4.3, asks for, and the size of a touch target, CSS pixels (2.5.5). */
const WANTED = { contrast: 4.5, target: 44 };

/** Sentences about texts of too little contrast with the colours behind them; a canvas counts as the page's own colour. */
export function faintTexts(page: Page): Promise<string[]> {
  return page.evaluate(({ contrast }) => {
    type Rgba = [number, number, number, number];
    const parse = (text: string): Rgba => {
      const [r = 0, g = 0, b = 0, a = 1] = (text.match(/[\d.]+/g) ?? []).map(Number);
      return /^color\(/.test(text) ? [255 * r, 255 * g, 255 * b, a] : [r, g, b, a];
    };
    const over = ([r, g, b, a]: Rgba, [R, G, B]: Rgba): Rgba => {
      const mix = (top: number, bottom: number) => top * a + bottom * (1 - a);
      return [mix(r, R), mix(g, G), mix(b, B), 1];
    };
    const luminance = ([r, g, b]: Rgba) => {
      const linear = (value: number) =>
        value / 255 <= 0.04045 ? value / 3294.6 : ((value / 255 + 0.055) / 1.055) ** 2.4;
      return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    };
    const backdrop = (element: Element): Rgba => {
      const layers: Rgba[] = [];
      for (let each: Element | null = element; each !== null; each = each.parentElement) {
        const color = parse(getComputedStyle(each).backgroundColor);
        if (color[3] > 0) layers.push(color);
        if (color[3] === 1) break;
      }
      return layers.reverse().reduce((behind, color) => over(color, behind), [255, 255, 255, 1] as Rgba);
    };
    const opacityOf = (element: Element) => {
      let opacity = 1;
      for (let each: Element | null = element; each !== null; each = each.parentElement)
        opacity *= Number(getComputedStyle(each).opacity);
      return opacity;
    };
    const faint: string[] = [];
    for (const element of document.body.querySelectorAll('*')) {
      const text = [...element.childNodes].filter((node) => node.nodeType === 3 && node.nodeValue?.trim()).join('');
      const own = [...element.childNodes]
        .map((node) => (node.nodeType === 3 ? node.nodeValue : ''))
        .join('')
        .trim();
      if (text === '' || /^(STYLE|SCRIPT|NOSCRIPT|OPTION|title)$/i.test(element.tagName)) continue;
      const box = element.getBoundingClientRect();
      // What is inactive is exempt, and so is what fades in and out.
      const isSeen =
        element.checkVisibility({ visibilityProperty: true }) && box.width > 0 && opacityOf(element) > 0.05;
      if (!isSeen || element.closest(':disabled, [aria-hidden=true]') !== null) continue;
      const behind = backdrop(element);
      const [r, g, b, a] = parse(getComputedStyle(element).color);
      const [x, y] = [luminance(over([r, g, b, a * opacityOf(element)], behind)), luminance(behind)];
      const ratio = (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
      if (ratio < contrast) faint.push(`“${own.slice(0, 30)}” (${element.className}) has ${ratio.toFixed(2)} : 1`);
    }
    return faint;
  }, WANTED);
}

/** Sentences about buttons and fields that a finger misses. The row or label of a field counts with it. */
export function smallTargets(page: Page): Promise<string[]> {
  return page.evaluate(({ target }) => {
    const small: string[] = [];
    for (const control of document.body.querySelectorAll('button, a[href], input, select, textarea')) {
      if (!control.checkVisibility({ visibilityProperty: true })) continue;
      const boxes = [control, control.closest('label, .lil-controller, .controller')].map((each) =>
        each === null ? undefined : each.getBoundingClientRect(),
      );
      const largest = (side: 'width' | 'height') => Math.max(...boxes.map((box) => box?.[side] ?? 0));
      const [width, height] = [largest('width'), largest('height')];
      // A tenth of a pixel is lost to zoom.
      if (Math.min(width, height) > target - 0.1 || width === 0) continue;
      const name = control.getAttribute('aria-label') ?? control.textContent?.trim() ?? '';
      small.push(
        `${control.tagName.toLowerCase()} “${name.slice(0, 30)}” has ${width.toFixed(0)} × ${height.toFixed(0)}`,
      );
    }
    return small;
  }, WANTED);
}

/** Sentences about controls that Tab does not reach, or whose focus does not show. */
export async function unreachedControls(page: Page): Promise<string[]> {
  // After a key, browsers show the focus wherever it is put.
  await page.keyboard.press('Tab');
  return page.evaluate(() => {
    const found: string[] = [];
    const lookOf = (element: Element) => {
      const { outlineStyle, outlineWidth, boxShadow, backgroundColor, borderColor } = getComputedStyle(element);
      // A link that covers its card shows the focus around the card.
      const around = getComputedStyle(element, '::after');
      const widths = [
        outlineStyle === 'none' ? '' : outlineWidth,
        around.outlineStyle === 'none' ? '' : around.outlineWidth,
      ];
      return [...widths, boxShadow, backgroundColor, borderColor].join();
    };
    for (const control of document.body.querySelectorAll<HTMLElement>('button, a[href], input, select, textarea')) {
      if (!control.checkVisibility({ visibilityProperty: true }) || control.matches(':disabled')) continue;
      const name = control.getAttribute('aria-label') ?? control.textContent?.trim() ?? '';
      const said = `${control.tagName.toLowerCase()} “${name.slice(0, 30)}” (${control.className})`;
      if (control.tabIndex < 0) {
        found.push(`${said} is not reached by Tab`);
        continue;
      }
      control.blur();
      const before = lookOf(control);
      control.focus();
      if (document.activeElement !== control || lookOf(control) === before)
        found.push(`${said} does not show its focus`);
    }
    return found;
  });
}
