// Lowers vectors to arithmetic on their components.
import { PhysicsError } from '../errors/physics-error.ts';
import type { Parameter } from '../world/types.ts';
import type { Environment } from './environment.ts';
import type { Expression, Vector } from './expression.ts';
import type { Graph } from './graph.ts';
import type { Node } from './node.ts';
import type { StageData } from './scheme.ts';
import type { SumScope } from './table.ts';
import { type Axes, cross, eachAxis, normalize, rotateInPlane, rotateInSpace } from './vector-algebra.ts';

/** Lowers the parts of an expression, each once. */
interface VectorLowering {
  readonly graph: Graph;
  readonly environment: Environment;
  scalar(expression: Expression): Node;
  vector(expression: Vector): Axes;
  sum(scope: SumScope, term: Node): Node;
  isNever(condition: Expression): boolean;
}

/** Returns the components of a vector; those that do not exist in two dimensions are zero. */
export function lowerVector(lowering: VectorLowering, { op, args, data }: Expression): Axes {
  const { graph, environment } = lowering;
  const [a, b] = args as [Vector, Vector];
  switch (op) {
    case 'parameter':
      return parameterAxes(environment, graph, data as Parameter);
    case 'vec3': {
      const [x, y, z] = args.map((arg) => lowering.scalar(arg));
      return [x, y, environment.dimensions === 2 ? graph.zero : z];
    }
    case 'axial3':
      return args.map((arg) => lowering.scalar(arg)) as unknown as Axes;
    case 'angularVelocity':
      return angularVelocity(environment, graph);
    case 'add':
    case 'sub':
      return eachAxis((i) => graph.make(op, [lowering.vector(a)[i], lowering.vector(b)[i]]));
    case 'mul':
    case 'div': {
      const factor = lowering.scalar(b);
      return eachAxis((i) => graph.make(op, [lowering.vector(a)[i], factor]));
    }
    case 'negate':
      return eachAxis((i) => graph.make('negate', [lowering.vector(a)[i]]));
    case 'cross':
      return cross(graph, lowering.vector(a), lowering.vector(b));
    case 'normalize':
      return normalize(graph, lowering.vector(a));
    case 'select':
      if (lowering.isNever(a)) return lowering.vector(args[2] as Vector);
      return eachAxis((i) => {
        const [whenTrue, whenFalse] = [lowering.vector(b)[i], lowering.vector(args[2] as Vector)[i]];
        return graph.make('select', [lowering.scalar(a), whenTrue, whenFalse]);
      });
    case 'rotate':
      return rotate(environment, graph, lowering.vector(a));
    case 'kick': {
      const duration = lowering.scalar(args[2]);
      return environment.kick?.(lowering.vector(a), lowering.vector(b), duration, data as StageData) ?? refuse(op);
    }
    case 'sum':
      return eachAxis((i) => lowering.sum(data as SumScope, lowering.vector(a)[i]));
    default:
      return environment.vectors[op] ?? refuse(op);
  }
}

function refuse(op: string): never {
  throw new PhysicsError('E_UNKNOWN', `a law cannot read ${op} here.`, { field: op });
}

function parameterAxes(environment: Environment, graph: Graph, parameter: Parameter): Axes {
  return eachAxis((i) => {
    const isAbsent = environment.dimensions === 2 && (parameter.kind === 'axial' ? i < 2 : i === 2);
    return isAbsent ? graph.zero : environment.parameter(parameter, i);
  });
}

function angularVelocity(environment: Environment, graph: Graph): Axes {
  return eachAxis((i) => {
    const isAbsent = environment.dimensions === 2 && i < 2;
    return isAbsent ? graph.zero : environment.column('AngularVelocity', 'xyz'[i], 'real');
  });
}

function rotate(environment: Environment, graph: Graph, v: Axes): Axes {
  const column = (component: 'Rotation' | 'Orientation', field: string) => environment.column(component, field, 'real');
  if (environment.dimensions === 2) return rotateInPlane(graph, column('Rotation', 'angle'), v);
  const [x, y, z, w] = ['x', 'y', 'z', 'w'].map((field) => column('Orientation', field));
  return rotateInSpace(graph, [x, y, z], w, v);
}
