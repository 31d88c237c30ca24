/**
 * Light that lingers, spreads and is mirrored: fragment code for both renderers. `vPlace` runs from (0, 0) to (1, 1) over
 * the target, from the lower left; `UP` is where a target keeps what is seen there, as pixi keeps pictures upside down.
 */

/** The picture before, fading: light is lost in the same share every second, as in an eye's retina. */
export const FADE = /* glsl */ `
uniform sampler2D uLast;
uniform float uFade;
uniform float uLeast;
void main() {
  // Targets of 8 bits would keep a dark rest for ever.
  paint(vec4(max(texture(uLast, vPlace).rgb * uFade - uLeast, 0.0), 1.0));
}`;

/** Gauss's bell along one direction, nine samples. */
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
 * All light as a display can show it, to be added to what is behind. \`uHorizon\` is the height of the water's far edge
 * from the bottom, 0 to 1; below it lies the mirror image, which ripples break up.
 */
export const SHOW = /* glsl */ `
uniform sampler2D uLight;
uniform sampler2D uNear;
uniform sampler2D uFar;
uniform float uHorizon;
uniform float uTime;

/** What is too bright for the display keeps its hue, and only then turns white, as on film. */
vec3 exposed(vec3 light) {
  float most = max(max(light.r, light.g), max(light.b, 1e-5));
  vec3 hue = light / most;
  return mix(hue, vec3(1.0), 0.85 * smoothstep(1.2, 9.0, most)) * (1.0 - exp(-1.5 * most));
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
