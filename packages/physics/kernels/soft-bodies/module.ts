// What blows on networks of springs and fills them: a module of its own, so that a game without them does not pay.
export { enclosed, inflateEdges, inflateTriangles } from './gas';
export { blowTriangles } from './wind';
