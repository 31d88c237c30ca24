/**
 * GLSL of lines of a constant width in pixels with smooth edges: every segment is a quad of six vertices without
 * attributes. The shader that uses it supplies `segmentEnds`, which says where segment `i` lies.
 */

/** Declarations before the `segmentEnds` of the application of this shader. */
export const wideLinePars = /* glsl */ `
#include <common>
#include <logdepthbuf_pars_vertex>
uniform vec2 targetSize;  // device pixels
uniform float lineWidth;  // device pixels
varying vec4 vLineColor;  // linear
varying float vAcross;    // device pixels from the middle of the line

vec4 lineColor(uint bytes) {
  vec4 color = vec4(uvec4(bytes, bytes >> 8, bytes >> 16, bytes >> 24) & 255u) / 255.0;
  vec3 linear = mix(pow((color.rgb + 0.055) / 1.055, vec3(2.4)), color.rgb / 12.92, lessThanEqual(color.rgb, vec3(0.04045)));
  return vec4(linear, color.a);
}
`;

/**
 * `main`; needs `bool segmentEnds(int i, out vec3 a, out vec3 b, out vec4 colorA, out vec4 colorB)`, false for none,
 * and a constant `endReach`, how far a segment reaches beyond its ends, in widths.
 */
export const wideLineMain = /* glsl */ `
/** Cuts what lies behind the eye off \`behind\`, where a projection would turn it inside out. */
void trimToNear(vec3 before, inout vec3 behind, vec4 colorBefore, inout vec4 colorBehind) {
  #ifdef USE_REVERSED_DEPTH_BUFFER
    float near = -projectionMatrix[3][2] / (projectionMatrix[2][2] + 1.0);
  #else
    float near = -0.5 * projectionMatrix[3][2] / projectionMatrix[2][2];
  #endif
  float share = clamp((near - before.z) / (behind.z - before.z), 0.0, 1.0);
  behind = mix(before, behind, share);
  colorBehind = mix(colorBefore, colorBehind, share);
}

void main() {
  const int corners[6] = int[6](0, 1, 2, 2, 1, 3);
  int corner = corners[gl_VertexID % 6];
  vec3 a, b;
  vec4 colorA, colorB;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (!segmentEnds(gl_VertexID / 6, a, b, colorA, colorB)) return;
  a = (modelViewMatrix * vec4(a, 1.0)).xyz;
  b = (modelViewMatrix * vec4(b, 1.0)).xyz;
  if (isPerspectiveMatrix(projectionMatrix)) {
    if (a.z >= 0.0 && b.z >= 0.0) return;
    if (b.z >= 0.0) trimToNear(a, b, colorA, colorB);
    if (a.z >= 0.0) trimToNear(b, a, colorB, colorA);
  }
  vec4 clipA = projectionMatrix * vec4(a, 1.0);
  vec4 clipB = projectionMatrix * vec4(b, 1.0);
  vec2 along = (clipB.xy / clipB.w - clipA.xy / clipA.w) * targetSize;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  bool atB = corner >= 2;
  vAcross = (float(corner & 1) * 2.0 - 1.0) * (0.5 * lineWidth + 1.0);
  vLineColor = atB ? colorB : colorA;
  gl_Position = atB ? clipB : clipA;
  vec2 pixels = vec2(-along.y, along.x) * vAcross + along * ((atB ? endReach : -endReach) * lineWidth);
  gl_Position.xy += pixels * 2.0 / targetSize * gl_Position.w;
  #include <logdepthbuf_vertex>
}
`;

export const wideLineFragment = /* glsl */ `
#include <common>
#include <logdepthbuf_pars_fragment>
uniform float lineWidth;
varying vec4 vLineColor;
varying float vAcross;

void main() {
  #include <logdepthbuf_fragment>
  // A line thinner than a pixel gets fainter instead, or it would break up into dots.
  float width = max(lineWidth, 1.0);
  float coverage = clamp(0.5 * width + 0.5 - abs(vAcross), 0.0, 1.0) * min(lineWidth, 1.0);
  gl_FragColor = vec4(vLineColor.rgb, vLineColor.a * coverage);
  #include <colorspace_fragment>
}
`;
