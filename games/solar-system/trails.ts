/** The paths that bodies and probe have taken, relative to the Sun. */
import { BODY_NAMES } from '@principia/scenes';
import { Group } from 'three';
import { LOOKS, PROBE_COLOR } from './bodies.ts';
import { createPathLine, type PathLine } from './path-line.ts';
import type { FollowName } from './picture.ts';
import type { SolarGame } from './sim.ts';
import { cross, difference, dot, lengthOf, type Vector, vector } from './vectors.ts';

const POINTS = 600;
/** A point is added after this angle about the Sun; a step of more than the other breaks the trail, as it would be no curve. */
const MIN_TURN = 0.01;
const MAX_TURN = 0.5;
const UNIT = 1e-6;

export interface Trails {
  readonly object: Group;
  update(sim: SolarGame, places: ReadonlyMap<FollowName, Vector>, isShown: boolean): void;
  clear(): void;
  destroy(): void;
}

interface Trail {
  readonly line: PathLine;
  last: Vector;
  isEmpty: boolean;
}

export function createTrails(): Trails {
  const object = new Group();
  const trails = new Map<FollowName, Trail>();
  for (const name of [...BODY_NAMES.filter((body) => body !== 'sun'), 'probe' as const]) {
    const line = createPathLine(name === 'probe' ? PROBE_COLOR : LOOKS[name].color, POINTS, false, 0.75);
    trails.set(name, { line, last: vector(), isEmpty: true });
    object.add(line.object);
  }
  const clear = () => {
    for (const trail of trails.values()) {
      trail.line.clear();
      trail.isEmpty = true;
    }
  };
  return {
    object,
    update(sim, places, isShown) {
      const sun = places.get('sun') as Vector;
      for (const [name, trail] of trails) {
        const place = places.get(name);
        trail.line.object.visible = name === 'probe' || isShown;
        if (place === undefined || sim.clock.isTravelling || (name === 'probe' && sim.flight.phase === 'ready')) {
          if (!trail.isEmpty) trail.line.clear();
          trail.isEmpty = true;
          continue;
        }
        grow(trail, difference(place, sun));
      }
    },
    clear,
    destroy() {
      for (const { line } of trails.values()) line.destroy();
    },
  };
}

function grow(trail: Trail, place: Vector): void {
  if (!trail.isEmpty) {
    const turn = Math.atan2(lengthOf(cross(trail.last, place)), dot(trail.last, place));
    const moved = lengthOf(difference(place, trail.last)) / lengthOf(place);
    if (turn < MIN_TURN && moved < MIN_TURN) return;
    if (turn > MAX_TURN) trail.line.clear();
  }
  trail.isEmpty = false;
  trail.last = place;
  trail.line.add(UNIT * place.x, UNIT * place.y, UNIT * place.z);
}
