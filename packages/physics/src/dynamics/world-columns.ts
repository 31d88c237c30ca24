// The columns and parameters of a world as leaves of a graph: binds the names used by laws to a world.

import { ownBit, ownColumns } from '../ecs/own-components.ts';
import { MOVABLE } from '../ecs/partial-entities.ts';
import type { ColumnData } from '../laws/body-symbols.ts';
import type { Environment } from '../laws/environment.ts';
import { Graph } from '../laws/graph.ts';
import type { Store } from '../laws/loop-source.ts';
import type { Node } from '../laws/node.ts';
import type { Axes } from '../laws/vector-algebra.ts';
import { AXES } from '../memory/axes.ts';
import type { AxisAddresses } from '../memory/columns.ts';
import type { Parameter, PhysicsWorld } from '../world/types.ts';
import type { ParameterBlock, ParameterOwner } from './parameter-block.ts';

/** A graph over the columns of one world. */
export class WorldColumns {
  readonly graph = new Graph();
  readonly mass: Node;
  /** The body has mass and, in a world with partial entities, a position and a velocity. */
  readonly isMovable: Node;

  constructor(
    readonly world: PhysicsWorld,
    readonly block: ParameterBlock,
    readonly ownerOf: (force: object) => ParameterOwner,
  ) {
    const { graph } = this;
    this.mass = graph.make('real', [], world.addresses.Mass.value);
    const hasMass = graph.make('less', [graph.constant(0), this.mass]);
    const isPartial = world.internal.partialEntities.immovable > 0;
    this.isMovable = isPartial ? graph.make('and', [hasMass, this.#has(MOVABLE)]) : hasMass;
  }

  get dt(): Node {
    return this.load(this.block.dt);
  }

  load(address: number): Node {
    return this.graph.make('load', [], address);
  }

  /** Three columns; in 2D z is undefined. */
  axes(at: Readonly<AxisAddresses>): Axes {
    const { graph } = this;
    const column = (address: number) => graph.make('real', [], address);
    return [column(at.x), column(at.y), this.world.dimensions === 2 ? graph.zero : column(at.z)];
  }

  /** The time at `fraction` of a step, or of a part of it, after its start. */
  timeAt(fraction: number, length = this.dt): Node {
    const { graph, block } = this;
    const start = this.load(block.time);
    if (fraction === 0) return start;
    return graph.make('add', [start, graph.make('mul', [graph.constant(fraction), length])]);
  }

  environment(owner: object, vectors: Readonly<Record<string, Axes>>, time: Node, stage: number): Environment {
    const { block, graph } = this;
    const parameters = this.ownerOf(owner);
    return {
      dimensions: this.world.dimensions,
      vectors,
      time,
      dt: this.dt,
      parameter: (parameter: Parameter, index) => {
        const source = parameters.sources[parameters.parameters.indexOf(parameter)];
        if (source.zeros?.[index] === true) return graph.zero;
        return this.load(block.addressOf(parameters, parameter, index, stage));
      },
      column: (component, field, kind) => this.#column(component, field, kind),
      ownBit: (component) => ownBit(this.world, component),
      // A world whose first body gets a GravityScale makes a new plan, and with it this code anew.
      isAbsent: (name) => name === 'GravityScale' && this.world.internal.counts.GravityScale === 0,
      noise: (seed, channel) => graph.make('noise', [seed, this.load(block.tick)], channel),
    };
  }

  /** The axes of positions and velocities, by which their addresses are named. */
  get axisNames(): readonly ('x' | 'y' | 'z')[] {
    return AXES[this.world.dimensions];
  }

  /** In 2D a torque has a z component only. */
  torqueStores(torque: Axes): Store[] {
    const { x, y, z } = this.world.scratch.at.torque;
    const aboutZ = { address: z, node: torque[2] };
    if (this.world.dimensions === 2) return [aboutZ];
    return [aboutZ, { address: x, node: torque[0] }, { address: y, node: torque[1] }];
  }

  #has(bits: number): Node {
    return this.graph.make('has', [this.#column('', 'members', 'u32')], bits);
  }

  #column(component: ColumnData['component'] | '', field: string, kind: 'real' | 'u32'): Node {
    return this.graph.make(kind === 'real' ? 'real' : 'word', [], addressOf(this.world, component, field));
  }
}

/** The component '' stands for the columns of component bits. */
function addressOf(world: PhysicsWorld, component: ColumnData['component'] | '', field: string): number {
  if (component === '') return field === 'members' ? world.internal.membersAt : world.internal.moreMembersAt;
  if (typeof component !== 'string') return ownColumns(world, component).addresses[field];
  return (world.addresses[component] as Readonly<Record<string, number>>)[field];
}
