#include <fmt/format.h>

#include <map>

#include "core/base/error.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/palette/palette_readers.h"
#include "core/fabric/swatch/cxf_document.h"
#include "core/fabric/swatch/raw_swatch.h"

// How it works. Each Object of a book has one colour or several of the same: its reflectance is taken where it has one,
// then its CIELAB, then its sRGB. Reflectances are read and checked as those of any instrument, all at once.

namespace loomlight {
namespace {

double numberIn(const pugi::xml_node& node, const char* name, const std::string& place) {
  for (const pugi::xml_node& each : cxfNamed(node, name))
    if (const std::optional<double> value = swatchNumber(each.child_value())) return *value;
  throw InputError(fmt::format("{}: expected a number in {}", place, name));
}

std::string wordIn(const pugi::xml_node& node, const char* name) {
  for (const pugi::xml_node& each : cxfNamed(node, name)) return each.child_value();
  return {};
}

class CxfReader {
 public:
  CxfReader(std::string_view text, const std::string& source) : cxf_(text, source), source_(source) {
    for (const pugi::xml_node& node : cxfNamed(cxf_.document(), "ColorSpecification"))
      specifications_[node.attribute("Id").value()] = node;
    if (cxfNamed(cxf_.document(), "ReflectanceSpectrum").empty()) return;
    SwatchFile file = swatchesFromCxf(text, source);
    swatches_ = std::move(file.swatches);
    palette_.remarks = std::move(file.remarks);
  }

  Palette all() {
    for (const pugi::xml_node& object : cxfNamed(cxf_.document(), "Object")) take(object);
    return std::move(palette_);
  }

 private:
  void take(const pugi::xml_node& object) {
    const std::string name = cxfName(object), place = fmt::format("{}: Object \"{}\"", source_, plainText(name));
    // The swatches are in the order in which this walk meets their spectra.
    const size_t spectra = cxfNamed(object, "ReflectanceSpectrum").size();
    if (spectra > 0) {
      const MeasuredSwatch& swatch = swatches_[next_];
      next_ += spectra;
      if (palette_.colours.size() == kMostColours)
        throw InputError(fmt::format("{}: expected at most {} colours", place, kMostColours));
      palette_.colours.push_back({swatch.name, Rgb(0), std::nullopt, bandReflectance(swatch)});
      return;
    }
    for (const pugi::xml_node& lab : cxfNamed(object, "ColorCIELab"))
      return addLab(palette_, name, labOf(lab, place), place);
    for (const char* model : {"ColorSRGB", "ColorRGB"})
      for (const pugi::xml_node& rgb : cxfNamed(object, model)) {
        const double most = rgb.attribute("MaxRange").as_double(255);
        const glm::dvec3 colour(numberIn(rgb, "R", place), numberIn(rgb, "G", place), numberIn(rgb, "B", place));
        return addSrgb(palette_, name, colour / most, place);
      }
  }

  WhiteLab labOf(const pugi::xml_node& node, const std::string& place) const {
    WhiteLab lab{numberIn(node, "L", place), numberIn(node, "A", place), numberIn(node, "B", place)};
    const auto found = specifications_.find(node.attribute("ColorSpecification").value());
    if (found == specifications_.end()) return lab;
    if (const std::string illuminant = wordIn(found->second, "Illuminant"); !illuminant.empty())
      lab.illuminant = illuminant;
    if (wordIn(found->second, "Observer").starts_with("10")) lab.observer_degrees = 10;
    return lab;
  }

  CxfDocument cxf_;
  const std::string& source_;
  std::map<std::string, pugi::xml_node> specifications_;
  std::vector<MeasuredSwatch> swatches_;
  size_t next_ = 0;  ///< of the swatches
  Palette palette_;
};

}  // namespace

Palette paletteFromCxf(std::string_view text, const std::string& source) {
  return CxfReader(text, source).all();
}

}  // namespace loomlight
