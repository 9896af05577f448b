#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/model/flat_view.h"
#include "core/fabric/model/fabric.h"
#include "render/film/image.h"

namespace loomlight {

/// A view of a cloth that was kept: what it looked like, and the fabric with the camera that it shows.
struct KeptView {
  std::string id;  ///< names its file; later ones sort behind
  std::shared_ptr<const Fabric> fabric;
  ClothView lookedAt;
  Pixels8 picture;
};

/// Kept views on disk, from one session to the next: a PNG each, with the fabric and how it was looked at in it as
/// texts.
class ViewFolder {
 public:
  /// At most so many, and so many bytes of them; then the oldest go.
  struct Budget {
    size_t views = 32;
    uintmax_t bytes = 256'000'000;
  };
  explicit ViewFolder(std::filesystem::path folder, Budget budget);

  static std::string newId();
  /// Oldest first. A folder that is not there has none.
  std::vector<std::string> ids() const;
  /// Throws InputError.
  KeptView read(const std::string& id) const;
  /// Returns those that went for it.
  std::vector<std::string> keep(const KeptView& view) const;
  void remove(const std::string& id) const;

 private:
  std::filesystem::path fileOf(const std::string& id) const;

  std::filesystem::path folder_;
  Budget budget_;
};

}  // namespace loomlight
