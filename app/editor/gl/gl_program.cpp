#include "app/editor/gl/gl_program.h"

#include <fmt/core.h>

#include <stdexcept>
#include <string>

#include "shader_text.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace {

GLuint compile(GLenum kind, std::string_view text) {
  const GLuint shader = glCreateShader(kind);
  const char* source = text.data();
  const auto length = static_cast<GLint>(text.size());
  glShaderSource(shader, 1, &source, &length);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  throw std::runtime_error(fmt::format(words::errors::shader, log));
}

}  // namespace

GLuint linkedProgram(std::string_view fragmentShader) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, kDisplayVertexShader);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentShader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glLinkProgram(program);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok) return program;
  char log[1024] = "";
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  throw std::runtime_error(fmt::format(words::errors::shader, log));
}

GLuint madeTexture(GLenum kind, GLint filter) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(kind, texture);
  glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(kind, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  return texture;
}

void uploadCube(GLuint texture, const ColourCube& cube) {
  glBindTexture(GL_TEXTURE_3D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  constexpr GLsizei n = ColourCube::kSide;
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16F, n, n, n, 0, GL_RGBA, GL_FLOAT, cube.corners().data());
}

}  // namespace loomlight
