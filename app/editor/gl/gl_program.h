#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <string_view>

#include "render/colour/colour_cube.h"

namespace loomlight {

/// A program that covers what it draws to with one triangle. Throws std::runtime_error with the driver's words.
GLuint linkedProgram(std::string_view fragmentShader);
/// Edges are repeated outside of it. Left bound.
GLuint madeTexture(GLenum kind, GLint filter);
/// Into a texture of three dimensions, as the shaders look it up.
void uploadCube(GLuint texture, const ColourCube& cube);

}  // namespace loomlight
