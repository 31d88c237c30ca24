/**
 * GLSL that fetches one body from the column textures: the `pull…` functions, given its cell, return or
 * fill in the `body…` globals below what it has, interpolated by `poseAlpha`.
 */
import { TEXTURE_WIDTH } from '@principia/render-core';

/** `log2(TEXTURE_WIDTH)`: the value of body `id` is texel (id mod 1024, id div 1024) of its column. */
const columnWidthBits = 10;

/**
 * Uniforms of the position columns of a world of 2 or 3 dimensions: present axes, then those a step ago; the other way
 * round where `PosePair` has swapped them, which turns `poseAlpha` round as well.
 */
export const centreUniforms = {
  2: ['positionX', 'positionY', 'previousX', 'previousY'],
  3: ['positionX', 'positionY', 'positionZ', 'previousX', 'previousY', 'previousZ'],
} as const;

/** Uniforms of the rotation columns: an angle now and a step ago, or a quaternion now and a step ago, or swapped. */
export const turnUniforms = {
  2: ['angleNow', 'anglePrevious'],
  3: ['turnX', 'turnY', 'turnZ', 'turnW', 'previousTurnX', 'previousTurnY', 'previousTurnZ', 'previousTurnW'],
} as const;

const shared = /* glsl */ `
uniform highp usampler2D bodyStyle; // per body: drawn radius as float bits, RGBA bytes, shape kind, outline
uniform float poseAlpha;            // 0 the previous step, 1 the present one, or the other way round

vec3 bodyCentre;  // in the frame of the object that draws the bodies, metres
vec4 bodyTurn;    // unit quaternion
float bodyRadius; // metres; zero draws nothing
vec4 bodyColor;   // linear rgb, alpha as stored
uint bodyShape;
uint bodyOutline; // zero for a ball

vec4 unpackColor(uint bytes) {
  vec4 color = vec4(uvec4(bytes, bytes >> 8, bytes >> 16, bytes >> 24) & 255u) / 255.0;
  // Bytes are sRGB as in CSS; three lights and blends in linear light.
  vec3 linear = mix(pow((color.rgb + 0.055) / 1.055, vec3(2.4)), color.rgb / 12.92, lessThanEqual(color.rgb, vec3(0.04045)));
  return vec4(linear, color.a);
}

vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void pullStyle(ivec2 at) {
  uvec4 style = texelFetch(bodyStyle, at, 0);
  bodyRadius = uintBitsToFloat(style.r);
  bodyColor = unpackColor(style.g);
  bodyShape = style.b;
  bodyOutline = style.a;
}
`;

const centre2d = /* glsl */ `
vec3 pullCentre(ivec2 at) {
  vec2 previous = vec2(cell(previousX, at), cell(previousY, at));
  return vec3(mix(previous, vec2(cell(positionX, at), cell(positionY, at)), poseAlpha), 0.0);
}
`;

const turn2d = /* glsl */ `
vec4 pullTurn(ivec2 at) {
  float previous = cell(anglePrevious, at);
  float turn = cell(angleNow, at) - previous;
  turn -= 6.283185307179586 * floor(turn / 6.283185307179586 + 0.5); // the short way round
  float halfAngle = 0.5 * (previous + poseAlpha * turn);
  return vec4(0.0, 0.0, sin(halfAngle), cos(halfAngle));
}
`;

const centre3d = /* glsl */ `
vec3 pullCentre(ivec2 at) {
  vec3 previous = vec3(cell(previousX, at), cell(previousY, at), cell(previousZ, at));
  return mix(previous, vec3(cell(positionX, at), cell(positionY, at), cell(positionZ, at)), poseAlpha);
}
`;

const turn3d = /* glsl */ `
vec4 notRotatedIfZero(vec4 q) { return dot(q, q) == 0.0 ? vec4(0.0, 0.0, 0.0, 1.0) : q; }

vec4 pullTurn(ivec2 at) {
  vec4 previous = notRotatedIfZero(
    vec4(cell(previousTurnX, at), cell(previousTurnY, at), cell(previousTurnZ, at), cell(previousTurnW, at)));
  vec4 present = notRotatedIfZero(vec4(cell(turnX, at), cell(turnY, at), cell(turnZ, at), cell(turnW, at)));
  // q and -q are one rotation; mixing them unmatched would turn the long way round through zero.
  if (dot(previous, present) < 0.0) previous = -previous;
  return normalize(mix(previous, present, poseAlpha));
}
`;

function samplers(names: readonly string[]): string {
  return names.map((name) => `uniform highp sampler2D ${name};\n`).join('');
}

/** `pullCentre(cell)`; needs a uniform `poseAlpha`. */
export function centrePull(dimensions: 2 | 3): string {
  return `${samplers(centreUniforms[dimensions])}
float cell(highp sampler2D column, ivec2 at) { return texelFetch(column, at, 0).r; }
${dimensions === 2 ? centre2d : centre3d}`;
}

/** Declarations and functions for the vertex shader of a world of `dimensions`. */
export function bodyPull(dimensions: 2 | 3): string {
  return `${shared}${centrePull(dimensions)}${samplers(turnUniforms[dimensions])}${dimensions === 2 ? turn2d : turn3d}
ivec2 cellOf(int id) { return ivec2(id & ${TEXTURE_WIDTH - 1}, id >> ${columnWidthBits}); }
`;
}
