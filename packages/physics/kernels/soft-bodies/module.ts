// Wind on cloths and gas in soft bodies. A separate module, so that games without them do not load it.
export { enclosed, inflateEdges, inflateTriangles } from './gas';
export { addWindForces } from './wind';
