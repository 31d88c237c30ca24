// Lowers expressions to arithmetic: vectors become components, and names become columns.

import type { ComponentName } from '../components/all.ts';
import { bitInWord, isInFirstWord } from '../components/membership.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { Parameter } from '../world/types.ts';
import type { ColumnData } from './body-symbols.ts';
import type { Expression, Vector } from './expression.ts';
import type { Graph } from './graph.ts';
import type { Node, Operation } from './node.ts';
import type { StageData } from './scheme.ts';
import { type RowData, SumScope } from './table.ts';
import {
  type Axes,
  cross,
  dot,
  eachAxis,
  lengthOf,
  normalize,
  rotateInPlane,
  rotateInSpace,
} from './vector-algebra.ts';

/** The meaning of the names in an expression. */
export interface Environment {
  readonly dimensions: 2 | 3;
  /** Vectors: position, velocity, startVelocity, force, acceleration. */
  readonly vectors: Readonly<Record<string, Axes>>;
  /** Simulated time at which the laws are evaluated. */
  readonly time: Node;
  readonly dt: Node;
  /** The f64 values of a parameter, in memory. */
  parameter(parameter: Parameter, index: number): Node;
  /** A column of a component. */
  column(component: ColumnData['component'] | '', field: string, kind: 'real' | 'u32'): Node;
  /** Scalars that only schemes have: charge, mass, lastDt. */
  readonly scalars?: Readonly<Record<string, Node>>;
  /** The change of velocity over a duration, in a stage of a scheme. */
  kick?(position: Axes, velocity: Axes, duration: Node, stage: StageData): Axes;
  /** Whether no entity of the world has one of these components: then code for them is left out. */
  isAbsent?(name: ComponentName): boolean;
  /** Noise from the seed of the law. */
  noise(seed: Node, channel: number): Node;
}

type Lowered = Node | Axes;

/** Converts expressions to nodes, each expression once. */
export class Lowering {
  readonly #done = new Map<Expression, Lowered>();
  readonly #scopes = new Map<SumScope, SumScope>();

  constructor(
    readonly graph: Graph,
    readonly environment: Environment,
  ) {}

  scalar(expression: Expression): Node {
    return this.#lower(expression) as Node;
  }

  vector(expression: Vector): Axes {
    return this.#lower(expression) as Axes;
  }

  #lower(expression: Expression): Lowered {
    const cached = this.#done.get(expression);
    if (cached !== undefined) return cached;
    const made = expression.shape === 'vector' ? this.#makeVector(expression) : this.#makeScalar(expression);
    this.#done.set(expression, made);
    return made;
  }

  #makeScalar(expression: Expression): Node {
    const { op, args, data } = expression;
    const { graph, environment } = this;
    switch (op) {
      case 'constant':
        return graph.constant(data as number);
      case 'time':
        return environment.time;
      case 'dt':
        return environment.dt;
      case 'entity':
        return graph.make('entity');
      case 'parameter':
        return environment.parameter(data as Parameter, 0);
      case 'column': {
        const { component, field, spec } = data as ColumnData;
        if (environment.dimensions === 2 && spec.spatial === true) return graph.zero;
        return environment.column(component, field, spec.kind);
      }
      case 'row':
        return graph.make('row', [], (data as RowData).index, this.#scopeOf((data as RowData).scope));
      case 'sum':
        return this.#sum(data as SumScope, this.scalar(args[0]));
      case 'has':
        return this.#has(data as ComponentName);
      case 'noise':
        return environment.noise(this.scalar(args[0]), data as number);
      case 'component':
        return this.vector(args[0] as Vector)[data as number];
      case 'dot':
        return dot(graph, this.vector(args[0] as Vector), this.vector(args[1] as Vector));
      case 'length':
        return lengthOf(graph, this.vector(args[0] as Vector));
      case 'select':
        if (this.#isNever(args[0])) return this.scalar(args[2]);
        return graph.make(
          op,
          args.map((arg) => this.scalar(arg)),
        );
      default:
        return (
          environment.scalars?.[op] ??
          graph.make(
            op as Operation,
            args.map((arg) => this.scalar(arg)),
          )
        );
    }
  }

  #makeVector({ op, args, data }: Expression): Axes {
    const { graph, environment } = this;
    const [a, b] = args as [Vector, Vector];
    switch (op) {
      case 'parameter':
        return this.#parameter(data as Parameter);
      case 'vec3': {
        const [x, y, z] = args.map((arg) => this.scalar(arg));
        return [x, y, environment.dimensions === 2 ? graph.zero : z];
      }
      case 'axial3':
        return args.map((arg) => this.scalar(arg)) as unknown as Axes;
      case 'angularVelocity':
        return this.#columns('AngularVelocity', true);
      case 'add':
      case 'sub':
        return eachAxis((i) => graph.make(op, [this.vector(a)[i], this.vector(b)[i]]));
      case 'mul':
      case 'div': {
        const factor = this.scalar(b);
        return eachAxis((i) => graph.make(op, [this.vector(a)[i], factor]));
      }
      case 'negate':
        return eachAxis((i) => graph.make('negate', [this.vector(a)[i]]));
      case 'cross':
        return cross(graph, this.vector(a), this.vector(b));
      case 'normalize':
        return normalize(graph, this.vector(a));
      case 'select':
        if (this.#isNever(a)) return this.vector(args[2] as Vector);
        return eachAxis((i) => {
          const [whenTrue, whenFalse] = [this.vector(b)[i], this.vector(args[2] as Vector)[i]];
          return graph.make('select', [this.scalar(a), whenTrue, whenFalse]);
        });
      case 'rotate':
        return this.#rotate(this.vector(a));
      case 'kick': {
        const duration = this.scalar(args[2]);
        return environment.kick?.(this.vector(a), this.vector(b), duration, data as StageData) ?? this.#unknown(op);
      }
      case 'sum':
        return eachAxis((i) => this.#sum(data as SumScope, this.vector(a)[i]));
      default:
        return environment.vectors[op] ?? this.#unknown(op);
    }
  }

  #has(name: ComponentName): Node {
    const word = isInFirstWord(name) ? 'members' : 'moreMembers';
    return this.graph.make('has', [this.environment.column('', word, 'u32')], bitInWord(name));
  }

  /** Whether a condition asks for a component that no entity has. */
  #isNever({ op, data }: Expression): boolean {
    return op === 'has' && this.environment.isAbsent?.(data as ComponentName) === true;
  }

  #unknown(op: string): never {
    throw new PhysicsError('E_UNKNOWN', `a law cannot read ${op} here.`, { field: op });
  }

  #parameter(parameter: Parameter): Axes {
    const { graph, environment } = this;
    const isFlat = environment.dimensions === 2;
    const isAxial = parameter.kind === 'axial';
    return eachAxis((i) => {
      const isAbsent = isFlat && (isAxial ? i < 2 : i === 2);
      return isAbsent ? graph.zero : environment.parameter(parameter, i);
    });
  }

  #columns(component: ComponentName, isAxial: boolean): Axes {
    const { graph, environment } = this;
    return eachAxis((i) => {
      const isAbsent = environment.dimensions === 2 && (isAxial ? i < 2 : i === 2);
      return isAbsent ? graph.zero : environment.column(component, 'xyz'[i], 'real');
    });
  }

  #rotate(v: Axes): Axes {
    const { graph, environment } = this;
    const column = (component: ComponentName, field: string) => environment.column(component, field, 'real');
    if (environment.dimensions === 2) return rotateInPlane(graph, column('Rotation', 'angle'), v);
    const [x, y, z, w] = ['x', 'y', 'z', 'w'].map((field) => column('Orientation', field));
    return rotateInSpace(graph, [x, y, z], w, v);
  }

  #sum(scope: SumScope, term: Node): Node {
    const [address, count] = [0, 1].map((i) => this.environment.parameter(scope.table, i));
    return this.graph.sum(this.#scopeOf(scope), address, count, term);
  }

  /**
   * Each evaluation of a law has a separate loop over the rows, because a later stage depends on the result of an
   * earlier one.
   */
  #scopeOf(scope: SumScope): SumScope {
    const copy = this.#scopes.get(scope) ?? new SumScope(scope.table);
    this.#scopes.set(scope, copy);
    return copy;
  }
}
