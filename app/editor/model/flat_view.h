#pragma once

#include <optional>
#include <string>

#include "core/fabric/model/fabric.h"
#include "ui/flat_menu.h"

namespace loomlight {

/// Flat cloth that is looked at in the place of the drape, by a camera of its own.
struct FlatSight {
  glm::dvec2 piece_mm{0.0};
  Camera camera;
  bool operator==(const FlatSight&) const = default;
};
/// The fabric as it is looked at: turned over, where its back is; and lying flat.
Fabric asSeen(Fabric fabric, bool back, const std::optional<FlatSight>& flat);

/// The same with what the designer asked for.
struct FlatView {
  FlatCloth cloth;
  FlatSight sight;
  bool operator==(const FlatView&) const = default;
};
/// How a cloth is looked at, beside its own drape and camera.
struct ClothView {
  bool back = false;                                ///< from behind
  std::optional<FlatView> flat;                     ///< null: as it is draped
  std::optional<StandardIlluminant> judgedUnder{};  ///< another lamp than its own; null: its own
  bool operator==(const ClothView&) const = default;
};
/// As a text for a file.
std::string flatViewToJson(const FlatView& view);
/// Throws InputError, naming `sourceName`, for anything else.
FlatView flatViewFromJson(const std::string& text, const std::string& sourceName);

}  // namespace loomlight
