// In which order the layers of threads are solved: what pulled hardest in the sub-step before goes first.
import { get, put } from '../memory/columns';
import { LANES, add, at, laneOf, splat } from '../memory/lanes';
import { ConstraintTable, LAYERS, putWord, word } from './table';

// To be called while the rows still hold the tensions of the sub-step before. Layers that pull alike keep their order.
export function orderLayers(t: ConstraintTable): void {
  const order = t.layers + ((<usize>(LAYERS + 1)) << 2);
  const pulls = order + ((<usize>(LAYERS + 1)) << 2);
  for (let layer = 0; layer < t.layerCount; layer++) {
    const pull = pullOf(t, layer);
    put(pulls, layer, pull);
    let place = layer;
    for (; place > 0; place--) {
      const before = word(order, place - 1);
      if (get(pulls, before) >= pull) break;
      putWord(order, place, before);
    }
    putWord(order, place, layer);
  }
}

// Mean tension of a layer's rows.
function pullOf(t: ConstraintTable, layer: i32): real {
  const first = <i32>word(t.strands, word(t.layers, layer));
  const last = <i32>word(t.strands, word(t.layers, layer + 1));
  let sum = splat(0);
  for (let row = first; row < last; row += LANES) sum = add(sum, v128.load(t.tension + at(row)));
  let pull: real = 0;
  for (let lane = 0; lane < LANES; lane++) pull += laneOf(sum, lane);
  return last > first ? pull / <real>(last - first) : 0;
}
