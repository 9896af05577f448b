#pragma once

#include <map>
#include <memory>

#include "app/editor/display/display_driver.h"
#include "app/editor/display/texture_id.h"

namespace loomlight {

/// A driver without a graphics card: textures stay where a test can look at them. Each has a number of its own.
class MemoryDriver final : public DisplayDriver {
 public:
  std::unique_ptr<PictureTexture> makeTexture() override { return std::make_unique<Texture>(*this); }
  std::unique_ptr<ViewportPicture> makeViewport() override { return std::make_unique<Viewport>(nextId()); }

  /// What was uploaded last; null where it is the id of no texture that holds a picture.
  const Pixels8* picture(ImTextureID id) const {
    const auto found = pictures_.find(id);
    return found == pictures_.end() ? nullptr : &found->second;
  }

 private:
  class Texture final : public PictureTexture {
   public:
    explicit Texture(MemoryDriver& driver) : driver_(driver), id_(driver.nextId()) {}
    ~Texture() override { driver_.pictures_.erase(id_); }
    void upload(const Pixels8& pixels) override { driver_.pictures_[id_] = pixels; }
    ImTextureID id() const override { return driver_.picture(id_) ? id_ : ImTextureID{}; }

   private:
    MemoryDriver& driver_;
    const ImTextureID id_;
  };

  /// What light looks like is the matter of the shader, hence of tests with a window; here it is only known whether
  /// there is some.
  class Viewport final : public ViewportPicture {
   public:
    explicit Viewport(ImTextureID id) : id_(id) {}
    void uploadParts(int, int, std::span<const glm::vec4>, std::span<const Film::Hit>, const PixelRect&,
                     const PixelRect&) override {
      filled_ = true;
    }
    ImTextureID display(int, int, const Tone&, const SoftProof&, const std::optional<Outline>&) override {
      return filled_ ? id_ : ImTextureID{};
    }

   private:
    const ImTextureID id_;
    bool filled_ = false;
  };

  ImTextureID nextId() { return textureId(++made_ + 1000); }

  std::map<ImTextureID, Pixels8> pictures_;
  uint32_t made_ = 0;
};

}  // namespace loomlight
