/** Names beside the bodies, as elements of the page that can be pressed. */
import type { Spot } from './picture.ts';

export interface Labels {
  /** @param toScreen place and radius on the canvas, CSS pixels; undefined behind the camera */
  update(
    spots: readonly Spot[],
    isShown: boolean,
    toScreen: (spot: Spot) => { x: number; y: number; radius: number } | undefined,
  ): void;
  destroy(): void;
}

/** Half the size of the region that a name keeps free, CSS pixels. */
const CLEAR = { x: 46, y: 13 } as const;

interface Tag {
  readonly element: HTMLButtonElement;
  x: number;
  y: number;
  isShown: boolean;
}

/** @param texts name and CSS colour of each spot, in the order of the spots */
export function createLabels(
  parent: HTMLElement,
  texts: readonly (readonly [text: string, color: string])[],
  follow: (index: number) => void,
): Labels {
  const tags: Tag[] = texts.map(([text, color], i) => {
    const element = document.createElement('button');
    element.type = 'button';
    element.className = 'ss-label';
    element.textContent = text;
    element.style.color = color;
    element.addEventListener('click', () => follow(i));
    parent.append(element);
    return { element, x: 0, y: 0, isShown: true };
  });
  return {
    update(spots, isShown, toScreen) {
      for (const [i, tag] of tags.entries()) {
        const place = isShown && spots[i].isShown ? toScreen(spots[i]) : undefined;
        const isFree = place !== undefined && !isTaken(tags, i, place.x + place.radius, place.y);
        if (isFree !== tag.isShown) tag.element.hidden = !isFree;
        tag.isShown = isFree;
        if (place === undefined) continue;
        const x = place.x + place.radius;
        if (Math.abs(x - tag.x) + Math.abs(place.y - tag.y) < 0.1) continue;
        tag.x = x;
        tag.y = place.y;
        tag.element.style.transform = `translate(${x.toFixed(1)}px, ${place.y.toFixed(1)}px)`;
      }
    },
    destroy() {
      for (const { element } of tags) element.remove();
    },
  };
}

/** Whether a name that was placed before stands where this one would. */
function isTaken(tags: readonly Tag[], count: number, x: number, y: number): boolean {
  for (let i = 0; i < count; i++) {
    const other = tags[i];
    if (other.isShown && Math.abs(other.x - x) < CLEAR.x && Math.abs(other.y - y) < CLEAR.y) return true;
  }
  return false;
}
