/**
 * The shader of gravitational lensing. A point mass moves the image of a star from β to θ, where
 *
 *   β = θ - θ_E² θ / |θ|²        θ_E  Einstein radius, here slightly more than twice the horizon radius
 *
 * so a pixel at θ shows the sky at β; the deflections of several holes add. Pixels within a horizon are black.
 */
import { GlProgram } from 'pixi.js';

/** Size of the uniform array of holes; the rules never create more. */
export const MAX_LENSES = 40;

const vertex = `#version 300 es
in vec2 aPosition;
out vec2 vPlace;
void main() {
  vPlace = vec2(aPosition.x, 1.0 - aPosition.y);
  gl_Position = vec4(2.0 * aPosition - 1.0, 0.0, 1.0);
}`;

const fragment = `#version 300 es
precision highp float;
in vec2 vPlace;
out vec4 finalColor;
uniform sampler2D uSky;
uniform vec4 uHoles[${MAX_LENSES}];
uniform int uCount;
uniform vec3 uCamera;
uniform vec2 uSize;
uniform float uTime;
uniform float uSkyMetres;

void main() {
  vec2 p = uCamera.xy + (vPlace - 0.5) * uSize * vec2(1.0, -1.0) / uCamera.z;
  vec2 beta = p;
  float shade = 1.0;
  vec3 glow = vec3(0.0);
  float pixel = 1.0 / uCamera.z;
  for (int i = 0; i < ${MAX_LENSES}; i++) {
    if (i >= uCount) break;
    float r = uHoles[i].z;
    vec2 away = p - uHoles[i].xy;
    float square = max(dot(away, away), 1e-3);
    float d = sqrt(square);
    beta -= 4.8 * r * r * away / square;
    if (d > 7.0 * r) continue;
    shade *= smoothstep(r - pixel, r + pixel, d);
    float turn = atan(away.y, away.x) - 1.4 * uTime * 30.0 / (r + 12.0);
    float swirl = 0.78 + 0.22 * sin(turn + 0.35 * d / r * 6.0) * sin(2.0 * turn + uTime);
    float ring = (d - 1.16 * r) / (0.09 * r + pixel);
    float halo = max(0.0, d / r - 1.0);
    glow += vec3(1.0, 0.76, 0.44) * exp(-ring * ring) * swirl * 1.15;
    glow += vec3(1.0, 0.42, 0.14) * exp(-2.6 * halo) * swirl * 0.62;
    glow += vec3(0.28, 0.30, 0.85) * (exp(-0.7 * halo) - exp(-4.2)) * 0.20;
  }
  vec3 sky = texture(uSky, (beta + vec2(200.0, 350.0)) / uSkyMetres).rgb;
  finalColor = vec4((sky + glow) * shade, 1.0);
}`;

export function lensProgram(): GlProgram {
  return GlProgram.from({ name: 'bent-light', vertex, fragment, preferredFragmentPrecision: 'highp' });
}
