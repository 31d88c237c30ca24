/** How the bodies look: colours, sizes on the screen, and how they spin. */
import type { BodyName } from '@principia/scenes';

export interface Look {
  /** CSS colour of name and orbit. */
  readonly color: string;
  /** Colours of the surface, from dark to light. */
  readonly surface: readonly string[];
  /** Bands instead of spots. */
  readonly isBanded?: boolean;
  /** Radius on the screen in the enlarged scale, CSS pixels, where the true one is smaller. */
  readonly pixels: number;
  /** Days of a turn; negative for one that turns backwards. */
  readonly day: number;
  /** Inclination of the axis to that of the ecliptic and ecliptic longitude of the north pole, degrees. */
  readonly tilt: readonly [inclination: number, longitude: number];
}

export const LOOKS: Readonly<Record<BodyName, Look>> = {
  sun: {
    color: '#ffd27a',
    surface: ['#ff9a2e', '#ffc458', '#fff0b8'],
    pixels: 15,
    day: 25.05,
    tilt: [7.25, 346],
  },
  mercury: {
    color: '#b9aca0',
    surface: ['#5b544d', '#8c8178', '#c0b3a5'],
    pixels: 4.2,
    day: 58.646,
    tilt: [7, 318],
  },
  venus: {
    color: '#f0d8a2',
    surface: ['#c69a5c', '#e6c98c', '#f7ecca'],
    isBanded: true,
    pixels: 6,
    day: -243.02,
    tilt: [1.3, 30],
  },
  earth: {
    color: '#7db8ff',
    surface: ['#0e2a5c', '#14407f', '#1c58a4', '#35743c', '#8f8a55', '#f4f7fb'],
    pixels: 6.4,
    day: 0.99727,
    tilt: [23.44, 90],
  },
  moon: {
    color: '#c9ccd4',
    surface: ['#5d5f66', '#8f929a', '#c6c8cd'],
    pixels: 3.4,
    day: 27.3217,
    tilt: [1.5, 90],
  },
  mars: {
    color: '#ff9166',
    surface: ['#7a3620', '#b65a33', '#e0935f', '#f3e0cd'],
    pixels: 5.2,
    day: 1.02596,
    tilt: [26.7, 353],
  },
  jupiter: {
    color: '#f0c59a',
    surface: ['#9c6b4a', '#d4ad86', '#f0e0c6', '#c88f63'],
    isBanded: true,
    pixels: 10.5,
    day: 0.41354,
    tilt: [2.2, 248],
  },
  saturn: {
    color: '#f2dfae',
    surface: ['#b3935f', '#dcc38c', '#f3e6c0'],
    isBanded: true,
    pixels: 9,
    day: 0.44401,
    tilt: [28.05, 79.5],
  },
  uranus: {
    color: '#a4e8ee',
    surface: ['#79c6d0', '#9fdfe5', '#c4f1f2'],
    isBanded: true,
    pixels: 7.2,
    day: -0.71833,
    tilt: [82.3, 257.4],
  },
  neptune: {
    color: '#7f9dff',
    surface: ['#2c4fb8', '#4a74e0', '#86a8ff'],
    isBanded: true,
    pixels: 7,
    day: 0.67125,
    tilt: [28, 319],
  },
  pluto: {
    color: '#d9c3a8',
    surface: ['#6d5443', '#a98d73', '#e5d8c6'],
    pixels: 3.8,
    day: -6.3872,
    tilt: [113, 132],
  },
};

/** Colour of the probe and of its path. */
export const PROBE_COLOR = '#ffb454';
