// The sum of all laws of a world as arithmetic: force and torque on a body, and its acceleration.

import type { Environment } from '../laws/environment.ts';
import type { Graph } from '../laws/graph.ts';
import { Lowering } from '../laws/lower.ts';
import type { Node } from '../laws/node.ts';
import { type Axes, eachAxis, zeroVector } from '../laws/vector-algebra.ts';
import type { Force, Law } from '../world/types.ts';
import type { ParameterOwner } from './parameter-block.ts';
import type { WorldColumns } from './world-columns.ts';

/** A force that is a law. */
export type LawForce = Force & { readonly law: Law; readonly sources: NonNullable<Force['sources']> };

/** The laws among the forces of a world. */
export function lawsOf(forces: readonly Force[]): LawForce[] {
  return forces.filter((force): force is LawForce => force.law !== undefined);
}

/** The parameters of a law and the sources of their values. */
export function ownerOf({ law, sources, name }: LawForce): ParameterOwner {
  const { parameters, names } = law;
  return { parameters, sources, names: names.map((parameter) => `${parameter} of ${name}`) };
}

/**
 * Force and acceleration are separate sums, so that an acceleration independent of mass is not multiplied and divided
 * by it.
 */
export interface Sum {
  readonly force: Axes;
  readonly acceleration: Axes;
  readonly torque: Axes;
}

/** State and time at which laws are evaluated. */
export interface Evaluation {
  readonly position: Axes;
  readonly velocity: Axes;
  readonly startVelocity: Axes;
  /** Force and torque to which the laws are added. */
  readonly force: Axes;
  readonly torque: Axes;
  readonly stage: number;
  readonly time: Node;
}

/** Sums all laws in the order of the list; a law that reads the force reads the sum of the laws before it. */
export function sumLaws(columns: WorldColumns, laws: readonly LawForce[], at: Evaluation): Sum {
  const { graph } = columns;
  const none = zeroVector(graph);
  let sum: Sum = { force: at.force, acceleration: none, torque: at.torque };
  for (const force of laws) {
    const { law } = force;
    const lowering = new Lowering(graph, environmentOf(columns, force, at, sum));
    const add = (field: 'force' | 'acceleration' | 'torque') => {
      const expression = law[field];
      return expression === undefined ? sum[field] : addAxes(graph, sum[field], lowering.vector(expression));
    };
    sum = { force: add('force'), acceleration: add('acceleration'), torque: add('torque') };
  }
  return sum;
}

function environmentOf(columns: WorldColumns, owner: LawForce, at: Evaluation, sum: Sum): Environment {
  const { position, velocity, startVelocity, stage, time } = at;
  const vectors = {
    position,
    velocity,
    startVelocity,
    get force() {
      return totalForce(columns, sum);
    },
    get acceleration() {
      return totalAcceleration(columns, sum);
    },
  };
  return columns.environment(owner, vectors, time, stage);
}

/** F = sum of forces + m sum of accelerations. */
export function totalForce({ graph, mass }: WorldColumns, { force, acceleration }: Sum): Axes {
  return eachAxis((i) => graph.make('add', [force[i], graph.make('mul', [mass, acceleration[i]])]));
}

/** F/m + a for a body that forces move, and zero for others. */
function totalAcceleration(columns: WorldColumns, { force, acceleration }: Sum): Axes {
  const { graph, mass, isMovable } = columns;
  return eachAxis((i) => {
    const a = graph.make('add', [graph.make('div', [force[i], mass]), acceleration[i]]);
    return graph.make('keep', [isMovable, a]);
  });
}

/**
 * The change of velocity over a duration h: F h/m + a h for a body that forces move, and zero for others, whose F may
 * be any value: a law that divides by the mass is infinite for bodies without mass and for rows without a body.
 */
export function velocityChange(columns: WorldColumns, { force, acceleration }: Sum, duration: Node): Axes {
  const { graph, mass, isMovable } = columns;
  const perForce = graph.make('div', [duration, mass]);
  const masked = (change: Node) => graph.make('keep', [isMovable, change]);
  return eachAxis((i) => {
    const byField = graph.make('mul', [acceleration[i], duration]);
    const change = graph.make('add', [graph.make('mul', [force[i], perForce]), byField]);
    // The sign stands outside the mask, where a sum becomes a difference.
    return change.op === 'negate' ? graph.make('negate', [masked(change.args[0])]) : masked(change);
  });
}

function addAxes(graph: Graph, a: Axes, b: Axes): Axes {
  return eachAxis((i) => graph.make('add', [a[i], b[i]]));
}
