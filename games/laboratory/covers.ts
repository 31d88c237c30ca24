/** Tells the view when a panel covers another part of the window. */
import type { View } from '@principia/shell';

const EVENT = 'laboratory-cover';

/** Call it when a panel was shown or hidden. */
export function announceCover(): void {
  document.dispatchEvent(new Event(EVENT));
}

/** Fits the view into what is free whenever that changes. */
export function refitWhenCovered(view: View): View {
  document.addEventListener(EVENT, view.fit);
  return {
    ...view,
    destroy() {
      document.removeEventListener(EVENT, view.fit);
      view.destroy();
    },
  };
}
