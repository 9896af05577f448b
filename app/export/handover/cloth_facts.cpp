#include "app/export/handover/cloth_facts.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "core/base/text.h"
#include "core/fabric/weave/weave_code.h"
#include "core/fabric/yarn/yarn_need.h"

namespace loomlight {
namespace {

/// A word in a fibre's name, and the fibre's name in U3M; the first that is found counts.
constexpr std::pair<std::string_view, std::string_view> kFibres[] = {
    {"organic cotton", "Organic cotton"},
    {"recycled cotton", "Recycled Cotton"},
    {"cotton", "Cotton"},
    {"linen", "Linen"},
    {"flax", "Linen"},
    {"cashmere", "Cashmere"},
    {"mohair", "Mohair"},
    {"alpaca", "Alpaca"},
    {"angora", "Angora"},
    {"camel hair", "Camelhair"},
    {"camelhair", "Camelhair"},
    {"camel", "Camelhair"},
    {"llama", "Llama"},
    {"guanaco", "Guanaco"},
    {"vicuna", "Vicugna"},
    {"vicugna", "Vicugna"},
    {"yak", "Yack"},
    {"virgin wool", "Virgin Wool"},
    {"wool", "Wool"},
    {"lambswool", "Wool"},
    {"merino", "Wool"},
    {"cheviot", "Wool"},
    {"wild silk", "Wild Silk"},
    {"tussah", "Wild Silk"},
    {"silk", "Silk"},
    {"recycled polyester", "Recycled Polyester"},
    {"polyester", "Polyester"},
    {"pet", "Polyester"},
    {"recycled nylon", "Recycled Polyamide"},
    {"recycled polyamide", "Recycled Polyamide"},
    {"nylon", "Nylon"},
    {"polyamide", "Polyamid"},
    {"viscose", "Rayon"},
    {"rayon", "Rayon"},
    {"lyocell", "Lyocell"},
    {"modal", "Modal"},
    {"cupro", "Cupro"},
    {"triacetate", "Triacetate"},
    {"acetate", "Acetate"},
    {"modacrylic", "Modacrylic"},
    {"acrylic", "Acrylic"},
    {"polypropylene", "Polypropylen"},
    {"polyethylene", "Polyethylene"},
    {"aramid", "Aramid"},
    {"hemp", "Hemp"},
    {"jute", "Jute"},
    {"ramie", "Ramie"},
    {"elastane", "Elastane"},
    {"spandex", "Spandex"},
    {"lycra", "Lycra"},
    {"lurex", "Metallised Polyester"},
    {"abaca", "Abaca"},
};

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Whether a text has a word, and not just its letters within another one.
bool hasWord(const std::string& text, std::string_view word) {
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
  }
  return false;
}

ListedName fibreName(const std::string& name) {
  const std::string lower = lowerCase(name);
  for (const auto& [word, type] : kFibres)
    if (hasWord(lower, word)) return {std::string(type), ""};
  return {"other", name.empty() ? "unnamed" : name};
}

/// Whether each end does what the one before it did, `picks` later.
bool stepsBy(const Weave& weave, int picks) {
  for (int pick = 0; pick < weave.picks(); ++pick)
    for (int end = 0; end < weave.ends(); ++end)
      if (weave.warpOver(pick, end) != weave.warpOver(pick + picks, end + 1)) return false;
  return true;
}

/// How many ends weave differently, counted no further than `enough`.
size_t differentEnds(const Weave& weave, size_t enough) {
  std::set<std::vector<bool>> columns;
  for (int end = 0; end < weave.ends() && columns.size() < enough; ++end) {
    std::vector<bool> column;
    for (int pick = 0; pick < weave.picks(); ++pick) column.push_back(weave.warpOver(pick, end));
    columns.insert(std::move(column));
  }
  return columns.size();
}

}  // namespace

std::vector<CompositionPart> compositionOf(const Fabric& fabric, const ClothMeasures& measures) {
  const std::vector<YarnNeed> needs = yarnNeed(fabric, {}, measures.crimpWarp, measures.crimpWeft);
  std::vector<CompositionPart> parts;
  double whole_kg = 0;
  const auto add = [&](int fibre, double mass_kg) {
    if (mass_kg <= 0) return;
    const ListedName name = fibreName(fabric.fibres[static_cast<size_t>(fibre)].name);
    auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& one) { return one.fibre == name; });
    if (part == parts.end()) part = parts.insert(part, {0, name});
    part->ratio += mass_kg;
    whole_kg += mass_kg;
  };
  for (size_t i = 0; i < needs.size(); ++i) {
    const Yarn& yarn = fabric.yarns[i];
    const double blend = yarn.blendFibre ? yarn.blendShare.value_or(0.5) : 0.0;
    add(yarn.fibre, (1 - blend) * needs[i].mass_kg);
    if (yarn.blendFibre) add(*yarn.blendFibre, blend * needs[i].mass_kg);
  }
  for (CompositionPart& part : parts) part.ratio /= whole_kg;
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.ratio > b.ratio; });
  return parts;
}

ListedName constructionOf(const Weave& weave) {
  constexpr size_t kMostShafts = 32;
  const auto code = isoWeaveCode(weave);
  const char kind = code ? code->front() : ' ';
  if (kind == '1') return *code == "10-01 01-01-00" ? ListedName{"Plain weave", ""} : ListedName{"other", *code};
  if (kind == '2' && stepsBy(weave, 1)) return {"Twill - right hand (Z)", ""};
  if (kind == '2' && stepsBy(weave, -1)) return {"Twill - left hand (S)", ""};
  if (kind == '2') return {"Twill", ""};
  if (kind == '3') return {"Satin", ""};
  return {differentEnds(weave, kMostShafts + 1) > kMostShafts ? "Jacquard" : "Dobby", ""};
}

}  // namespace loomlight
