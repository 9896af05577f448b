#version 330 core
// One triangle that covers the viewport; no vertex buffer.
out vec2 uv;  // 0..1 from the top left of the picture

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  uv = 0.5 * (corner + 1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
