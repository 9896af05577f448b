#include "app/editor/gl/display_pass.h"

#include <utility>

#include "shader_text.h"

namespace loomlight {

DisplayPass::~DisplayPass() {
  if (!program_) return;
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &window_);
  glDeleteTextures(1, &cubeTexture_);
  glDeleteVertexArrays(1, &vertexArray_);
  glDeleteProgram(program_);
}

void DisplayPass::makeOnce() {
  if (program_) return;
  program_ = linkedProgram(kProfileFragmentShader);
  glGenVertexArrays(1, &vertexArray_);
  window_ = madeTexture(GL_TEXTURE_2D, GL_NEAREST);
  cubeTexture_ = madeTexture(GL_TEXTURE_3D, GL_LINEAR);
  glGenFramebuffers(1, &framebuffer_);
}

bool DisplayPass::use(std::shared_ptr<const ColourCube> cube) {
  if (cube == cube_) return false;
  cube_ = std::move(cube);
  if (cube_) {
    makeOnce();
    uploadCube(cubeTexture_, *cube_);
  }
  return true;
}

void DisplayPass::begin(int width, int height) {
  if (!cube_) return;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (width == width_ && height == height_) return;
  glBindTexture(GL_TEXTURE_2D, window_);
  // Ten bits: rounding twice to eight would make steps in dark gradients.
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB10_A2, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, window_, 0);
  width_ = width;
  height_ = height;
}

void DisplayPass::end() {
  if (!cube_) return;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_3D, cubeTexture_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, window_);
  glUniform1i(glGetUniformLocation(program_, "window"), 0);
  glUniform1i(glGetUniformLocation(program_, "cube"), 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
}

}  // namespace loomlight
