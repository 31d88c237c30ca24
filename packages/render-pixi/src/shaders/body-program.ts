import { OUTLINE_TEXELS } from '@principia/render-core';
import type { PullProgram } from './pull-program.ts';

const TAU = '6.283185307179586';

const glslVertex = `
const int OUTLINE = ${OUTLINE_TEXELS};
flat out vec4 vColor;
flat out float vPixels;
flat out int vShape;
flat out int vOutline;
flat out float vScale;
flat out float vRim;
out vec2 vLocal;

/** The angle shown now: from the former to the present one along the shorter way. */
float shownAngle(int id) {
  float from = real(uPreviousAngle, id);
  float turn = real(uAngle, id) - from;
  turn -= ${TAU} * floor(turn / ${TAU} + 0.5);
  float angle = from + turn * uAlpha;
  return angle - ${TAU} * floor(angle / ${TAU});
}

void main() {
  int id = int(whole(uIds, gl_VertexID >> 2));
  float size = real(uSize, id);
  float radius = size > 0.0 ? size : real(uRadius, id);
  float scale = pixelsPerMetre();
  float pixels = max(radius * scale, uMinimumPixels);
  // One pixel beyond the rim, so that its soft edge is inside the quad.
  vec2 corner = vec2(float(gl_VertexID & 1), float((gl_VertexID >> 1) & 1)) * 2.0 - 1.0;
  vLocal = corner * (1.0 + 1.0 / pixels);
  vPixels = pixels;
  vShape = int(whole(uShape, id));
  int outline = OUTLINE * int(whole(uOutline, id));
  float extent = outline > 0 ? real(uOutlines, outline + 2) : radius;
  vOutline = outline;
  vScale = pixels / max(extent, 1e-30);
  vRim = uRim * pixelRatio();
  uint bytes = whole(uBodyColor, id);
  vColor = tinted(bytes == 0u ? uDefaultColor : rgba(bytes));
  float angle = shownAngle(id);
  float c = cos(angle);
  float s = sin(angle);
  vec2 from = vec2(real(uPreviousX, id), real(uPreviousY, id));
  vec2 to = vec2(real(uX, id), real(uY, id));
  vec2 turned = vec2(c * vLocal.x - s * vLocal.y, s * vLocal.x + c * vLocal.y);
  gl_Position = radius > 0.0 ? clip(mix(from, to, uAlpha) + turned * (pixels / scale)) : NOWHERE;
}
`;

const glslFragment = `
flat in vec4 vColor;
flat in float vPixels;
flat in int vShape;
flat in int vOutline;
flat in float vScale;
flat in float vRim;
in vec2 vLocal;

/** How much of a pixel lies inside an edge that is \`distance\` pixels away, negative inside. */
float inside(float distance) { return clamp(0.5 - distance, 0.0, 1.0); }

vec2 corner(int i) {
  return vScale * vec2(real(uOutlines, vOutline + 4 + 2 * i), real(uOutlines, vOutline + 5 + 2 * i));
}

/** Distance from the outline of the collider, pixels: from the nearest of its edges, less the rounding. */
float outlineDistance(vec2 p) {
  int count = int(real(uOutlines, vOutline));
  float nearest = 1e30;
  bool isInside = count > 2;
  vec2 start = corner(count - 1);
  for (int i = 0; i < count; i++) {
    vec2 end = corner(i);
    vec2 edge = end - start;
    vec2 from = p - start;
    vec2 off = from - edge * clamp(dot(from, edge) / dot(edge, edge), 0.0, 1.0);
    nearest = min(nearest, dot(off, off));
    if (edge.x * from.y - edge.y * from.x < 0.0) isInside = false;
    start = end;
  }
  float rounding = real(uOutlines, vOutline + 1) * vScale;
  // A segment has no width, and is drawn as a thin line.
  return (isInside ? -sqrt(nearest) : sqrt(nearest)) - (count > 2 ? rounding : max(rounding, 0.75));
}

void main() {
  float r = length(vLocal);
  float distance = vOutline > 0 ? outlineDistance(vLocal * vPixels) : (r - 1.0) * vPixels;
  float cover = inside(distance);
  // How much of the pixel lies inside of the rim.
  float core = inside(distance + vRim);
  vec3 rgb = vColor.rgb;
  if (vShape == 1) {
    cover *= 1.0 - inside(distance + max((vOutline > 0 ? 0.05 : 0.14) * vPixels, 1.5));
  } else if (vShape == 2) {
    vec2 edge = (abs(vLocal) - 1.0) * vPixels;
    cover = inside(edge.x) * inside(edge.y);
    core = inside(edge.x + vRim) * inside(edge.y + vRim);
  } else if (vShape == 3) {
    float line = inside(abs(vLocal.y) * vPixels - max(0.07 * vPixels, 0.75)) * inside(-vLocal.x * vPixels);
    float luminance = dot(rgb, vec3(0.299, 0.587, 0.114));
    vec3 mark = luminance > 0.35 * vColor.a ? rgb * 0.3 : mix(rgb, vec3(vColor.a), 0.6);
    rgb = mix(rgb, mark, line);
  } else if (vShape == 4) {
    float glow = max(0.0, 1.0 - r * r);
    cover = glow * glow;
  }
  if (cover <= 0.0) discard;
  if (vRim > 0.0 && vShape != 1 && vShape != 4) rgb = mix(0.45 * vColor.rgb, rgb, core);
  finalColor = vec4(rgb, vColor.a) * cover;
}
`;

const wgsl = `
const OUTLINE = ${OUTLINE_TEXELS};
struct Varyings {
  @builtin(position) position: vec4<f32>,
  @location(0) @interpolate(flat) color: vec4<f32>,
  @location(1) @interpolate(flat) pixels: f32,
  @location(2) @interpolate(flat) shape: i32,
  @location(3) local: vec2<f32>,
  @location(4) @interpolate(flat) outline: i32,
  @location(5) @interpolate(flat) scale: f32,
  @location(6) @interpolate(flat) rim: f32,
}

fn shownAngle(id: i32) -> f32 {
  let start = real(uPreviousAngle, id);
  var turn = real(uAngle, id) - start;
  turn -= ${TAU} * floor(turn / ${TAU} + 0.5);
  let angle = start + turn * own.uAlpha;
  return angle - ${TAU} * floor(angle / ${TAU});
}

@vertex
fn mainVertex(@builtin(vertex_index) vertex: u32) -> Varyings {
  let index = i32(vertex);
  let id = i32(whole(uIds, index >> 2u));
  let size = real(uSize, id);
  let radius = select(real(uRadius, id), size, size > 0.0);
  let scale = pixelsPerMetre();
  let pixels = max(radius * scale, own.uMinimumPixels);
  let corner = vec2<f32>(f32(index & 1), f32((index >> 1u) & 1)) * 2.0 - 1.0;
  let bytes = whole(uBodyColor, id);
  var out: Varyings;
  out.local = corner * (1.0 + 1.0 / pixels);
  out.pixels = pixels;
  out.shape = i32(whole(uShape, id));
  out.outline = OUTLINE * i32(whole(uOutline, id));
  out.scale = pixels / max(select(radius, real(uOutlines, out.outline + 2), out.outline > 0), 1e-30);
  out.rim = own.uRim * pixelRatio();
  out.color = tinted(select(rgba(bytes), own.uDefaultColor, bytes == 0u));
  let angle = shownAngle(id);
  let c = cos(angle);
  let s = sin(angle);
  let start = vec2<f32>(real(uPreviousX, id), real(uPreviousY, id));
  let end = vec2<f32>(real(uX, id), real(uY, id));
  let turned = vec2<f32>(c * out.local.x - s * out.local.y, s * out.local.x + c * out.local.y);
  let placed = clip(mix(start, end, own.uAlpha) + turned * (pixels / scale));
  out.position = select(NOWHERE, placed, radius > 0.0);
  return out;
}

fn inside(distance: f32) -> f32 { return clamp(0.5 - distance, 0.0, 1.0); }

fn corner(outline: i32, scale: f32, i: i32) -> vec2<f32> {
  return scale * vec2<f32>(real(uOutlines, outline + 4 + 2 * i), real(uOutlines, outline + 5 + 2 * i));
}

fn outlineDistance(p: vec2<f32>, outline: i32, scale: f32) -> f32 {
  let count = i32(real(uOutlines, outline));
  var nearest = 1e30;
  var isInside = count > 2;
  var start = corner(outline, scale, count - 1);
  for (var i = 0; i < count; i++) {
    let end = corner(outline, scale, i);
    let edge = end - start;
    let away = p - start;
    let off = away - edge * clamp(dot(away, edge) / dot(edge, edge), 0.0, 1.0);
    nearest = min(nearest, dot(off, off));
    if (edge.x * away.y - edge.y * away.x < 0.0) { isInside = false; }
    start = end;
  }
  let rounding = real(uOutlines, outline + 1) * scale;
  return select(sqrt(nearest), -sqrt(nearest), isInside) - select(max(rounding, 0.75), rounding, count > 2);
}

@fragment
fn mainFragment(in: Varyings) -> @location(0) vec4<f32> {
  let r = length(in.local);
  var distance = (r - 1.0) * in.pixels;
  if (in.outline > 0) { distance = outlineDistance(in.local * in.pixels, in.outline, in.scale); }
  var cover = inside(distance);
  var core = inside(distance + in.rim);
  var rgb = in.color.rgb;
  if (in.shape == 1) {
    cover *= 1.0 - inside(distance + max(select(0.14, 0.05, in.outline > 0) * in.pixels, 1.5));
  } else if (in.shape == 2) {
    let edge = (abs(in.local) - 1.0) * in.pixels;
    cover = inside(edge.x) * inside(edge.y);
    core = inside(edge.x + in.rim) * inside(edge.y + in.rim);
  } else if (in.shape == 3) {
    let line = inside(abs(in.local.y) * in.pixels - max(0.07 * in.pixels, 0.75)) * inside(-in.local.x * in.pixels);
    let luminance = dot(rgb, vec3<f32>(0.299, 0.587, 0.114));
    let mark = select(mix(rgb, vec3<f32>(in.color.a), 0.6), rgb * 0.3, luminance > 0.35 * in.color.a);
    rgb = mix(rgb, mark, line);
  } else if (in.shape == 4) {
    let glow = max(0.0, 1.0 - r * r);
    cover = glow * glow;
  }
  if (cover <= 0.0) { discard; }
  if (in.rim > 0.0 && in.shape != 1 && in.shape != 4) { rgb = mix(0.45 * in.color.rgb, rgb, core); }
  return vec4<f32>(rgb, in.color.a) * cover;
}
`;

/**
 * Draws bodies as quads, four vertices each, and cuts the shape out of each quad by its distance to the edge. Corners
 * are in units of the drawn radius, so a pixel's distance to the rim is a length times `pixels`. Outlines of colliders
 * are read by the index of the collider's shape, from a texture of their vertices.
 */
export const BODY_PROGRAM: PullProgram = {
  name: 'principia-bodies',
  textures: {
    uIds: 'whole',
    uX: 'real',
    uY: 'real',
    uPreviousX: 'real',
    uPreviousY: 'real',
    uAngle: 'real',
    uPreviousAngle: 'real',
    uRadius: 'real',
    uSize: 'real',
    uBodyColor: 'whole',
    uShape: 'whole',
    uOutline: 'whole',
    uOutlines: 'real',
  },
  fragmentTextures: ['uOutlines'],
  uniforms: { uDefaultColor: 'vec4<f32>', uAlpha: 'f32', uMinimumPixels: 'f32', uRim: 'f32' },
  glsl: { vertex: glslVertex, fragment: glslFragment },
  wgsl,
};
