#include "app/cli/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace loomlight {
namespace {

using Kind = ClothPart::Kind;

const std::string& ownName(const ClothPart& part, const Fabric& fabric) {
  const auto index = static_cast<size_t>(part.index);
  return part.kind == Kind::yarn ? fabric.yarns[index].name : fabric.fibres[index].name;
}

std::vector<ClothPart> partsOf(const Fabric& fabric, NamedParts parts) {
  std::vector<ClothPart> all;
  if (parts == NamedParts::yarnsAndFibres)
    for (size_t i = 0; i < fabric.yarns.size(); ++i) all.push_back(partOfYarn(static_cast<int>(i)));
  for (size_t i = 0; i < fabric.fibres.size(); ++i) all.push_back(partOfFibre(static_cast<int>(i)));
  return all;
}

/// Whether a yarn is all that is spun of a fibre, and spun of nothing else: where one lies on top the other does.
bool areOne(const Fabric& fabric, const ClothPart& yarn, const ClothPart& fibre) {
  if (yarn.kind != Kind::yarn || fibre.kind != Kind::fibre) return false;
  const auto isSpunOf = [&](const Yarn& any) { return any.fibre == fibre.index || any.blendFibre == fibre.index; };
  return fibresOf(fabric, yarn) == std::vector{fibre.index} &&
         std::count_if(fabric.yarns.begin(), fabric.yarns.end(), isSpunOf) == 1;
}

/// A yarn's or a fibre's number, as its kind writes it.
bool isNumberOf(std::string_view text, const ClothPart& part) {
  if (part.kind == Kind::yarn) {
    constexpr std::string_view kYarn = "yarn ";
    if (!text.starts_with(kYarn)) return false;
    text.remove_prefix(kYarn.size());
  }
  int number = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && stopped == text.data() + text.size() && number == part.index + 1;
}

std::string numbered(const ClothPart& part, const Fabric& fabric) {
  return fmt::format("{}{} '{}'", part.kind == Kind::yarn ? "yarn " : "", part.index + 1, ownName(part, fabric));
}

}  // namespace

ClothPart partNamed(const std::string& name, const Fabric& fabric, NamedParts parts, const std::string& source) {
  const std::vector<ClothPart> all = partsOf(fabric, parts);
  std::vector<ClothPart> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const ClothPart& part) { return !name.empty() && ownName(part, fabric) == name; });
  if (found.size() == 1 || (found.size() == 2 && areOne(fabric, found[0], found[1]))) return found.front();
  if (!found.empty()) {
    std::string numbers;
    for (const ClothPart& part : found) numbers += (numbers.empty() ? "" : ", ") + numbered(part, fabric);
    throw InputError(fmt::format("{}: expected the number of the {}, as several are named '{}': {}", source,
                                 parts == NamedParts::fibres ? "fibre" : "yarn or fibre", name, numbers));
  }
  if (name == "piece") return wholePiece();
  for (const ClothPart& part : all)
    if (isNumberOf(name, part)) return part;
  std::string names;
  for (const ClothPart& part : all) names += numbered(part, fabric) + ", ";
  throw InputError(fmt::format("{}: expected one of the fabric's {}, {}or 'piece' for all; got '{}'", source,
                               parts == NamedParts::fibres ? "fibres" : "yarns and fibres", names, name));
}

std::string partText(const ClothPart& part, const Fabric& fabric) {
  if (part == wholePiece()) return "the piece";
  return (part.kind == Kind::fibre ? "fibre " : "") + numbered(part, fabric);
}

}  // namespace loomlight
