import { expect, it } from 'vitest';
import { readPlotChoice, writePlotChoice } from './plot-choice.ts';

it.each([
  ['Energy', { what: 'Energy', against: '', body: 0 }],
  ['Position.y,,1', { what: 'Position.y', against: '', body: 1 }],
  ['Position.y,Position.x,12', { what: 'Position.y', against: 'Position.x', body: 12 }],
  ['Momentum,Energy.kinetic', { what: 'Momentum', against: 'Energy.kinetic', body: 0 }],
])('reads %s, and writes what it read', (text, choice) => {
  expect(readPlotChoice(text, 2)).toEqual(choice);
  expect(writePlotChoice(choice)).toBe(text);
});

it.each([
  '',
  'energy',
  'Position',
  'Position.w',
  'Position.y.z',
  'constructor.name',
  'Position.toString',
  'Position.y,Energy',
  'Momentum,Momentum.z',
  'Position.y,,-1',
  'Position.y,,1.5',
  'Position.y,,99999999',
  'Position.y,,1,1',
])('knows no plot “%s”', (text) => {
  expect(readPlotChoice(text, 2)).toBeUndefined();
});

it('plots the third component of a total in three dimensions only', () => {
  expect(readPlotChoice('Momentum,Momentum.z', 3)).toBeDefined();
});
