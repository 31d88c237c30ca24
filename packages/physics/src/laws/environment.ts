import type { ComponentSpec } from '../components/define.ts';
import type { Parameter } from '../world/types.ts';
import type { ColumnData } from './body-symbols.ts';
import type { Node } from './node.ts';
import type { StageData } from './scheme.ts';
import type { Axes } from './vector-algebra.ts';

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
  isAbsent?(component: ColumnData['component']): boolean;
  /** The bit of a component of the user in the second word of membership. */
  ownBit(component: ComponentSpec): number;
  /** Noise from the seed of the law. */
  noise(seed: Node, channel: number): Node;
}
