#include "ui/widgets/choices.h"

#include "core/fabric/model/choice_names.h"
#include "core/fabric/model/lamp_name.h"
#include "ui/words/choice_words.h"

namespace loomlight {
namespace {

/// The names of an enumeration's values: as many as it has, which a lost comma between two would not leave.
template <class Enum, size_t count>
std::span<const char* const> namesOf(const char* const (&names)[count]) {
  static_assert(count == ChoiceNames<Enum>::names.size());
  return names;
}

/// The last of the names is that of a file.
std::span<const char* const> choosable(std::span<const char* const> names, const std::string& file) {
  return file.empty() ? names.first(names.size() - 1) : names;
}

}  // namespace

std::span<const char* const> lightNames(const Light& light) {
  return choosable(namesOf<LightKind>(words::choices::lights), light.file);
}

Light withKind(Light light, LightKind kind) {
  constexpr double kUsualElevation_deg = 45;
  light.kind = kind;
  if (kind == LightKind::sky && light.elevation_deg <= 0) light.elevation_deg = kUsualElevation_deg;
  return light;
}

std::span<const char* const> drapeNames(const Drape& drape) {
  return choosable(namesOf<DrapeKind>(words::choices::drapes), drape.file);
}

std::span<const char* const> fibreSectionNames() {
  return namesOf<FibreSection>(words::choices::fibreSections);
}

std::span<const char* const> twistNames() {
  return namesOf<TwistDirection>(words::choices::twists);
}

std::span<const char* const> layoutNames() {
  return namesOf<FibreLayout>(words::choices::fibreLayouts);
}

std::span<const char* const> illuminantNames(const Light& light) {
  return choosable(namesOf<StandardIlluminant>(words::choices::illuminants), light.illuminantFile);
}

const char* lampLabel(StandardIlluminant lamp) {
  return words::choices::illuminants[static_cast<size_t>(lamp)];
}

std::string lampWord(StandardIlluminant lamp) {
  if (lamp == StandardIlluminant::blackBody) return words::choices::blackBody;
  if (lamp == StandardIlluminant::file) return words::choices::ownLamp;
  return lampName({lamp});
}

std::span<const char* const> observerNames() {
  static constexpr const char* kNames[] = {"2\xC2\xB0", "10\xC2\xB0"};
  return namesOf<Observer>(kNames);
}

std::span<const char* const> methodNames() {
  return namesOf<Method>(words::choices::methods);
}

std::span<const char* const> estimatorNames() {
  return namesOf<Estimator>(words::choices::estimators);
}

std::span<const char* const> eventLawNames() {
  return namesOf<EventLaw>(words::choices::eventLaws);
}

}  // namespace loomlight
