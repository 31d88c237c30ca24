/** The large moons in the picture: small lit balls beside their planets, while time runs slowly enough to see them go round. */
import { Group, Mesh, MeshStandardMaterial, type SphereGeometry } from 'three';
import { LARGE_MOONS, MOON_NAMES, type MoonName, moonOffset } from './large-moons.ts';
import type { Spot } from './picture.ts';
import { lengthOf, sum, type Vector } from './vectors.ts';

/** A moon that goes farther than this from one picture to the next would only flicker, degrees. */
const MAX_TURN = 60;

export interface MoonView {
  /** Days since J2000, and days from one picture to the next. */
  readonly days: number;
  readonly daysAPicture: number;
  /** Lengths of the picture per km. */
  readonly unit: number;
  /** Smallest drawn radius, CSS pixels. */
  readonly minPixels: number;
  pixelAt(place: Vector): number;
}

export interface MoonBalls {
  readonly object: Group;
  /** Places the spots of the moons beside those of their planets. */
  update(spotOf: (name: 'jupiter' | 'saturn' | MoonName) => Spot, view: MoonView): void;
  destroy(): void;
}

export function createMoonBalls(sphere: SphereGeometry): MoonBalls {
  const object = new Group();
  const balls = MOON_NAMES.map((name) => {
    const material = new MeshStandardMaterial({ color: LARGE_MOONS[name].color, roughness: 1, metalness: 0 });
    const ball = new Mesh(sphere, material);
    object.add(ball);
    return ball;
  });
  return {
    object,
    update(spotOf, { days, daysAPicture, unit, minPixels, pixelAt }) {
      for (const [i, name] of MOON_NAMES.entries()) {
        const moon = LARGE_MOONS[name];
        const [planet, spot] = [spotOf(moon.planet), spotOf(name)];
        const offset = moonOffset(moon, days);
        Object.assign(spot.place, sum(planet.place, offset, unit));
        spot.radius = Math.max(unit * moon.radius, minPixels * pixelAt(spot.place));
        // The enlarged planet would hold a moon that is near it.
        const isOutside = unit * lengthOf(offset) > planet.radius + spot.radius;
        spot.isShown = planet.isShown && isOutside && moon.rate * daysAPicture < MAX_TURN;
        balls[i].visible = spot.isShown;
        balls[i].position.copy(spot.place);
        balls[i].scale.setScalar(spot.radius);
      }
    },
    destroy() {
      for (const { material } of balls) material.dispose();
    },
  };
}
