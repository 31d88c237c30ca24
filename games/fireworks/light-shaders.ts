/**
 * Light that fades, spreads and is mirrored: fragment shaders for both renderers. `vPlace` runs from (0, 0) to (1, 1)
 * over the target from the lower left; `UP` converts it to texture coordinates, as pixi stores textures upside down.
 */

/** Exponential decay of the previous frame, as on a retina. */
export const FADE = /* glsl */ `
uniform sampler2D uLast;
uniform float uFade;
uniform float uThreshold;
void main() {
  // Without the subtraction, targets of 8 bits would keep a dark residue.
  paint(vec4(max(texture(uLast, vPlace).rgb * uFade - uThreshold, 0.0), 1.0));
}`;

/** A Gaussian blur along one direction, nine samples. */
export const BLUR = /* glsl */ `
uniform sampler2D uLight;
uniform vec2 uStride;
void main() {
  vec3 sum = texture(uLight, vPlace).rgb * 0.1964825501511404;
  sum += (texture(uLight, vPlace + 1.411764705882353 * uStride).rgb
    + texture(uLight, vPlace - 1.411764705882353 * uStride).rgb) * 0.2969069646728344;
  sum += (texture(uLight, vPlace + 3.294117647058824 * uStride).rgb
    + texture(uLight, vPlace - 3.294117647058824 * uStride).rgb) * 0.09447039785044732;
  sum += (texture(uLight, vPlace + 5.176470588235294 * uStride).rgb
    + texture(uLight, vPlace - 5.176470588235294 * uStride).rgb) * 0.010381362401148057;
  paint(vec4(sum, 1.0));
}`;

/**
 * Tone-maps the light for the display, to be added to the background. \`uHorizon\` is the height of the waterline from
 * the bottom, 0 to 1; below it lies the rippled mirror image.
 */
export const SHOW = /* glsl */ `
uniform sampler2D uLight;
uniform sampler2D uNear;
uniform sampler2D uFar;
uniform float uHorizon;
uniform float uTime;

/** Overexposed light keeps its hue at first and turns white only when much brighter, as on film. */
vec3 exposed(vec3 light) {
  float brightest = max(max(light.r, light.g), max(light.b, 1e-5));
  vec3 hue = light / brightest;
  return mix(hue, vec3(1.0), 0.85 * smoothstep(1.2, 9.0, brightest)) * (1.0 - exp(-1.5 * brightest));
}

void main() {
  vec3 light;
  if (vPlace.y >= uHorizon) {
    light = texture(uLight, UP(vPlace)).rgb + 0.5 * texture(uNear, UP(vPlace)).rgb + 0.7 * texture(uFar, UP(vPlace)).rgb;
  } else {
    float depth = (uHorizon - vPlace.y) / max(uHorizon, 1e-4);
    float wave = sin(depth * 46.0 / (0.25 + depth) + 1.7 * uTime + 5.0 * sin(7.0 * vPlace.x));
    vec2 place = vec2(vPlace.x + 0.004 * wave * (0.3 + depth), uHorizon + (uHorizon - vPlace.y) * 2.8);
    light = 0.3 * texture(uLight, UP(place)).rgb + 0.75 * texture(uNear, UP(place)).rgb + 1.1 * texture(uFar, UP(place)).rgb;
    light *= vec3(0.5, 0.55, 0.66) * (0.75 + 0.25 * wave) * (1.0 - 0.45 * depth);
  }
  paint(vec4(exposed(light), 0.0));
}`;
