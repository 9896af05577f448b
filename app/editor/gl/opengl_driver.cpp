#include "app/editor/gl/opengl_driver.h"

#include <cmath>
#include <limits>
#include <vector>

#include "app/editor/display/texture_id.h"
#include "app/editor/gl/gl_program.h"
#include "render/colour/icc_profile.h"
#include "shader_text.h"

namespace loomlight {
namespace {

constexpr GLint kNoCloth = -2147483647;  // as in shaders/display.frag

class OpenGlTexture final : public PictureTexture {
 public:
  explicit OpenGlTexture(uint64_t& changes) : changes_(changes) {}
  ~OpenGlTexture() override;
  OpenGlTexture(const OpenGlTexture&) = delete;
  OpenGlTexture& operator=(const OpenGlTexture&) = delete;

  void upload(const Pixels8& pixels) override;
  ImTextureID id() const override { return textureId(texture_); }

 private:
  uint64_t& changes_;  ///< the driver's
  GLuint texture_ = 0;
};

OpenGlTexture::~OpenGlTexture() {
  if (texture_) glDeleteTextures(1, &texture_);
}

void OpenGlTexture::upload(const Pixels8& pixels) {
  if (!texture_) glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, pixels.width, pixels.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               pixels.bytes.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  ++changes_;
}

/// Exposure and tone are uniforms of a shader, so that they never cost a new picture.
class OpenGlViewport final : public ViewportPicture {
 public:
  explicit OpenGlViewport(uint64_t& changes);
  ~OpenGlViewport() override;
  OpenGlViewport(const OpenGlViewport&) = delete;
  OpenGlViewport& operator=(const OpenGlViewport&) = delete;

  void uploadParts(int width, int height, std::span<const glm::vec4> rgba, std::span<const Film::Hit> hits,
                   const PixelRect& newLight, const PixelRect& newHits) override;
  ImTextureID display(int width, int height, const Tone& tone, const SoftProof& proof,
                      const std::optional<Outline>& outline) override;

 private:
  void resizeTarget(int width, int height);
  void useProof(const SoftProof& proof);

  uint64_t& changes_;  ///< the driver's
  GLuint program_ = 0, vertexArray_ = 0, picture_ = 0, crossings_ = 0, target_ = 0, prints_ = 0, framebuffer_ = 0;
  int targetWidth_ = 0, targetHeight_ = 0;
  int width_ = 0, height_ = 0;  ///< of the picture
  bool knowsCrossings_ = false;
  /// What the target shows; null where the picture is another by now.
  struct Shown {
    int width = 0, height = 0;
    Tone tone;
    SoftProof proof;
    std::optional<Outline> outline;
    friend bool operator==(const Shown&, const Shown&) = default;
  };
  std::optional<Shown> shown_;
  std::shared_ptr<const ColourCube> uploadedPrints_;
};

OpenGlViewport::OpenGlViewport(uint64_t& changes) : changes_(changes) {
  program_ = linkedProgram(kDisplayFragmentShader);
  glGenVertexArrays(1, &vertexArray_);
  picture_ = madeTexture(GL_TEXTURE_2D, GL_LINEAR);
  crossings_ = madeTexture(GL_TEXTURE_2D, GL_NEAREST);
  target_ = madeTexture(GL_TEXTURE_2D, GL_NEAREST);
  prints_ = madeTexture(GL_TEXTURE_3D, GL_LINEAR);
  glGenFramebuffers(1, &framebuffer_);
}

OpenGlViewport::~OpenGlViewport() {
  glDeleteFramebuffers(1, &framebuffer_);
  const GLuint textures[] = {picture_, crossings_, target_, prints_};
  glDeleteTextures(4, textures);
  glDeleteVertexArrays(1, &vertexArray_);
  glDeleteProgram(program_);
}

/// Into the bound texture a part of it, of rows that lie so many pixels apart.
void uploadPart(const PixelRect& part, int pixelsPerRow, GLenum format, GLenum type, const void* firstPixel) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, pixelsPerRow);
  glTexSubImage2D(GL_TEXTURE_2D, 0, part.x, part.y, part.width, part.height, format, type, firstPixel);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void OpenGlViewport::uploadParts(int width, int height, std::span<const glm::vec4> rgba,
                                 std::span<const Film::Hit> hits, const PixelRect& newLight, const PixelRect& newHits) {
  const bool known = !hits.empty();
  const auto at = [width](const PixelRect& part, int y) {
    return static_cast<size_t>(part.y + y) * static_cast<size_t>(width) + static_cast<size_t>(part.x);
  };
  glBindTexture(GL_TEXTURE_2D, picture_);
  if (width != width_ || height != height_)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  if (newLight.width > 0) uploadPart(newLight, width, GL_RGBA, GL_FLOAT, &rgba[at(newLight, 0)]);

  constexpr GLint kNone[] = {kNoCloth, kNoCloth};
  glBindTexture(GL_TEXTURE_2D, crossings_);
  if (width != width_ || height != height_ || known != knowsCrossings_)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32I, known ? width : 1, known ? height : 1, 0, GL_RG_INTEGER, GL_INT,
                 known ? nullptr : kNone);
  if (known && newHits.width > 0) {
    std::vector<GLint> crossings;
    crossings.reserve(2 * static_cast<size_t>(newHits.width) * static_cast<size_t>(newHits.height));
    for (int y = 0; y < newHits.height; ++y)
      for (const Film::Hit& hit : hits.subspan(at(newHits, y), static_cast<size_t>(newHits.width))) {
        crossings.push_back(hit.yarn < 0 ? kNoCloth : hit.end);
        crossings.push_back(hit.yarn < 0 ? kNoCloth : hit.pick);
      }
    uploadPart(newHits, newHits.width, GL_RG_INTEGER, GL_INT, crossings.data());
  }
  width_ = width;
  height_ = height;
  knowsCrossings_ = known;
  shown_.reset();
}

void OpenGlViewport::resizeTarget(int width, int height) {
  if (width == targetWidth_ && height == targetHeight_) return;
  glBindTexture(GL_TEXTURE_2D, target_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_, 0);
  targetWidth_ = width;
  targetHeight_ = height;
}

/// With the program in use.
void OpenGlViewport::useProof(const SoftProof& proof) {
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_3D, prints_);
  if (proof.prints && proof.prints != uploadedPrints_) {
    uploadCube(prints_, *proof.prints);
    uploadedPrints_ = proof.prints;
  }
  glUniform1i(at("prints"), 2);
  glUniform1i(at("proofs"), proof.prints != nullptr);
  glUniform1f(at("outOfGamut"), proof.warnsOfGamut ? kOutOfGamut_deltaE : std::numeric_limits<float>::max());
  glUniform1i(at("marksBeyondSrgb"), proof.warnsOfGamut && !proof.prints);
  glUniform1f(at("beyondSrgb"), kBeyondSrgb);
  glUniform3f(at("gamutWarning"), kGamutWarning.r, kGamutWarning.g, kGamutWarning.b);
}

ImTextureID OpenGlViewport::display(int width, int height, const Tone& tone, const SoftProof& proof,
                                    const std::optional<Outline>& outline) {
  if (width_ == 0 || width <= 0 || height <= 0) return {};
  const ImTextureID target = textureId(target_);
  const Shown wanted{width, height, tone, proof, outline};
  if (shown_ == wanted) return target;  // most frames change something else
  shown_ = wanted;
  ++changes_;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  resizeTarget(width, height);
  glViewport(0, 0, width, height);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(program_);
  glBindVertexArray(vertexArray_);
  useProof(proof);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, crossings_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_);
  auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniform1i(at("picture"), 0);
  glUniform1i(at("crossings"), 1);
  glUniform1f(at("exposure"), std::exp2(tone.exposure_stops));
  glUniform1i(at("filmic"), tone.filmic);
  glUniform3f(at("background"), tone.background.x, tone.background.y, tone.background.z);
  glUniform4i(at("lit"), 0, 0, 0, 0);
  if (outline) {
    glUniform4i(at("lit"), outline->crossing.end, outline->crossing.pick, outline->ends, outline->picks);
    glUniform3f(at("accent"), outline->colour.r, outline->colour.g, outline->colour.b);
  }
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return target;
}

}  // namespace

std::unique_ptr<PictureTexture> OpenGlDriver::makeTexture() {
  return std::make_unique<OpenGlTexture>(changes_);
}

std::unique_ptr<ViewportPicture> OpenGlDriver::makeViewport() {
  return std::make_unique<OpenGlViewport>(changes_);
}

}  // namespace loomlight
