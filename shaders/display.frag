#version 330 core
// Linear, premultiplied light to the display: exposure, shoulder, sRGB. The same as toDisplay() in render/colour/tone.cpp,
// so that a PNG looks like the viewport. Exposure never costs a new picture.
in vec2 uv;
out vec4 display;

uniform sampler2D picture;
uniform isampler2D crossings;  // end and pick of every pixel; kNoCloth where there is none
uniform float exposure;        // factor
uniform bool filmic;
uniform vec3 background;       // linear
uniform ivec4 lit;             // end and pick of the repeat to outline, ends and picks of the repeat; w = 0: none
uniform vec3 accent;           // sRGB
uniform sampler3D prints;      // sRGB colours as a printer prints them, and the difference; see render/colour/soft_proof.h
uniform bool proofs;           // the print is shown
uniform float outOfGamut;      // the difference beyond which a colour is marked
uniform bool marksBeyondSrgb;  // what sRGB has not is marked
uniform float beyondSrgb;      // part of the largest channel that another must be below 0
uniform vec3 gamutWarning;     // sRGB

const float kKnee = 0.7;
const int kNoCloth = -2147483647;

vec3 shoulder(vec3 c) {
  float m = max(c.r, max(c.g, c.b));
  if (!(m > kKnee)) return c;
  float bent = 1.0 - (1.0 - kKnee) * (1.0 - kKnee) / (m + 1.0 - 2.0 * kKnee);
  return c / m * bent;
}

vec3 encode(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 proofed(vec3 c) {
  float side = float(textureSize(prints, 0).x);
  vec4 print = texture(prints, (sqrt(c) * (side - 1.0) + 0.5) / side);
  return print.a > outOfGamut ? gamutWarning : print.rgb;
}

bool isBeyondSrgb(vec3 light) {
  float most = max(light.r, max(light.g, light.b)), least = min(light.r, min(light.g, light.b));
  return most > 0.0 && least < -beyondSrgb * most;
}

ivec2 crossingAt(ivec2 pixel) {
  return texelFetch(crossings, clamp(pixel, ivec2(0), textureSize(crossings, 0) - 1), 0).rg;
}

bool isLit(ivec2 pixel) {
  ivec2 c = crossingAt(pixel);
  if (c.r == kNoCloth) return false;
  ivec2 repeat = lit.zw;
  ivec2 within = c - repeat * ivec2(floor((vec2(c) + 0.5) / vec2(repeat)));  // a quotient may be a little less
  return within == lit.xy;
}

// Whether the crossing around this pixel of its is so wide that an outline leaves most of it to be seen. Outlines of
// narrow ones would lie over the cloth as specks.
bool isWide(ivec2 pixel) {
  const ivec2 across = ivec2(6, 0), down = ivec2(0, 6);
  ivec2 own = crossingAt(pixel), last = textureSize(crossings, 0) - 1;
  bool left = pixel.x >= across.x && crossingAt(pixel - across) == own;
  bool right = pixel.x + across.x <= last.x && crossingAt(pixel + across) == own;
  bool above = pixel.y >= down.y && crossingAt(pixel - down) == own;
  bool below = pixel.y + down.y <= last.y && crossingAt(pixel + down) == own;
  return (left || right) && (above || below);
}

void main() {
  vec4 light = texture(picture, uv);
  // max() would keep a NaN; the comparison turns it black.
  vec3 c = light.rgb * exposure + (1.0 - light.a) * background;
  bool marked = marksBeyondSrgb && isBeyondSrgb(c);
  c = mix(vec3(0.0), min(c, vec3(1e30)), greaterThan(c, vec3(0.0)));
  if (filmic) c = shoulder(c);
  c = encode(min(c, vec3(1.0)));
  if (proofs) c = proofed(clamp(c, 0.0, 1.0));
  if (marked) c = gamutWarning;
  if (lit.w > 0) {
    ivec2 pixel = ivec2(uv * vec2(textureSize(crossings, 0)));
    if (isLit(pixel)) {
      bool edge = !(isLit(pixel + ivec2(1, 0)) && isLit(pixel - ivec2(1, 0)) && isLit(pixel + ivec2(0, 1)) &&
                    isLit(pixel - ivec2(0, 1)));
      c = mix(c, accent, edge && isWide(pixel) ? 0.9 : 0.18);
    }
  }
  display = vec4(c, 1.0);
}
