/** What moves on the front page: the scene at its head, and the card that the visitor looks at. */
import { enliven } from './live-cards.ts';
import { showDust } from './scene.ts';

const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
const canvas = document.querySelector('canvas');
const dust = canvas === null ? undefined : showDust(canvas, isStill);
enliven(document.querySelectorAll<HTMLElement>('.games li[data-live]'), dust);
