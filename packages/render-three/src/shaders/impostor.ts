/**
 * GLSL of sphere and box impostors: each body is one quad that covers its silhouette exactly, and the fragment shader
 * meets the true surface with the view ray, so depth, normal and outline are those of a perfect solid.
 */
import { SHAPES } from '@principia/render-core';
import { outlineSolid } from './outline-solid.ts';

/** Vertex declarations; `placeImpostor()` leaves the quad's corner in view space and the body in flat varyings. */
export const impostorVertexPars = /* glsl */ `
uniform highp usampler2D bodyIds;
uniform float pixelHeight;    // height of the drawing buffer, device pixels
uniform float minPixelRadius; // a body is drawn at least this large, device pixels

varying vec3 vCorner;              // corner of the quad, view space
flat varying vec4 vSphere;         // centre in view space, radius of the sphere (half-width of the box)
flat varying float vPerspective;   // 1 perspective, 0 parallel projection
flat varying vec4 vBodyColor;
flat varying uint vBodyShape;
flat varying uint vBodyOutline;
flat varying mat3 vBodyFrame;      // columns are the body's axes in view space

vec4 impostorCorner;  // view space
bool impostorVisible;

mat3 frameOf(vec4 q) { return mat3(turned(q, vec3(1, 0, 0)), turned(q, vec3(0, 1, 0)), turned(q, vec3(0, 0, 1))); }

void pullImpostor() {
  int slot = gl_VertexID >> 2;
  ivec2 at = cellOf(int(texelFetch(bodyIds, cellOf(slot), 0).r));
  pullStyle(at);
  impostorVisible = bodyRadius > 0.0 && drawsShape(bodyShape);
  bodyCentre = vec3(0.0);
  if (!impostorVisible) return;
  bodyCentre = pullCentre(at);
  // A plain ball looks the same however it is turned: spare the fetches.
  bool turns = bodyShape == ${SHAPES.box}u || bodyShape == ${SHAPES.markedDisc}u || bodyOutline > 0u;
  bodyTurn = turns ? pullTurn(at) : vec4(0.0, 0.0, 0.0, 1.0);
}

void placeImpostor() {
  impostorCorner = vec4(0.0);
  if (!impostorVisible) return;
  float scale = length(modelViewMatrix[0].xyz);
  vec3 centre = (modelViewMatrix * vec4(bodyCentre, 1.0)).xyz;
  bool perspective = isPerspectiveMatrix(projectionMatrix);
  float pixel = (perspective ? max(-centre.z, 0.0) : 1.0) * 2.0 / (projectionMatrix[1][1] * pixelHeight);
  float radius = max(bodyRadius * scale, minPixelRadius * pixel);
  // A solid of an outline is at most as thick as it is wide.
  float bound = radius * (bodyShape == ${SHAPES.box}u ? 1.7320508 : bodyOutline > 0u ? 1.4142136 : 1.0);
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1) * 2.0 - 1.0;
  // Half a pixel more than the silhouette, or the smoothed edge would be cut where the quad touches it.
  if (perspective) {
    float away = dot(centre, centre) - bound * bound;
    impostorVisible = away > 1e-4 * bound * bound; // the eye is outside
    float halfWidth = bound * inversesqrt(max(away, 1e-30)) * length(centre) + 0.75 * pixel;
    vec3 forward = normalize(centre);
    vec3 right = normalize(cross(forward, abs(forward.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    impostorCorner = vec4(centre + halfWidth * (corner.x * right + corner.y * cross(right, forward)), 1.0);
  } else {
    impostorCorner = vec4(centre.xy + corner * (bound + 0.75 * pixel), centre.z, 1.0);
  }
  vCorner = impostorCorner.xyz;
  vSphere = vec4(centre, radius);
  vPerspective = perspective ? 1.0 : 0.0;
  vBodyColor = bodyColor;
  vBodyShape = bodyShape;
  vBodyOutline = bodyOutline;
  vBodyFrame = mat3(modelViewMatrix) * frameOf(bodyTurn) / scale;
}
`;

/** Which shapes a pass draws: the lit solids, or the flat outlines and glows blended over them. */
export const drawsSolids = /* glsl */ `
bool drawsShape(uint shape) { return shape != ${SHAPES.ring}u && shape != ${SHAPES.glow}u; }
`;
export const drawsFlats = /* glsl */ `
bool drawsShape(uint shape) { return shape == ${SHAPES.ring}u || shape == ${SHAPES.glow}u; }
`;

/** Beach-ball pattern of a marked body; `p` is a point of the unit sphere in the body's own axes. */
export const beachBall = /* glsl */ `
vec3 beachBall(vec3 p, vec3 color) {
  float gores = p.x * (p.x * p.x - 3.0 * p.y * p.y); // cos 3φ · ρ³: six sectors about the body's z axis
  float cap = abs(p.z) - 0.94;
  float white = clamp(gores / max(fwidth(gores), 1e-6) + 0.5, 0.0, 1.0);
  white *= clamp(0.5 - cap / max(fwidth(cap), 1e-6), 0.0, 1.0);
  return mix(color, mix(color, vec3(1.0), 0.85), white);
}
`;

/** Fragment declarations shared by the lit, shadow and flat passes. */
export const impostorFragmentPars = /* glsl */ `
uniform float multisampled; // 1 where the target has several samples a pixel

varying vec3 vCorner;
flat varying vec4 vSphere;
flat varying float vPerspective;
flat varying vec4 vBodyColor;
flat varying uint vBodyShape;
flat varying uint vBodyOutline;
flat varying mat3 vBodyFrame;

vec3 impostorHit;       // view space
vec3 impostorNormal;    // view space, unit
vec3 impostorLocal;     // the hit in the body's axes, in radii
float impostorCoverage; // share of the pixel inside the outline

float coverageOf(float inside) { return clamp(inside / max(fwidth(inside), 1e-6) + 0.5, 0.0, 1.0); }

void impostorRay(out vec3 origin, out vec3 direction) {
  origin = vec3(vCorner.xy, vCorner.z + vSphere.w) * (1.0 - vPerspective);
  direction = mix(vec3(0.0, 0.0, -1.0), normalize(vCorner), vPerspective);
}
`;

/** `meetSolid()` intersects the view ray with the ball, box or solid of an outline; discards what misses it. */
export const impostorSolidPars = /* glsl */ `
uniform mat4 projectionMatrix;
vec4 impostorClip;
#ifdef CASTS_SHADOW
  const float surface = 1.0; // the far side, as three's own shadows do: a lit surface then never shades itself
#else
  const float surface = -1.0;
#endif

void meetSphere(vec3 origin, vec3 direction) {
  vec3 toRay = origin - vSphere.xyz;
  float along = dot(toRay, direction);
  vec3 nearest = toRay - along * direction; // from the centre; keeps its digits far from the eye
  float offset = length(nearest) / vSphere.w;
  impostorCoverage = coverageOf(1.0 - offset);
  float depth = vSphere.w * sqrt(max(1.0 - offset * offset, 0.0));
  impostorHit = origin + (surface * depth - along) * direction;
  impostorNormal = normalize(impostorHit - vSphere.xyz);
  impostorLocal = impostorNormal * vBodyFrame;
}

void meetBox(vec3 origin, vec3 direction) {
  vec3 start = ((origin - vSphere.xyz) * vBodyFrame) / vSphere.w;
  vec3 ray = (direction * vBodyFrame) / vSphere.w;
  vec3 inverse = 1.0 / mix(ray, vec3(1e-9), lessThan(abs(ray), vec3(1e-9)));
  vec3 enter = -start * inverse - abs(inverse);
  vec3 leave = -start * inverse + abs(inverse);
  float first = max(max(enter.x, enter.y), enter.z);
  float last = min(min(leave.x, leave.y), leave.z);
  // Clamped, since a ray along a face makes it leap far outside the outline too.
  impostorCoverage = coverageOf(clamp((last - first) / vSphere.w, -0.5, 0.5));
  float hit = surface < 0.0 ? first : last;
  impostorHit = origin + hit * direction;
  impostorLocal = start + hit * ray;
  impostorNormal = vBodyFrame * (-sign(ray) * step(enter.yzx, enter.xyz) * step(enter.zxy, enter.xyz));
  impostorNormal = normalize(impostorNormal);
}

${outlineSolid}
void meetSolid() {
  vec3 origin, direction;
  impostorRay(origin, direction);
  if (vBodyShape == ${SHAPES.box}u) meetBox(origin, direction);
  else if (vBodyOutline > 0u) meetOutline(origin, direction);
  else meetSphere(origin, direction);
  #ifdef CASTS_SHADOW
    if (impostorCoverage < 0.5) discard;
  #else
    if (impostorCoverage < mix(0.5, 0.02, multisampled)) discard;
  #endif
  impostorCoverage = mix(1.0, impostorCoverage, multisampled);
  impostorClip = projectionMatrix * vec4(impostorHit, 1.0);
  #if defined(USE_LOGARITHMIC_DEPTH_BUFFER) && !defined(DISTANCE)
    gl_FragDepth = vPerspective == 0.0
      ? 0.5 * impostorClip.z / impostorClip.w + 0.5 : log2(1.0 + impostorClip.w) * logDepthBufFC * 0.5;
  #elif defined(USE_REVERSED_DEPTH_BUFFER)
    gl_FragDepth = impostorClip.z / impostorClip.w;
  #else
    gl_FragDepth = 0.5 * impostorClip.z / impostorClip.w + 0.5;
  #endif
}
`;
