// Contacts of circles and of polygons without rounding.
import { Shape, nextVertex, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { Manifold } from './manifold';

let bestEdge: i32 = 0;
let bestSeparation: real = 0;

export function collideShapes(m: Manifold, a: Shape, b: Shape): void {
  m.count = 0;
  if (a.count == 1 && b.count == 1) return circles(m, a.radius, b.radius);
  if (a.count == 1) {
    flip(m);
    circlePolygon(m, b, a.radius);
    flip(m);
    m.nx = -m.nx;
    m.ny = -m.ny;
    return;
  }
  if (b.count == 1) return circlePolygon(m, a, b.radius);
  polygons(m, a, b);
}

function flip(m: Manifold): void {
  const x = m.ax;
  const y = m.ay;
  const c = m.ac;
  const s = m.as;
  m.ax = m.bx;
  m.ay = m.by;
  m.ac = m.bc;
  m.as = m.bs;
  m.bx = x;
  m.by = y;
  m.bc = c;
  m.bs = s;
}

function circles(m: Manifold, ra: real, rb: real): void {
  const dx = m.bx - m.ax;
  const dy = m.by - m.ay;
  const d = sqrt<real>(dx * dx + dy * dy);
  m.nx = d > 0 ? dx / d : 1;
  m.ny = d > 0 ? dy / d : 0;
  m.separation0 = d - ra - rb;
  if (m.separation0 > m.speculative) return;
  const k = ra + <real>0.5 * m.separation0;
  m.x0 = m.ax + m.nx * k;
  m.y0 = m.ay + m.ny * k;
  m.id0 = 0;
  m.count = 1;
}

function circlePolygon(m: Manifold, a: Shape, rb: real): void {
  const wx = m.bx - m.ax;
  const wy = m.by - m.ay;
  const px = m.ac * wx + m.as * wy;
  const py = m.ac * wy - m.as * wx;
  let best = -<real>Infinity;
  let edge = 0;
  for (let i = 0; i < a.count; i++) {
    const s = (px - vertexX(a, i)) * normalX(a, i) + (py - vertexY(a, i)) * normalY(a, i);
    if (s > best) {
      best = s;
      edge = i;
    }
  }
  let nx = normalX(a, edge);
  let ny = normalY(a, edge);
  let d = best;
  const next = nextVertex(a, edge);
  const ex = vertexX(a, next) - vertexX(a, edge);
  const ey = vertexY(a, next) - vertexY(a, edge);
  const u = ((px - vertexX(a, edge)) * ex + (py - vertexY(a, edge)) * ey) / (ex * ex + ey * ey);
  if (best > 0 && (u < 0 || u > 1)) {
    const v = u < 0 ? edge : next;
    nx = px - vertexX(a, v);
    ny = py - vertexY(a, v);
    d = sqrt<real>(nx * nx + ny * ny);
    nx /= d;
    ny /= d;
  }
  m.separation0 = d - rb - a.radius;
  m.nx = m.ac * nx - m.as * ny;
  m.ny = m.as * nx + m.ac * ny;
  if (m.separation0 > m.speculative) return;
  const k = -(rb + <real>0.5 * m.separation0);
  m.x0 = m.bx + m.nx * k;
  m.y0 = m.by + m.ny * k;
  m.id0 = edge;
  m.count = 1;
}

// b's pose in a's frame.
let rx: real = 0;
let ry: real = 0;
let rc: real = 0;
let rs: real = 0;

function relate(m: Manifold): void {
  const dx = m.bx - m.ax;
  const dy = m.by - m.ay;
  rx = m.ac * dx + m.as * dy;
  ry = m.ac * dy - m.as * dx;
  rc = m.ac * m.bc + m.as * m.bs;
  rs = m.ac * m.bs - m.as * m.bc;
}

function findMax(a: Shape, b: Shape): void {
  bestSeparation = -<real>Infinity;
  for (let i = 0; i < a.count; i++) {
    let least = <real>Infinity;
    for (let j = 0; j < b.count; j++) {
      const x = rx + rc * vertexX(b, j) - rs * vertexY(b, j);
      const y = ry + rs * vertexX(b, j) + rc * vertexY(b, j);
      least = min<real>(least, (x - vertexX(a, i)) * normalX(a, i) + (y - vertexY(a, i)) * normalY(a, i));
    }
    if (least > bestSeparation) {
      bestSeparation = least;
      bestEdge = i;
    }
  }
}

function polygons(m: Manifold, a: Shape, b: Shape): void {
  relate(m);
  findMax(a, b);
  const edgeA = bestEdge;
  const separationA = bestSeparation;
  flip(m);
  relate(m);
  findMax(b, a);
  if (bestSeparation > separationA + <real>0.0005) {
    clip(m, b, a, bestEdge, 256);
    flip(m);
    m.nx = -m.nx;
    m.ny = -m.ny;
    return;
  }
  flip(m);
  relate(m);
  clip(m, a, b, edgeA, 0);
}

// a has the reference edge; b's pose relates to it.
function clip(m: Manifold, a: Shape, b: Shape, edge: i32, mark: u32): void {
  const nx = normalX(a, edge);
  const ny = normalY(a, edge);
  let most: real = <real>Infinity;
  let incident = 0;
  for (let j = 0; j < b.count; j++) {
    const bx = rc * normalX(b, j) - rs * normalY(b, j);
    const by = rs * normalX(b, j) + rc * normalY(b, j);
    const d = bx * nx + by * ny;
    if (d < most) {
      most = d;
      incident = j;
    }
  }
  const next = nextVertex(b, incident);
  const ax = vertexX(a, edge);
  const ay = vertexY(a, edge);
  const end = nextVertex(a, edge);
  const tx = -ny;
  const ty = nx;
  const length = (vertexX(a, end) - ax) * tx + (vertexY(a, end) - ay) * ty;
  let x1 = rx + rc * vertexX(b, incident) - rs * vertexY(b, incident);
  let y1 = ry + rs * vertexX(b, incident) + rc * vertexY(b, incident);
  let x2 = rx + rc * vertexX(b, next) - rs * vertexY(b, next);
  let y2 = ry + rs * vertexX(b, next) + rc * vertexY(b, next);
  let u1 = (x1 - ax) * tx + (y1 - ay) * ty;
  let u2 = (x2 - ax) * tx + (y2 - ay) * ty;
  if (max<real>(u1, u2) < 0 || min<real>(u1, u2) > length) return;
  let s1 = (x1 - ax) * nx + (y1 - ay) * ny;
  let s2 = (x2 - ax) * nx + (y2 - ay) * ny;
  const slope = (s2 - s1) / (u2 - u1);
  const v1 = min<real>(max<real>(u1, 0), length);
  const v2 = min<real>(max<real>(u2, 0), length);
  if (u2 != u1) {
    const base = s1 - slope * u1;
    s1 = base + slope * v1;
    s2 = base + slope * v2;
  }
  m.nx = m.ac * nx - m.as * ny;
  m.ny = m.as * nx + m.ac * ny;
  if (mark != 0) {
    m.nx = m.nx;
  }
  m.count = 0;
  put(m, a, edge, incident, v1, s1, mark);
  put(m, a, edge, next, v2, s2, mark);
}

function put(m: Manifold, a: Shape, edge: i32, vertex: i32, u: real, s: real, mark: u32): void {
  if (s > m.speculative) return;
  const nx = normalX(a, edge);
  const ny = normalY(a, edge);
  const lx = vertexX(a, edge) - ny * u + nx * s * <real>0.5;
  const ly = vertexY(a, edge) + nx * u + ny * s * <real>0.5;
  const x = m.ax + m.ac * lx - m.as * ly;
  const y = m.ay + m.as * lx + m.ac * ly;
  const id = mark | (edge << 4) | vertex;
  if (m.count == 0) {
    m.x0 = x;
    m.y0 = y;
    m.separation0 = s;
    m.id0 = id;
  } else {
    m.x1 = x;
    m.y1 = y;
    m.separation1 = s;
    m.id1 = id;
  }
  m.count++;
}
