#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/scene/scene.h"
#include "render/transport/path_sink.h"

namespace loomlight {

/// A path in words, event by event: which fibre of which yarn was met where, the light that came onto the path there,
/// as much of it as reaches the eye, and by which mode the path went on; last why it ended, and the sums. Numbers have
/// as many digits as they need to be read back as they are. Yarns, ends, picks and voxels are counted from 0, as in
/// pictures.
class PathTranscript final : public PathSink {
 public:
  /// The scene must outlive it. `names`: of its yarns.
  PathTranscript(const Scene& scene, std::vector<std::string> names) : scene_(scene), names_(std::move(names)) {}

  bool meets(const Collision& at, uint32_t event) override;
  void gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) override;
  void scatters(const FibreBcsdf::Sample& by, glm::vec3 direction, float weight) override;
  void ends(PathEnd why) override;

  const std::string& text() const { return text_; }

 private:
  std::string placeText(const Collision& at) const;

  const Scene& scene_;
  std::vector<std::string> names_;
  std::string text_;
  Collision last_;
  Rgb direct_{0}, indirect_{0};
};

}  // namespace loomlight
