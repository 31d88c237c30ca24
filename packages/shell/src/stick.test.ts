import { expect, it } from 'vitest';
import { Stick } from './stick.ts';

function recorded() {
  const seen: [number, number][] = [];
  const stick = new Stick((x, y) => seen.push([x, y]));
  const read = (...axes: number[]) => stick.read({ axes } as unknown as Gamepad);
  return { seen, stick, read };
}

it('reports changes only, at most full deflection, y up', () => {
  const { seen, stick } = recorded();
  stick.set(0, 0);
  stick.set(3, 4);
  stick.set(0.6, 0.8);
  stick.set(0.61, 0.79);
  stick.set(0, -0.5);
  stick.set(0, 0);
  expect(seen).toEqual([
    [0.6, 0.8],
    [0, -0.5],
    [0, 0],
  ]);
});

it('ignores the rest of a worn gamepad, and grows steadily from there', () => {
  const { seen, read } = recorded();
  read(0.1, 0.1);
  read(0.151, 0);
  expect(seen).toEqual([]);
  read(0.575, 0);
  read(0, -1);
  read();
  expect(seen).toEqual([
    [0.5, 0],
    [0, 1],
    [0, 0],
  ]);
});

it('follows the stick that is pushed farthest, and an idle gamepad beside it changes nothing', () => {
  const { seen, stick } = recorded();
  const read = (index: number, x: number) => stick.read({ index, axes: [x, 0] } as unknown as Gamepad);
  for (let frame = 0; frame < 3; frame++) {
    read(0, 0);
    read(1, 1);
  }
  stick.set(0, 0.5);
  read(1, 0);
  stick.releaseAll();
  read(1, 0);
  expect(seen).toEqual([
    [1, 0],
    [0, 0.5],
    [0, 0],
  ]);
});
