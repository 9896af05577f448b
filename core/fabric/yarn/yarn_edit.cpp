#include "core/fabric/yarn/yarn_edit.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/fresh_name.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

void dropUnusedFibre(Fabric& fabric, int fibre) {
  for (const Yarn& yarn : fabric.yarns)
    if (yarn.fibre == fibre || yarn.blendFibre == fibre) return;
  fabric.fibres.erase(fabric.fibres.begin() + fibre);
  for (Yarn& yarn : fabric.yarns) {
    if (yarn.fibre > fibre) --yarn.fibre;
    if (yarn.blendFibre > fibre) --*yarn.blendFibre;
  }
  for (Colourway& colourway : fabric.colourways) {
    std::vector<Absorption>& absorptions = colourway.absorption_per_mm;
    if (fibre < static_cast<int>(absorptions.size())) absorptions.erase(absorptions.begin() + fibre);
  }
}

}  // namespace

std::string fibreNameFor(const Fabric& fabric, const std::string& like) {
  return freshName(like, [&](const std::string& name) {
    return std::any_of(fabric.fibres.begin(), fabric.fibres.end(),
                       [&](const Fibre& fibre) { return fibre.name == name; });
  });
}

std::string kindName(const std::string& fibreName) {
  const std::string kind = fibreName.substr(0, fibreName.find(", "));
  const size_t end = kind.find_last_not_of("0123456789");
  return end != std::string::npos && end > 0 && kind[end] == ' ' ? kind.substr(0, end) : kind;
}

int addFibre(Fabric& fabric, Fibre fibre, int like) {
  const size_t count = fabric.fibres.size();
  for (Colourway& colourway : fabric.colourways) {
    std::vector<Absorption>& dyes = colourway.absorption_per_mm;
    if (static_cast<size_t>(like) >= dyes.size()) continue;  // both keep their own colours there
    for (size_t i = dyes.size(); i < count; ++i) dyes.push_back(fabric.fibres[i].absorption_per_mm);
    dyes.push_back(Absorption(dyes[static_cast<size_t>(like)]));
  }
  fabric.fibres.push_back(std::move(fibre));
  return static_cast<int>(count);
}

bool isWoven(const Fabric& fabric, int yarn) {
  const auto has = [yarn](const std::vector<int>& order) {
    return std::find(order.begin(), order.end(), yarn) != order.end();
  };
  return has(fabric.warpSequence) || has(fabric.weftSequence);
}

Fabric withYarn(Fabric fabric, int index, Yarn yarn, Fibre fibre) {
  Yarn& own = fabric.yarns[static_cast<size_t>(index)];
  yarn.name = own.name;
  yarn.unknown = own.unknown;
  yarn.blendFibre.reset();
  yarn.blendShare.reset();
  yarn.fibre = own.fibre;
  own = std::move(yarn);
  return withFibre(std::move(fabric), index, std::move(fibre));
}

Fabric withYarnCopied(Fabric fabric, int index) {
  Yarn copy = fabric.yarns[static_cast<size_t>(index)];
  copy.name.clear();
  if (fabric.fibres.size() < kMaxKinds) {
    Fibre fibre = fabric.fibres[static_cast<size_t>(copy.fibre)];
    fibre.name = fibreNameFor(fabric, kindName(fibre.name));
    copy.fibre = addFibre(fabric, std::move(fibre), copy.fibre);
  }
  fabric.yarns.push_back(std::move(copy));
  return fabric;
}

Fabric withoutYarn(Fabric fabric, int index) {
  const Yarn gone = fabric.yarns[static_cast<size_t>(index)];
  fabric.yarns.erase(fabric.yarns.begin() + index);
  for (std::vector<int>* sequence : {&fabric.warpSequence, &fabric.weftSequence})
    for (int& yarn : *sequence)
      if (yarn > index) --yarn;
  std::optional<int>& selvedge = fabric.mill.selvedgeYarn;
  if (selvedge == index) selvedge.reset();
  if (selvedge > index) --*selvedge;
  if (fabric.wif && static_cast<size_t>(index) < fabric.wif->yarns.size()) {
    auto origin = std::make_shared<WifOrigin>(*fabric.wif);
    origin->yarns.erase(origin->yarns.begin() + index);
    fabric.wif = std::move(origin);
  }
  // The later one first, so that the other keeps its place until then.
  const int first = gone.fibre, second = gone.blendFibre.value_or(first);
  dropUnusedFibre(fabric, std::max(first, second));
  if (first != second) dropUnusedFibre(fabric, std::min(first, second));
  return fabric;
}

Fabric withFibre(Fabric fabric, int yarn, Fibre fibre) {
  const auto own = static_cast<size_t>(yarn);
  const int old = fabric.yarns[own].fibre;
  bool shared = fabric.yarns[own].blendFibre == old;
  for (size_t i = 0; i < fabric.yarns.size(); ++i)
    shared |= i != own && (fabric.yarns[i].fibre == old || fabric.yarns[i].blendFibre == old);
  if (shared && fabric.fibres.size() < kMaxKinds) {
    fabric.yarns[own].fibre = addFibre(fabric, std::move(fibre), old);
  } else {
    fabric.fibres[static_cast<size_t>(old)] = std::move(fibre);
  }
  return fabric;
}

Yarn evenlySpun(Yarn yarn) {
  yarn.evennessCv_percent = yarn.slubs_per_m = yarn.shadeVariation_percent = 0;
  return yarn;
}

Fabric evenlySpun(Fabric fabric) {
  for (Yarn& yarn : fabric.yarns) yarn = evenlySpun(std::move(yarn));
  fabric.settCv_percent = 0;
  return fabric;
}

}  // namespace loomlight
