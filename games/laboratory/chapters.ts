/** Subjects of the chapters of the book. */
export const CHAPTERS: Readonly<Record<number, string>> = {
  1: 'A first program',
  2: 'Drawing and time',
  3: 'Functions and vectors',
  4: 'Motion and energy',
  5: 'Newton’s laws',
  6: 'Gravity, orbits and rockets',
  7: 'Contact and fluids',
  8: 'Springs',
  9: 'Circular motion and rotation',
  10: 'Forces at a distance',
  11: 'Collisions',
  12: 'Particles',
  13: 'Rigid and soft bodies',
  14: 'Integrators and scales',
  15: 'Three dimensions',
  16: 'Projects',
  17: 'Beyond the book',
};

/** Number and subject of a chapter. */
export function chapterTitle(chapter: number): string {
  const subject = CHAPTERS[chapter];
  return subject === undefined ? `Chapter ${chapter}` : `Chapter ${chapter} · ${subject}`;
}
