#include "core/fabric/swatch/raw_swatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/wif/wif_values.h"

// How it works. Percent or fraction is a matter of the file, not of a swatch: the values of all are looked at together.
// Nothing but a brightener reflects more than 1, and that only in some bands, so a file whose largest value is above 2,
// or in which most values of some swatch are above 1, holds percents.

namespace loomlight {
namespace {

constexpr double kNeededFrom_nm = 400, kNeededTo_nm = 700;
constexpr double kFinestStep_nm = 1, kCoarsestStep_nm = 20;
constexpr double kMost = 2;            // of a reflectance factor; brighteners reach 1.5
constexpr double kBelowBlack = -0.02;  // an instrument's noise around 0

[[noreturn]] void refuse(const std::string& source, const RawSwatch& raw, const std::string& expected) {
  throw InputError(fmt::format("{}: {}: {}", source, raw.place, expected));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool looksLikePercent(const std::vector<RawSwatch>& all) {
  return std::any_of(all.begin(), all.end(), [](const RawSwatch& raw) {
    return *std::max_element(raw.values.begin(), raw.values.end()) > kMost || median(raw.values) > 1;
  });
}

void expectGrid(const RawSwatch& raw, const std::string& source) {
  const std::vector<double>& nm = raw.wavelengths_nm;
  if (nm.size() < 2 || nm.front() > kNeededFrom_nm || nm.back() < kNeededTo_nm)
    refuse(
        source, raw,
        fmt::format("expected a reflectance at each wavelength from {} nm or less to {} nm or more{}", kNeededFrom_nm,
                    kNeededTo_nm, nm.empty() ? "" : fmt::format("; there is {:g} to {:g} nm", nm.front(), nm.back())));
  const double step = (nm.back() - nm.front()) / static_cast<double>(nm.size() - 1);
  if (!(step >= kFinestStep_nm && step <= kCoarsestStep_nm) || nm.size() > kMostSwatchValues)
    refuse(
        source, raw,
        fmt::format("expected wavelengths {} to {} nm apart; they are {:g}", kFinestStep_nm, kCoarsestStep_nm, step));
  for (size_t i = 0; i < nm.size(); ++i)
    if (std::abs(nm[i] - (nm.front() + step * static_cast<double>(i))) > 0.01)
      refuse(source, raw,
             fmt::format("expected wavelengths in equal steps; {:g} nm does not fit, or one is missing", nm[i]));
}

void expectReflectances(const RawSwatch& raw, double scale, const std::string& source) {
  for (size_t i = 0; i < raw.values.size(); ++i)
    if (!(raw.values[i] * scale >= kBelowBlack && raw.values[i] * scale <= kMost))
      refuse(source, raw,
             fmt::format("expected a reflectance of 0 to 1, or of 0 to 100 %; at {:g} nm it is {:g}{}",
                         raw.wavelengths_nm[i], raw.values[i], scale < 1 ? " %" : ""));
}

MeasuredSwatch measured(RawSwatch& raw, double scale) {
  for (double& value : raw.values) value = std::max(0.0, value * scale);
  const double first = raw.wavelengths_nm.front();
  const double step = (raw.wavelengths_nm.back() - first) / static_cast<double>(raw.values.size() - 1);
  return {std::move(raw.name), first, step, std::move(raw.values), raw.specular};
}

std::string countedNames(const std::vector<const MeasuredSwatch*>& some) {
  return some.size() == 1 ? fmt::format("\"{}\"", plainText(some[0]->name))
                          : fmt::format("\"{}\" and {} more", plainText(some[0]->name), some.size() - 1);
}

/// What will look otherwise than measured, once for all swatches that it is true of.
void remark(SwatchFile& file) {
  std::vector<const MeasuredSwatch*> brightened, narrow;
  for (const MeasuredSwatch& swatch : file.swatches) {
    if (*std::max_element(swatch.values.begin(), swatch.values.end()) > 1) brightened.push_back(&swatch);
    if (swatch.first_nm > kFirstBand_nm || swatch.last_nm() < bandWavelength_nm(kBands - 1)) narrow.push_back(&swatch);
  }
  if (!brightened.empty())
    file.remarks.push_back(
        fmt::format("{} reflects more than 100 % somewhere, as brighteners do. Fluorescence is not "
                    "modelled: it is taken as 100 % there.",
                    countedNames(brightened)));
  if (!narrow.empty())
    file.remarks.push_back(
        fmt::format("{} was measured from {:g} to {:g} nm; beyond, the reflectance is taken to stay as "
                    "it is there.",
                    countedNames(narrow), narrow[0]->first_nm, narrow[0]->last_nm()));
}

}  // namespace

SwatchFile swatchesOf(std::vector<RawSwatch> raw, ReflectanceUnit unit, const std::string& source) {
  if (raw.empty()) throw InputError(fmt::format("{}: expected reflectances over wavelength; there are none", source));
  if (raw.size() > kMostSwatches)
    throw InputError(fmt::format("{}: expected at most {} swatches; there are {}", source, kMostSwatches, raw.size()));
  for (const RawSwatch& swatch : raw) expectGrid(swatch, source);
  const bool percent = unit == ReflectanceUnit::percent || (unit == ReflectanceUnit::guess && looksLikePercent(raw));
  SwatchFile file;
  for (RawSwatch& swatch : raw) {
    expectReflectances(swatch, percent ? 0.01 : 1, source);
    file.swatches.push_back(measured(swatch, percent ? 0.01 : 1));
    std::string& name = file.swatches.back().name;
    if (!name.empty()) continue;
    name = std::filesystem::path(source).stem().string();
    if (raw.size() > 1) name += fmt::format(" {}", file.swatches.size());
  }
  if (unit == ReflectanceUnit::guess)
    file.remarks.push_back(percent ? "The file does not say its unit; its numbers are taken as percent."
                                   : "The file does not say its unit; its numbers are taken as fractions of 1.");
  remark(file);
  return file;
}

SpecularComponent specularIn(std::string_view text) {
  const std::string lower = lowerCase(text);
  const auto isLetter = [&](size_t i) { return i < lower.size() && lower[i] >= 'a' && lower[i] <= 'z'; };
  const auto hasWord = [&](std::string_view word) {
    for (size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1))
      if (!(at > 0 && isLetter(at - 1)) && !isLetter(at + word.size())) return true;
    return false;
  };
  const bool inWords = lower.find("specular") != std::string::npos;
  const bool excluded = hasWord("sce") || (inWords && hasWord("excluded"));
  const bool included = hasWord("sci") || (inWords && hasWord("included"));
  if (excluded == included) return SpecularComponent::unknown;
  return excluded ? SpecularComponent::excluded : SpecularComponent::included;
}

std::optional<double> wavelengthIn(std::string_view title) {
  std::string bare;
  for (const char c : lowerCase(title))
    if (std::string_view(" _[]()\"\t").find(c) == std::string_view::npos) bare += c;
  std::string_view rest = bare;
  if (rest.ends_with("nm")) rest.remove_suffix(2);
  const size_t digits = std::min(rest.find_first_of("0123456789"), rest.size());
  constexpr std::string_view kPrefixes[] = {"",           "nm",   "r",  "r%",   "%r",         "spectral",
                                            "spectralnm", "spec", "wl", "refl", "reflectance"};
  if (std::find(std::begin(kPrefixes), std::end(kPrefixes), rest.substr(0, digits)) == std::end(kPrefixes))
    return std::nullopt;
  const std::optional<double> nm = swatchNumber(rest.substr(digits));
  return nm && *nm >= 200 && *nm <= 1200 ? nm : std::nullopt;
}

std::optional<double> swatchNumber(std::string_view text, bool comma) {
  std::string number(trimmed(text).substr(0, 64));
  if (comma)
    if (const size_t at = number.find(','); at != std::string::npos) number[at] = '.';
  double value = 0;
  const char* const end = number.data() + number.size();
  const auto [rest, error] = std::from_chars(number.data() + number.starts_with('+'), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace loomlight
