#include <fmt/format.h>

#include <map>
#include <pugixml.hpp>

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/swatch/cxf_document.h"
#include "core/fabric/swatch/raw_swatch.h"

// How it works. CxF3 (ISO 17972-1) has an Object for each swatch, with a ReflectanceSpectrum, and ColorSpecifications
// that say at which wavelengths and how those were measured. Programs differ in the prefix of the namespace, so names
// are compared without it; and in where the first wavelength and the step stand: at the spectrum or in its
// specification.

namespace loomlight {
namespace {

struct Specification {
  double first_nm = 0, step_nm = 0;
  SpecularComponent specular = SpecularComponent::unknown;
};

std::string allText(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& each : cxfNamed(node, "")) text.append(each.child_value()).append(" ");
  return text;
}

SpecularComponent specularOf(const pugi::xml_node& specification) {
  for (const pugi::xml_node& geometry : cxfNamed(specification, "GeometryChoice")) return specularIn(allText(geometry));
  return SpecularComponent::unknown;
}

std::map<std::string, Specification> specifications(const pugi::xml_document& document) {
  std::map<std::string, Specification> all;
  for (const pugi::xml_node& node : cxfNamed(document, "ColorSpecification")) {
    Specification specification;
    for (const pugi::xml_node& range : cxfNamed(node, "WavelengthRange")) {
      specification.first_nm = range.attribute("StartWL").as_double();
      specification.step_nm = range.attribute("Increment").as_double();
    }
    specification.specular = specularOf(node);
    all[node.attribute("Id").value()] = specification;
  }
  return all;
}

RawSwatch swatchOf(const std::string& name, const pugi::xml_node& spectrum,
                   const std::map<std::string, Specification>& all, const std::string& source) {
  RawSwatch swatch;
  swatch.name = name;
  swatch.place = fmt::format("Object \"{}\"", plainText(swatch.name));
  const auto found = all.find(spectrum.attribute("ColorSpecification").value());
  const Specification specification = found == all.end() ? Specification{} : found->second;
  swatch.specular = specification.specular;
  const double first = spectrum.attribute("StartWL").as_double(specification.first_nm);
  const double step = spectrum.attribute("Increment").as_double(specification.step_nm > 0 ? specification.step_nm : 10);
  for (std::string_view rest = spectrum.child_value();;) {
    const std::string_view word = cxfWord(rest);
    if (word.empty()) break;
    const std::optional<double> value = swatchNumber(word);
    if (!value || swatch.values.size() == kMostSwatchValues)
      throw InputError(fmt::format("{}: {}: expected numbers in ReflectanceSpectrum, at most {}; number {} is {}",
                                   source, swatch.place, kMostSwatchValues, swatch.values.size() + 1,
                                   quotedText(word)));
    swatch.wavelengths_nm.push_back(first + step * static_cast<double>(swatch.values.size()));
    swatch.values.push_back(*value);
  }
  return swatch;
}

}  // namespace

SwatchFile swatchesFromCxf(std::string_view text, const std::string& source) {
  const CxfDocument cxf(text, source);
  const std::map<std::string, Specification> all = specifications(cxf.document());
  std::vector<RawSwatch> swatches;
  constexpr size_t kLongestName = 200;  // bytes: each of many spectra of an object has it
  for (const pugi::xml_node& object : cxfNamed(cxf.document(), "Object")) {
    const std::string name(wholeCharacters(cxfName(object), kLongestName));
    for (const pugi::xml_node& spectrum : cxfNamed(object, "ReflectanceSpectrum")) {
      if (swatches.size() == kMostSwatches)
        throw InputError(fmt::format("{}: expected at most {} swatches", source, kMostSwatches));
      swatches.push_back(swatchOf(name, spectrum, all, source));
    }
  }
  return swatchesOf(std::move(swatches), ReflectanceUnit::usuallyFraction, source);
}

}  // namespace loomlight
