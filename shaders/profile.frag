#version 330 core
// The whole window, drawn in sRGB, to the colours of the display: looked up in a cube as ColourCube::at() does in
// render/colour/colour_cube.cpp.
in vec2 uv;  // 0..1 from the bottom left, as both pictures are stored
out vec4 display;

uniform sampler2D window;
uniform sampler3D cube;

void main() {
  float side = float(textureSize(cube, 0).x);
  vec3 c = clamp(texture(window, uv).rgb, 0.0, 1.0);
  display = vec4(texture(cube, (sqrt(c) * (side - 1.0) + 0.5) / side).rgb, 1.0);
}
