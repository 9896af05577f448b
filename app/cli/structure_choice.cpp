#include "app/cli/structure_choice.h"

#include <fmt/format.h>

#include <sstream>

#include "app/cli/option_values.h"
#include "app/cli/usage_error.h"
#include "core/base/text.h"

namespace loomlight {
namespace {

bool isSameWord(const std::string& a, const std::string& b) {
  return lowerCase(a) == lowerCase(b);
}

const StructureKind& kindNamed(const std::string& option, const std::string& name) {
  std::string names;
  for (const StructureKind& kind : structureLibrary()) {
    if (isSameWord(kind.name, name)) return kind;
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  throw UsageError(fmt::format("{}: expected one of {}; got '{}'", option, names, name));
}

}  // namespace

MadeStructure parseStructure(const std::string& option, const std::string& text) {
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, ',');
  const StructureKind& kind = kindNamed(option, part);
  std::vector<int> values = kind.startValues();
  for (size_t i = 0; std::getline(parts, part, ','); ++i) {
    if (i >= values.size())
      throw UsageError(fmt::format("{}: expected at most {} numbers behind {}", option, values.size(), kind.name));
    const StructureParameter& parameter = kind.parameters[i];
    const std::string which = fmt::format("{}: {}: {}", option, kind.name, parameter.name);
    values[i] = static_cast<int>(parseWhole(which, part, parameter.min, parameter.max));
  }
  MadeStructure made = kind.make(values);
  if (!made.problem.empty()) throw UsageError(fmt::format("{}: {}: {}", option, text, made.problem));
  return made;
}

}  // namespace loomlight
