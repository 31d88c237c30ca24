import { GLSL_LINE_FRAGMENT, GLSL_LINE_VERTEX, WGSL_LINE } from './line.ts';
import type { PullProgram } from './pull-program.ts';

const glslVertex = `${GLSL_LINE_VERTEX}
/**
 * Point \`k\` of a trail: 0 is where the body is shown now, higher numbers are older recordings. The recording of the
 * present pose is skipped, because the body is still on its way there. \`z\` is 1 where there is such a point.
 */
vec3 point(int id, int slot, int k) {
  if (k == 0) {
    vec2 from = vec2(real(uPreviousX, id), real(uPreviousY, id));
    return vec3(mix(from, vec2(real(uX, id), real(uY, id)), uAlpha), 1.0);
  }
  int age = k - 1 + uSkip;
  int number = uRecordings - 1 - age;
  if (age >= uLength || number < int(whole(uBirth, slot))) return vec3(0.0);
  int slice = (uNewestSlice - age + uLength) % uLength;
  int i = slice * uSliceTexels + slot;
  return vec3(real(uHistoryX, i), real(uHistoryY, i), 1.0);
}

bool joined(vec3 a, vec3 b) { return a.z * b.z > 0.0 && distance(a.xy, b.xy) <= uMaxSegment; }

void main() {
  int slot = int(whole(uSlots, gl_VertexID >> 2));
  int id = uIndirect == 1 ? int(whole(uBodies, slot)) : slot;
  int segment = gl_InstanceID;
  int end = (gl_VertexID >> 1) & 1;
  float side = float(gl_VertexID & 1) * 2.0 - 1.0;
  int k = segment + end;
  vec3 here = point(id, slot, k);
  vec3 mate = point(id, slot, segment + 1 - end);
  if (!joined(here, mate)) {
    gl_Position = NOWHERE;
    return;
  }
  // Both segments that meet in a point use the same direction there, so their outlines meet too.
  vec3 beyond = here;
  if (k > 0 && k < uLength - 1) beyond = point(id, slot, end == 0 ? k - 1 : k + 1);
  if (!joined(here, beyond)) beyond = here;
  vec2 along = end == 0 ? mate.xy - beyond.xy : beyond.xy - mate.xy;
  float span = length(along);
  along = span > 0.0 ? along / span : vec2(1.0, 0.0);
  float remaining = 1.0 - float(k) / float(uLength - 1);
  float width = uThickness * pixelRatio() * (0.3 + 0.7 * remaining);
  vHalf = max(0.5 * width, 0.5);
  vLength = 0.0;
  vPoint = vec2(0.0, side * (vHalf + 1.0));
  gl_Position = clip(here.xy + vec2(-along.y, along.x) * (vPoint.y / pixelsPerMetre()));
  uint bytes = whole(uBodyColor, id);
  vec4 color = uOwnColor == 1 || bytes == 0u ? uTrailColor : rgba(bytes);
  vColor = thinned(tinted(color), width) * (remaining * uOpacity);
}
`;

const wgsl = `${WGSL_LINE}
fn trailPoint(id: i32, slot: i32, k: i32) -> vec3<f32> {
  if (k == 0) {
    let start = vec2<f32>(real(uPreviousX, id), real(uPreviousY, id));
    return vec3<f32>(mix(start, vec2<f32>(real(uX, id), real(uY, id)), own.uAlpha), 1.0);
  }
  let age = k - 1 + own.uSkip;
  let number = own.uRecordings - 1 - age;
  if (age >= own.uLength || number < i32(whole(uBirth, slot))) { return vec3<f32>(0.0); }
  let slice = (own.uNewestSlice - age + own.uLength) % own.uLength;
  let i = slice * own.uSliceTexels + slot;
  return vec3<f32>(real(uHistoryX, i), real(uHistoryY, i), 1.0);
}

fn joined(a: vec3<f32>, b: vec3<f32>) -> bool {
  return a.z * b.z > 0.0 && distance(a.xy, b.xy) <= own.uMaxSegment;
}

@vertex
fn mainVertex(@builtin(vertex_index) vertex: u32, @builtin(instance_index) instance: u32) -> Varyings {
  let index = i32(vertex);
  let segment = i32(instance);
  let slot = i32(whole(uSlots, index >> 2u));
  var id = slot;
  if (own.uIndirect == 1) { id = i32(whole(uBodies, slot)); }
  let end = (index >> 1u) & 1;
  let side = f32(index & 1) * 2.0 - 1.0;
  let k = segment + end;
  let here = trailPoint(id, slot, k);
  let mate = trailPoint(id, slot, segment + 1 - end);
  var out: Varyings;
  if (!joined(here, mate)) {
    out.position = NOWHERE;
    return out;
  }
  var beyond = here;
  if (k > 0 && k < own.uLength - 1) { beyond = trailPoint(id, slot, select(k + 1, k - 1, end == 0)); }
  if (!joined(here, beyond)) { beyond = here; }
  var along = select(beyond.xy - mate.xy, mate.xy - beyond.xy, end == 0);
  let span = length(along);
  if (span > 0.0) { along = along / span; } else { along = vec2<f32>(1.0, 0.0); }
  let remaining = 1.0 - f32(k) / f32(own.uLength - 1);
  let width = own.uThickness * pixelRatio() * (0.3 + 0.7 * remaining);
  out.half = max(0.5 * width, 0.5);
  out.span = 0.0;
  out.point = vec2<f32>(0.0, side * (out.half + 1.0));
  out.position = clip(here.xy + vec2<f32>(-along.y, along.x) * (out.point.y / pixelsPerMetre()));
  let bytes = whole(uBodyColor, id);
  let color = select(rgba(bytes), own.uTrailColor, own.uOwnColor == 1 || bytes == 0u);
  out.color = thinned(tinted(color), width) * (remaining * own.uOpacity);
  return out;
}
`;

/** Draws fading trails out of a history texture: one instance per segment of the trails, one quad in it per body. */
export const TRAIL_PROGRAM: PullProgram = {
  name: 'principia-trails',
  textures: {
    uSlots: 'whole',
    uBodies: 'whole',
    uX: 'real',
    uY: 'real',
    uPreviousX: 'real',
    uPreviousY: 'real',
    uBodyColor: 'whole',
    uHistoryX: 'real',
    uHistoryY: 'real',
    uBirth: 'whole',
  },
  uniforms: {
    uTrailColor: 'vec4<f32>',
    uAlpha: 'f32',
    uThickness: 'f32',
    uOpacity: 'f32',
    uMaxSegment: 'f32',
    uNewestSlice: 'i32',
    uRecordings: 'i32',
    uLength: 'i32',
    uSliceTexels: 'i32',
    uSkip: 'i32',
    uIndirect: 'i32',
    uOwnColor: 'i32',
  },
  glsl: { vertex: glslVertex, fragment: GLSL_LINE_FRAGMENT },
  wgsl,
};
