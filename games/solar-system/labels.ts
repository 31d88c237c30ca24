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
  const tags: Tag[] = texts.map(([text, color]) => {
    const element = document.createElement('button');
    element.type = 'button';
    element.className = 'ss-label';
    element.textContent = text;
    element.style.color = color;
    parent.append(element);
    return { element, x: 0, y: 0, isShown: true };
  });
  // For fingers, names are larger than they look and may lie over each other: the nearest text is meant.
  const stop = new AbortController();
  parent.addEventListener(
    'click',
    ({ target, detail, clientX, clientY }) => {
      const pressed = tags.findIndex(({ element }) => element === target);
      if (pressed < 0) return;
      const { left, top } = parent.getBoundingClientRect();
      follow(detail === 0 ? pressed : nearestTo(tags, clientX - left, clientY - top));
    },
    { signal: stop.signal },
  );
  return {
    update(spots, isShown, toScreen) {
      const { clientWidth, clientHeight } = parent;
      for (const [i, tag] of tags.entries()) {
        const place = isShown && spots[i].isShown ? toScreen(spots[i]) : undefined;
        // A name outside the picture would take the focus of the keyboard there.
        const isFree =
          place !== undefined &&
          isWithin(place.x + place.radius, clientWidth) &&
          isWithin(place.y, clientHeight) &&
          !isTaken(tags, i, place.x + place.radius, place.y);
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
      stop.abort();
      for (const { element } of tags) element.remove();
    },
  };
}

const isWithin = (at: number, length: number): boolean => at >= 0 && at <= length - CLEAR.y;

/** The name whose middle is nearest to a place in the picture, CSS pixels. */
function nearestTo(tags: readonly Tag[], x: number, y: number): number {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (const [i, tag] of tags.entries()) {
    if (!tag.isShown) continue;
    const distance = Math.hypot(tag.x + tag.element.offsetWidth / 2 - x, tag.y - y);
    if (distance < least) [nearest, least] = [i, distance];
  }
  return nearest;
}

/** Whether a name that was placed before stands where this one would. */
function isTaken(tags: readonly Tag[], count: number, x: number, y: number): boolean {
  for (let i = 0; i < count; i++) {
    const other = tags[i];
    if (other.isShown && Math.abs(other.x - x) < CLEAR.x && Math.abs(other.y - y) < CLEAR.y) return true;
  }
  return false;
}
