#include "render/transport/light_batches.h"

#include <algorithm>
#include <cassert>

namespace loomlight {

LightBatches::LightBatches(const Colouring& colouring, size_t materials, size_t most)
    : colouring_(colouring), batches_(2 * (materials + 1)) {
  assert(colouring.isSpectral());
  colours_.reserve(most);
}

void LightBatches::add(const PathLight& light, std::span<const float> lengths_mm) {
  const bool isWithin = std::any_of(lengths_mm.begin(), lengths_mm.end(), [](float length) { return length > 0; });
  const int material = light.traverse_mm > 0 ? light.material : LightLanes::kNoFibre;
  std::unique_ptr<Batch>& kind = batches_[2 * static_cast<size_t>(material + 1) + (isWithin ? 1 : 0)];
  if (!kind) {
    kind = std::make_unique<Batch>();
    kind->lights.material = material;
    kind->lights.isWithin = isWithin;
    kind->lights.lengths_mm.resize(lengths_mm.size());
  }
  Batch& batch = *kind;
  LightLanes& lights = batch.lights;
  const size_t lane = batch.count++;
  for (int c = 0; c < 3; ++c) lights.radiance[c][lane] = light.radiance[c];
  for (size_t mode = 0; mode < light.modes.size(); ++mode) lights.modes[mode][lane] = light.modes[mode];
  lights.traverse_mm[lane] = light.traverse_mm;
  lights.inside[lane] = light.inside;
  for (size_t k = 0; k < lengths_mm.size(); ++k) lights.lengths_mm[k].lanes[lane] = lengths_mm[k];
  batch.places[lane] = colours_.size();
  colours_.emplace_back();
  if (batch.count == kWalkLanes) finish(batch);
}

std::span<const Rgb> LightBatches::colours() {
  for (const auto& batch : batches_)
    if (batch && batch->count > 0) finish(*batch);
  return colours_;
}

void LightBatches::finish(Batch& batch) {
  colourLights(batch.lights, colouring_);
  const LaneFloats(&colour)[3] = batch.lights.colour;
  for (size_t lane = 0; lane < batch.count; ++lane)
    colours_[batch.places[lane]] = Rgb(colour[0][lane], colour[1][lane], colour[2][lane]);
  batch.count = 0;
}

}  // namespace loomlight
