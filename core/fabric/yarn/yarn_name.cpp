#include "core/fabric/yarn/yarn_name.h"

#include <fmt/format.h>

#include "core/fabric/yarn/colour_name.h"

namespace loomlight {
namespace {

/// Three digits, without zeros that say nothing.
std::string shortNumber(double value) {
  std::string text = fmt::format("{:.{}f}", value, value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2);
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string writtenCount(const Yarn& yarn, const Fibre& fibre, CountSystem system) {
  const std::string single = shortNumber(countFromTex(yarnCount_tex(yarn, fibre) / singlesIn(yarn), system));
  const char* const unit = countUnit(system);
  if (singlesIn(yarn) == 1) return fmt::format("{} {}", single, unit);
  if (!isIndirect(system))
    return yarn.cords > 1 ? fmt::format("{} {} x {} x {}", single, unit, yarn.plies, yarn.cords)
                          : fmt::format("{} {} x {}", single, unit, yarn.plies);
  if (yarn.cords > 1) return fmt::format("{}/{}/{} {}", single, yarn.plies, yarn.cords, unit);
  if (system == CountSystem::metric) return fmt::format("{}/{} {}", yarn.plies, single, unit);
  return fmt::format("{}/{} {}", single, yarn.plies, unit);
}

std::string yarnLetters(int index) {
  std::string letters;
  for (int rest = index; rest >= 0; rest = rest / 26 - 1)
    letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters;
}

std::string yarnName(const Fabric& fabric, int index, const Rgb& colour, CountSystem system) {
  const Yarn& yarn = fabric.yarns[static_cast<size_t>(index)];
  if (!yarn.name.empty()) return yarn.name;
  return fmt::format("{} {}", colourName(colour), writtenCount(yarn, meanFibre(yarn, fabric.fibres), system));
}

}  // namespace loomlight
