/**
 * GLSL of the solids that stand for flat colliders: a polygon is a plate, as thick as it is narrow, and a capsule is a
 * capsule. Roundings of polygons widen the plate, but leave its corners sharp.
 */
import { OUTLINE_TEXELS, TEXTURE_WIDTH } from '@principia/render-core';

/** `meetOutline()`; lengths are in drawn radii, which is how far the outline reaches from the centre. */
export const outlineSolid = /* glsl */ `
uniform highp sampler2D bodyOutlines; // per outline: vertices, rounding, extent, half of the least width; x and y of each

float outlineNumber(int i) {
  i += int(vBodyOutline) * ${OUTLINE_TEXELS};
  return texelFetch(bodyOutlines, ivec2(i % ${TEXTURE_WIDTH}, i / ${TEXTURE_WIDTH}), 0).r;
}

vec2 outlineVertex(int i) { return vec2(outlineNumber(4 + 2 * i), outlineNumber(5 + 2 * i)) / outlineNumber(2); }

/** Cuts the ray where it crosses a plane that is 'away' in front of its start; rate is how fast it moves from it. */
void cutByPlane(float away, float rate, vec3 normal, inout float first, inout float last, inout vec3 facing) {
  if (abs(rate) < 1e-9) {
    if (away > 0.0) last = -1e9;
    return;
  }
  float at = -away / rate;
  if (rate > 0.0) last = min(last, at);
  else if (at > first) {
    first = at;
    facing = normal;
  }
}

void meetPlate(int count, vec3 start, vec3 ray, out float first, out float last, out vec3 facing) {
  first = -1e9;
  last = 1e9;
  facing = vec3(0.0, 0.0, 1.0);
  float rounding = outlineNumber(1) / outlineNumber(2);
  float depth = outlineNumber(3) / outlineNumber(2);
  cutByPlane(start.z - depth, ray.z, vec3(0.0, 0.0, 1.0), first, last, facing);
  cutByPlane(-start.z - depth, -ray.z, vec3(0.0, 0.0, -1.0), first, last, facing);
  vec2 corner = outlineVertex(count - 1);
  for (int i = 0; i < count; i++) {
    vec2 next = outlineVertex(i);
    vec2 normal = normalize(vec2(next.y - corner.y, corner.x - next.x));
    float away = dot(normal, start.xy - corner) - rounding;
    cutByPlane(away, dot(normal, ray.xy), vec3(normal, 0.0), first, last, facing);
    corner = next;
  }
}

/** Quadratic equations of the round side and of both ends: Quilez, iquilezles.org/articles/intersectors. */
void meetCapsule(vec3 start, vec3 ray, out float first, out float last, out vec3 facing) {
  vec3 a = vec3(outlineVertex(0), 0.0);
  vec3 along = vec3(outlineVertex(1), 0.0) - a;
  float radius = max(outlineNumber(1) / outlineNumber(2), 0.01); // a segment is a thin rod
  vec3 from = start - a;
  float length2 = dot(along, along);
  float rate = dot(along, ray);
  float offset = dot(along, from);
  float qa = length2 * dot(ray, ray) - rate * rate;
  float qb = length2 * dot(from, ray) - offset * rate;
  float qc = length2 * dot(from, from) - offset * offset - radius * radius * length2;
  float h = qb * qb - qa * qc;
  first = h > 0.0 && qa > 0.0 ? (-qb - sqrt(h)) / qa : 0.0;
  float place = offset + first * rate;
  if (!(h > 0.0 && qa > 0.0) || place < 0.0 || place > length2) {
    from = place <= 0.0 || (qa <= 0.0 && rate > 0.0) ? from : from - along;
    float b = dot(ray, from) / dot(ray, ray);
    float c = (dot(from, from) - radius * radius) / dot(ray, ray);
    h = b * b - c;
    first = -b - sqrt(max(h, 0.0));
  }
  last = h > 0.0 ? first + sqrt(h) : first - 1.0;
  vec3 hit = start + first * ray - a;
  facing = normalize(hit - along * clamp(dot(hit, along) / length2, 0.0, 1.0));
}

void meetOutline(vec3 origin, vec3 direction) {
  vec3 start = ((origin - vSphere.xyz) * vBodyFrame) / vSphere.w;
  vec3 ray = (direction * vBodyFrame) / vSphere.w;
  int count = int(outlineNumber(0));
  float first, last;
  vec3 facing;
  if (count > 2) meetPlate(count, start, ray, first, last, facing);
  else meetCapsule(start, ray, first, last, facing);
  impostorCoverage = coverageOf(clamp((last - first) / vSphere.w, -0.5, 0.5));
  float hit = surface < 0.0 ? first : last;
  impostorHit = origin + hit * direction;
  impostorLocal = start + hit * ray;
  impostorNormal = normalize(vBodyFrame * facing);
}
`;
