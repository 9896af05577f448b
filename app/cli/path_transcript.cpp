#include "app/cli/path_transcript.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

namespace loomlight {
namespace {

std::string vectorText(glm::vec3 v) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", v.x, v.y, v.z);
}

/// The mode by its usual name (Marschner et al. 2003).
std::string modeText(int order) {
  constexpr std::array kNames{"R", "TT", "TRT"};
  return static_cast<size_t>(order) < kNames.size() ? kNames[static_cast<size_t>(order)]
                                                    : fmt::format("residual, {} traverses", order);
}

}  // namespace

/// Voxels are the volume's affair; explicit fibres have numbers.
std::string PathTranscript::placeText(const Collision& at) const {
  if (at.fibre != 0) return fmt::format("fibre {}", at.fibre);
  const VoxelGrid& grid = scene_.cloth->volume->grid();
  const glm::vec3 place = scene_.cloth->shell->toCloth(at.place.tet, at.place.world);
  const glm::ivec3 voxel(glm::floor((place - grid.lower_mm({0, 0, 0})) / grid.size_mm));
  return fmt::format("voxel {} {} {}", voxel.x, voxel.y, voxel.z);
}

bool PathTranscript::meets(const Collision& at, uint32_t event) {
  const Fabric& fabric = *scene_.fabric;
  const auto out = std::back_inserter(text_);
  fmt::format_to(out, "event {}: {} {} at crossing {},{}, yarn {} '{}' of '{}', {}\n", event,
                 at.yarnId.system == System::warp ? "end" : "pick", at.yarnId.index, at.end, at.pick, at.yarn,
                 names_[static_cast<size_t>(at.yarn)], fabric.fibres[static_cast<size_t>(at.material)].name,
                 placeText(at));
  fmt::format_to(out, "  flight    {:.9g} mm, to {} mm\n", at.distance_mm, vectorText(at.place.world));
  fmt::format_to(out, "  fibre     tangent {}, radius {:.9g} mm, h {:.9g}\n", vectorText(at.tangent),
                 at.optics.fibreRadius_mm, at.offset);
  last_ = at;
  return true;
}

void PathTranscript::gathers(const PathLight& light, std::span<const float> lengths_mm, uint32_t events) {
  const Rgb colour = colourOf(light, lengths_mm, scene_.colouring);
  (events == 1 ? direct_ : indirect_) += colour;
  const auto out = std::back_inserter(text_);
  fmt::format_to(out, "  {}     {}\n", light.traverse_mm > 0 ? "lamp " : "found", vectorText(colour));
  for (size_t k = 0; k < lengths_mm.size(); ++k)
    if (lengths_mm[k] > 0)
      fmt::format_to(out, "    after   {:.9g} mm inside '{}'\n", lengths_mm[k], scene_.fabric->fibres[k].name);
}

void PathTranscript::scatters(const FibreBcsdf::Sample& by, glm::vec3 direction, float weight) {
  fmt::format_to(std::back_inserter(text_), "  on by     {}, {:.9g} mm inside, towards {}, weight {:.9g}\n",
                 modeText(by.order), by.length_radii * last_.optics.fibreRadius_mm, vectorText(direction), weight);
}

void PathTranscript::ends(PathEnd why) {
  constexpr std::array kWhy{"it met nothing more", "it has as many events as it may", "roulette", "it was stopped"};
  fmt::format_to(std::back_inserter(text_), "end: {}\ndirect      {}\nindirect    {}\nsum         {}\n",
                 kWhy[static_cast<size_t>(why)], vectorText(direct_), vectorText(indirect_),
                 vectorText(direct_ + indirect_));
}

}  // namespace loomlight
