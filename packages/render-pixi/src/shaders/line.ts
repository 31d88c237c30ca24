/**
 * Thick lines with soft edges, shared by the programs that draw them. A line's quad reaches one pixel beyond its
 * outline, and the fragment stage cuts it out by the distance to the axis, so ends are round. `vPoint` is the place
 * along and across the axis in physical pixels, `vLength` the length of the axis, `vHalf` half the width.
 */

/** Varyings of the vertex stage and `drawLine(a, b, width)`: metres, metres, physical pixels. */
export const GLSL_LINE_VERTEX = `
out vec4 vColor;
out vec2 vPoint;
out float vHalf;
flat out float vLength;

/** Lines thinner than a pixel are drawn a pixel wide and fainter instead. */
vec4 thinned(vec4 c, float width) { return c * min(width, 1.0); }

void drawLine(vec2 a, vec2 b, float width) {
  float scale = pixelsPerMetre();
  float span = length(b - a);
  vec2 along = span > 0.0 ? (b - a) / span : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float end = float((gl_VertexID >> 1) & 1);
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  vHalf = max(0.5 * width, 0.5);
  float reach = vHalf + 1.0;
  float beyond = (end * 2.0 - 1.0) * reach;
  vLength = span * scale;
  vPoint = vec2(end * vLength + beyond, side * reach);
  gl_Position = clip(mix(a, b, end) + (along * beyond + across * vPoint.y) / scale);
}
`;

export const GLSL_LINE_FRAGMENT = `
in vec4 vColor;
in vec2 vPoint;
in float vHalf;
flat in float vLength;

void main() {
  float distance = length(vec2(vPoint.x - clamp(vPoint.x, 0.0, vLength), vPoint.y));
  float cover = clamp(vHalf + 0.5 - distance, 0.0, 1.0);
  if (cover <= 0.0) discard;
  finalColor = vColor * cover;
}
`;

/** The same for WGSL; `drawLine` also takes the vertex number and the colour and returns the varyings. */
export const WGSL_LINE = `
struct Varyings {
  @builtin(position) position: vec4<f32>,
  @location(0) color: vec4<f32>,
  @location(1) point: vec2<f32>,
  @location(2) half: f32,
  @location(3) @interpolate(flat) span: f32,
}

fn thinned(c: vec4<f32>, width: f32) -> vec4<f32> { return c * min(width, 1.0); }

fn drawLine(a: vec2<f32>, b: vec2<f32>, width: f32, index: i32, color: vec4<f32>) -> Varyings {
  let scale = pixelsPerMetre();
  let span = length(b - a);
  var along = vec2<f32>(1.0, 0.0);
  if (span > 0.0) { along = (b - a) / span; }
  let across = vec2<f32>(-along.y, along.x);
  let end = f32((index >> 1u) & 1);
  let side = f32(index & 1) * 2.0 - 1.0;
  var out: Varyings;
  out.half = max(0.5 * width, 0.5);
  let reach = out.half + 1.0;
  let beyond = (end * 2.0 - 1.0) * reach;
  out.span = span * scale;
  out.point = vec2<f32>(end * out.span + beyond, side * reach);
  out.position = clip(mix(a, b, end) + (along * beyond + across * out.point.y) / scale);
  out.color = thinned(color, width);
  return out;
}

@fragment
fn mainFragment(in: Varyings) -> @location(0) vec4<f32> {
  let distance = length(vec2<f32>(in.point.x - clamp(in.point.x, 0.0, in.span), in.point.y));
  let cover = clamp(in.half + 0.5 - distance, 0.0, 1.0);
  if (cover <= 0.0) { discard; }
  return in.color * cover;
}
`;
