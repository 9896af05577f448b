#include "app/editor/services/yarn_colour_service.h"

#include <algorithm>
#include <utility>

#include "core/fabric/model/changes.h"
#include "core/fabric/model/colourways.h"
#include "core/fabric/yarn/yarn_reflectance.h"
#include "render/light/lighting.h"

// How it works. Light is traced through the cloth once for each construction; how much the fibres absorb, and under
// which lamp they are seen, is arithmetic on those paths. So the paths are kept by what they depend on, those of the
// last few constructions: a dye, a lamp, a step of undo is answered in a moment. While a new construction is traced
// through, every yarn keeps the colour that it had.

namespace loomlight {
namespace {

/// Whether the paths of one fabric's yarns are those of the other's. Yarns that no end or pick uses are traced through
/// too.
bool yarnsTracedAlike(const Fabric& a, const Fabric& b) {
  if (a.yarns.size() != b.yarns.size() || !tracedAlike(a, b)) return false;
  for (int i = 0; i < static_cast<int>(a.yarns.size()); ++i)
    if (!sameShape(a, i, b, i)) return false;
  return true;
}

/// Whether two yarns differ in nothing but what they are called.
bool areAlike(const Fabric& a, size_t i, const Fabric& b, size_t j) {
  const auto unnamed = [](Yarn yarn) {
    yarn.name.clear();
    yarn.fibre = 0;
    yarn.blendFibre = yarn.blendFibre ? std::optional(1) : std::nullopt;
    return yarn;
  };
  const auto sameFibre = [&](int x, int y) {
    Fibre one = a.fibres[static_cast<size_t>(x)];
    one.name = b.fibres[static_cast<size_t>(y)].name;
    return one == b.fibres[static_cast<size_t>(y)];
  };
  const Yarn &x = a.yarns[i], &y = b.yarns[j];
  return unnamed(x) == unnamed(y) && sameFibre(x.fibre, y.fibre) &&
         (!x.blendFibre || sameFibre(*x.blendFibre, *y.blendFibre));
}

}  // namespace

YarnColourService::YarnColourService(std::function<void()> wake)
    : worker_(
          std::move(wake), [this](const Request& fabric, auto& job) { return find(fabric, job); },
          // Of a cloth that cannot be made no more is known than before.
          [this](const Request&, const std::string&) { return worker_.newest().value_or(nullptr); }) {}

/// Makes paths for the fabric where there are none, which may be replaced under way by one that the same paths serve.
/// Null when stopped.
const std::vector<PathLengthTally>* YarnColourService::pathsFor(Request& fabric, Finding::Job& job) {
  constexpr size_t kMostKept = 8;
  const auto found = std::find_if(traced_.begin(), traced_.end(),
                                  [&](const Traced& traced) { return yarnsTracedAlike(*traced.fabric, *fabric); });
  if (found != traced_.end()) {
    std::rotate(traced_.begin(), found, std::next(found));
    return &traced_.front().paths;
  }
  const Request first = fabric;
  Task task;
  task.stop = job.stop();
  task.threads = 1;
  task.progress = [&](double) {
    auto newer = job.takeNewer();
    if (!newer) return;
    if (yarnsTracedAlike(**newer, *first))
      fabric = std::move(*newer);
    else
      job.giveWayTo(std::move(*newer));
  };
  auto paths = tracePathsToYarns(*first, kChipPaths, task, &scene_);
  if (!paths) return nullptr;
  traced_.push_front({first, std::move(*paths)});
  if (traced_.size() > kMostKept) traced_.pop_back();
  return &traced_.front().paths;
}

std::optional<YarnColourService::Answer> YarnColourService::find(Request fabric, Finding::Job& job) {
  const std::vector<PathLengthTally>* const paths = pathsFor(fabric, job);
  if (!paths) return std::nullopt;
  auto known = std::make_shared<Known>();
  known->fabric = fabric;
  known->now = reachedColours(*paths, colouringOf(*fabric));
  known->named = coloursForNames(*paths, known->now);
  for (const Colourway& colourway : fabric->colourways)
    known->colourways.push_back(reachedColours(*paths, colouringOf(inColourway(*fabric, colourway))));
  // Names are of daylight; what is shown is as warm or cold as the light is.
  const Rgb tint = Lighting::tint(fabric->light);
  for (Rgb& colour : known->now) colour *= tint;
  for (std::vector<Rgb>& colours : known->colourways)
    for (Rgb& colour : colours) colour *= tint;
  return known;
}

void YarnColourService::follow(const std::shared_ptr<const Fabric>& fabric) {
  if (std::exchange(asked_, fabric) != fabric) worker_.ask(fabric);
}

YarnColourService::Answer YarnColourService::known() const {
  const auto newest = worker_.newest();
  return newest ? *newest : nullptr;
}

bool YarnColourService::knows(const Fabric& fabric) const {
  const Answer answer = known();
  return answer && answer->fabric.get() == &fabric;
}

std::vector<Rgb> YarnColourService::shown(const Fabric& fabric, std::vector<Rgb> Known::* which) const {
  const Answer answer = known();
  if (!answer) return yarnReflectances(fabric);
  const std::vector<Rgb>& theirs = (*answer).*which;
  if (answer->fabric.get() == &fabric) return theirs;
  std::vector<Rgb> colours;
  const Fabric& before = *answer->fabric;
  for (size_t i = 0; i < fabric.yarns.size(); ++i) {
    const bool wasThere = i < before.yarns.size();
    size_t like = wasThere && areAlike(before, i, fabric, i) ? i : 0;
    while (like < before.yarns.size() && !areAlike(before, like, fabric, i)) ++like;
    if (like < before.yarns.size())
      colours.push_back(theirs[like]);
    else
      colours.push_back(wasThere ? theirs[i] : yarnReflectance(fabric, fabric.yarns[i]));
  }
  return colours;
}

std::vector<Rgb> YarnColourService::ofColourway(const Fabric& fabric, size_t colourway) const {
  const Answer answer = known();
  if (answer && answer->fabric->yarns.size() == fabric.yarns.size() && colourway < answer->colourways.size())
    return answer->colourways[colourway];
  return yarnReflectances(inColourway(fabric, fabric.colourways[colourway]));
}

}  // namespace loomlight
