/** Colours that everyone can tell apart: Okabe and Ito, Color Universal Design (2008). RGBA bytes in memory order. */
const COLORS = [0xff009fe6, 0xffe9b456, 0xff739e00, 0xff42e4f0, 0xffb27200, 0xff005ed5, 0xffa779cc];
const GREY = 0xff909090;

/** The colour of things that belong together by number; grey for none, which is -1. */
export function groupColor(group: number): number {
  return group < 0 ? GREY : COLORS[group % COLORS.length];
}
