/** GLSL that finds the ends of segment `i` of the trails: `points - 1` segments a trail, the newest first. */
import { TEXTURE_WIDTH } from '@principia/render-core';
import { centrePull } from './body-pull.ts';

const pars = /* glsl */ `
precision highp sampler2DArray;
const float endReach = 0.0; // faint pieces that overlap would show as beads
uniform highp usampler2D birth;      // per slot: number of the first recording of the body now in it
uniform highp usampler2D slots;      // per trail: its slot, or its body where slots are places in a list
uniform highp usampler2D bodyColors;
uniform bool slotIsId;
uniform uint onlyColor;
uniform uint defaultColor;
uniform int points;
uniform int recordings;
uniform int newestIsCurrent;
uniform float opacity;
uniform float maxSegment; // between points farther apart than this, metres, the body was teleported
uniform float poseAlpha;

ivec2 cellAt(int i) { return ivec2(i % ${TEXTURE_WIDTH}, i / ${TEXTURE_WIDTH}); }
`;

const recorded2d = /* glsl */ `
uniform sampler2DArray trailX, trailY;
vec3 recorded(ivec2 at, int number) {
  ivec3 cell = ivec3(at, number % points);
  return vec3(texelFetch(trailX, cell, 0).r, texelFetch(trailY, cell, 0).r, 0.0);
}
`;

const recorded3d = /* glsl */ `
uniform sampler2DArray trailX, trailY, trailZ;
vec3 recorded(ivec2 at, int number) {
  ivec3 cell = ivec3(at, number % points);
  return vec3(texelFetch(trailX, cell, 0).r, texelFetch(trailY, cell, 0).r, texelFetch(trailZ, cell, 0).r);
}
`;

/** With a recording every step the body is drawn between the two newest; otherwise it has to be looked up. */
const bodyBetweenRecordings = /* glsl */ `
vec3 bodyNow(ivec2 at, int id, int born) {
  vec3 present = recorded(at, recordings - 1);
  if (recordings - 2 < born) return present;
  vec3 before = recorded(at, recordings - 2);
  return distance(before, present) > maxSegment ? present : mix(before, present, poseAlpha);
}
`;
const bodyFromColumns = /* glsl */ `
uniform vec3 centreOffset; // from the frame of the trails to that of the columns, metres
vec3 bodyNow(ivec2 at, int id, int born) { return pullCentre(cellAt(id)) + centreOffset; }
`;

const segmentEnds = /* glsl */ `
bool segmentEnds(int i, out vec3 a, out vec3 b, out vec4 colorA, out vec4 colorB) {
  int trail = i / (points - 1);
  int piece = i % (points - 1);
  int id = int(texelFetch(slots, cellAt(trail), 0).r);
  ivec2 at = cellAt(slotIsId ? id : trail);
  int born = int(texelFetch(birth, at, 0).r);
  // The body is drawn between two poses, so a recording of the present one lies ahead of it and is left out.
  int numberB = recordings - 1 - newestIsCurrent - piece;
  if (numberB < born || numberB < 0) return false;
  a = piece == 0 ? bodyNow(at, id, born) : recorded(at, numberB + 1);
  b = recorded(at, numberB);
  if (distance(a, b) > maxSegment) return false;
  uint bytes = onlyColor != 0u ? onlyColor : texelFetch(bodyColors, cellAt(id), 0).r;
  colorA = lineColor(bytes != 0u ? bytes : defaultColor);
  colorA.a *= opacity;
  colorB = colorA;
  colorA.a *= 1.0 - float(piece) / float(points - 1);
  colorB.a *= 1.0 - float(piece + 1) / float(points - 1);
  return true;
}
`;

/**
 * The `segmentEnds` of trails, see `wideLineMain`.
 *
 * @param hasCentres whether the columns are at hand, which they must be unless every pose is recorded
 */
export function trailSegments(dimensions: 2 | 3, hasCentres: boolean): string {
  const body = hasCentres ? centrePull(dimensions) + bodyFromColumns : bodyBetweenRecordings;
  return pars + (dimensions === 2 ? recorded2d : recorded3d) + body + segmentEnds;
}
