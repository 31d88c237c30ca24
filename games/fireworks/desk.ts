/** Where shells are chosen: what the next one is. It outlives worlds and pictures. */
import { type FireworksGame, SURPRISE } from './sim.ts';

type Place = { readonly x: number; readonly y: number; readonly z: number };

export class Desk {
  /** Number of the chosen kind and colour, or `SURPRISE`. */
  kind = SURPRISE;
  color = SURPRISE;

  /** A shell goes up. */
  fire(sim: FireworksGame, finger: number, place: Place): void {
    sim.press({ do: 'fire', finger, ...place, kind: this.kind, color: this.color });
  }

  /** Once a frame. */
  update(_sim: FireworksGame, _seconds: number): void {}
}
