// Validates a new law by lowering it once without a world, so that its errors are thrown at its definition.
import { PhysicsError } from '../errors/physics-error.ts';
import type { Law, Parameter } from '../world/types.ts';
import { Graph } from './graph.ts';
import { Lowering } from './lower.ts';
import type { Axes } from './vector-algebra.ts';

/** Lowers a law to arithmetic that is not executed, for each of its dimensions, which reveals its errors. */
export function checkLaw(law: Law): void {
  for (const dimensions of [2, 3] as const) {
    if (law.dimensions !== undefined && law.dimensions !== dimensions) continue;
    const graph = new Graph();
    const leaf = (value: number) => graph.make('real', [], value);
    const axes = (value: number): Axes => [
      leaf(value),
      leaf(value + 1),
      dimensions === 2 ? graph.zero : leaf(value + 2),
    ];
    const lowering = new Lowering(graph, {
      dimensions,
      vectors: { position: axes(0), velocity: axes(3), startVelocity: axes(6), force: axes(9), acceleration: axes(12) },
      time: graph.make('load', [], 0),
      dt: graph.make('load', [], 8),
      parameter: (parameter, index) => graph.make('load', [], 16 + 8 * indexOfParameter(law, parameter) + index),
      column: () => leaf(100),
      ownBit: () => 1,
      noise: (seed, channel) => graph.make('noise', [seed], channel),
    });
    const formulas = [law.force, law.acceleration, law.torque].flatMap((formula) =>
      formula === undefined ? [] : lowering.vector(formula),
    );
    const nodes = law.potential === undefined ? formulas : [...formulas, lowering.scalar(law.potential)];
    if (nodes.some(({ scope }) => scope !== undefined))
      throw foreignSymbol(law, 'the row of a table outside of its sum');
  }
}

function indexOfParameter(law: Law, parameter: Parameter): number {
  const index = law.parameters.indexOf(parameter);
  if (index < 0) throw foreignSymbol(law, 'a parameter of another law');
  return index;
}

function foreignSymbol({ name }: Law, what: string): PhysicsError {
  return new PhysicsError('E_UNKNOWN', `law "${name}" reads ${what}.`, { field: name });
}
