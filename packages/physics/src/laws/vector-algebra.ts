// Vectors as three nodes: in 2D the z of most vectors is a zero that the graph omits from every product.
import type { Graph } from './graph.ts';
import type { Node } from './node.ts';

/** The three components of a vector. */
export type Axes = readonly [x: Node, y: Node, z: Node];

export function eachAxis(make: (i: 0 | 1 | 2) => Node): Axes {
  return [make(0), make(1), make(2)];
}

/** Sums the products in the order of the axes. */
export function dot(graph: Graph, a: Axes, b: Axes): Node {
  const [x, y, z] = eachAxis((i) => graph.make('mul', [a[i], b[i]]));
  return graph.make('add', [graph.make('add', [x, y]), z]);
}

export function lengthOf(graph: Graph, v: Axes): Node {
  return graph.make('sqrt', [dot(graph, v, v)]);
}

export function cross(graph: Graph, a: Axes, b: Axes): Axes {
  const minor = (i: number, j: number) =>
    graph.make('sub', [graph.make('mul', [a[i], b[j]]), graph.make('mul', [a[j], b[i]])]);
  return [minor(1, 2), minor(2, 0), minor(0, 1)];
}

/** v / |v|, and zero where |v| is zero. */
export function normalize(graph: Graph, v: Axes): Axes {
  const length = lengthOf(graph, v);
  const isLong = graph.make('less', [graph.constant(0), length]);
  return eachAxis((i) => graph.make('keep', [isLong, graph.make('div', [v[i], length])]));
}

/** Rotates by an angle in the plane. */
export function rotateInPlane(graph: Graph, angle: Node, v: Axes): Axes {
  const [c, s] = [graph.make('cos', [angle]), graph.make('sin', [angle])];
  const times = (a: Node, b: Node) => graph.make('mul', [a, b]);
  return [
    graph.make('sub', [times(v[0], c), times(v[1], s)]),
    graph.make('add', [times(v[0], s), times(v[1], c)]),
    v[2],
  ];
}

/** Rotates by the unit quaternion (u, w): v + 2 u × (u × v + w v). */
export function rotateInSpace(graph: Graph, u: Axes, w: Node, v: Axes): Axes {
  const turned = cross(graph, u, v);
  const inner = eachAxis((i) => graph.make('add', [turned[i], graph.make('mul', [w, v[i]])]));
  const outer = cross(graph, u, inner);
  return eachAxis((i) => graph.make('add', [v[i], graph.make('mul', [graph.constant(2), outer[i]])]));
}
