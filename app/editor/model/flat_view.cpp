#include "app/editor/model/flat_view.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/weave/turned_over.h"
#include "ui/words/error_words.h"

namespace loomlight {
namespace {

constexpr const char *kInRepeats = "in_repeats", *kCount = "count", *kSight = "sight";

}  // namespace

Fabric asSeen(Fabric fabric, bool back, const std::optional<FlatSight>& flat) {
  if (back) fabric = turnedOver(std::move(fabric));
  if (!flat) return fabric;
  fabric.drape = {};
  fabric.drape.kind = DrapeKind::flat;
  fabric.drape.width_mm = flat->piece_mm.x;
  fabric.drape.height_mm = flat->piece_mm.y;
  fabric.camera = flat->camera;
  return fabric;
}

/// Piece and camera are those of a fabric without a weave to speak of, so that they are read and checked as any are.
std::string flatViewToJson(const FlatView& view) {
  const nlohmann::json json{{kInRepeats, view.cloth.inRepeats},
                            {kCount, view.cloth.count},
                            {kSight, nlohmann::json::parse(fabricToJson(asSeen(Fabric{}, false, view.sight)))}};
  return json.dump();
}

FlatView flatViewFromJson(const std::string& text, const std::string& sourceName) {
  const auto refused = [&] { return InputError(fmt::format(words::errors::noFlatView, sourceName, text)); };
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    FlatView view;
    json.at(kInRepeats).get_to(view.cloth.inRepeats);
    json.at(kCount).get_to(view.cloth.count);
    const Fabric lying = fabricFromJson(json.at(kSight).dump(), sourceName);
    view.sight = {{lying.drape.width_mm, lying.drape.height_mm}, lying.camera};
    if (!(view.cloth.count > 0) || !std::isfinite(view.cloth.count)) throw refused();
    return view;
  } catch (const nlohmann::json::exception&) {
    throw refused();
  }
}

}  // namespace loomlight
