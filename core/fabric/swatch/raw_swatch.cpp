#include "core/fabric/swatch/raw_swatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/wif/wif_values.h"

// How it works. Percent or fraction is a matter of the file, not of a swatch: the values of all are looked at together.
// Nothing but a brightener reflects more than 1, and that only in some bands, so a file whose largest value is above 2,
// or in which most values of some swatch are above 1, holds percents; one with none above 1 is taken to hold fractions.
// Between them a black in percent and a brightened white in fractions look alike, so the file has to say its unit.

namespace loomlight {
namespace {

constexpr double kNeededFrom_nm = 400, kNeededTo_nm = 700;
constexpr double kFinestStep_nm = 1, kCoarsestStep_nm = 20;
constexpr double kSame_nm = 0.01;      // wavelengths that differ by less are the same
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

bool largestIsAbove(const std::vector<RawSwatch>& all, double limit) {
  return std::any_of(all.begin(), all.end(), [limit](const RawSwatch& raw) {
    return *std::max_element(raw.values.begin(), raw.values.end()) > limit;
  });
}

bool looksLikePercent(const std::vector<RawSwatch>& all) {
  return largestIsAbove(all, kMost) ||
         std::any_of(all.begin(), all.end(), [](const RawSwatch& raw) { return median(raw.values) > 1; });
}

bool isEven(const std::vector<double>& nm) {
  const double step = (nm.back() - nm.front()) / static_cast<double>(nm.size() - 1);
  for (size_t i = 0; i < nm.size(); ++i)
    if (std::abs(nm[i] - (nm.front() + step * static_cast<double>(i))) > kSame_nm) return false;
  return true;
}

/// What most of the steps are; of as many the smaller.
double commonestStep(const std::vector<double>& nm) {
  std::map<double, int> counts;
  for (size_t i = 1; i < nm.size(); ++i) ++counts[std::round((nm[i] - nm[i - 1]) / kSame_nm) * kSame_nm];
  const auto isRarer = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(counts.begin(), counts.end(), isRarer)->first;
}

/// Of wavelengths that are not even: the first that is amiss.
std::string whatIsAmiss(const std::vector<double>& nm, double step) {
  size_t i = 1;
  while (i + 1 < nm.size() && std::abs(nm[i] - nm[i - 1] - step) <= 2 * kSame_nm) ++i;
  const double gap = nm[i] - nm[i - 1], steps = std::round(gap / step);
  if (steps < 2 || std::abs(gap - steps * step) > steps * kSame_nm)
    return fmt::format("{:g} nm does not fit behind {:g} nm", nm[i], nm[i - 1]);
  const double first = nm[i - 1] + step, last = nm[i] - step;
  return steps < 3 ? fmt::format("{:g} nm is missing", first) : fmt::format("{:g} to {:g} nm are missing", first, last);
}

void expectGrid(const RawSwatch& raw, const std::string& source) {
  const std::vector<double>& nm = raw.wavelengths_nm;
  if (nm.size() < 2 || nm.front() > kNeededFrom_nm || nm.back() < kNeededTo_nm)
    refuse(
        source, raw,
        fmt::format("expected a reflectance at each wavelength from {} nm or less to {} nm or more{}", kNeededFrom_nm,
                    kNeededTo_nm, nm.empty() ? "" : fmt::format("; there is {:g} to {:g} nm", nm.front(), nm.back())));
  const bool even = isEven(nm);
  const double step = even ? (nm.back() - nm.front()) / static_cast<double>(nm.size() - 1) : commonestStep(nm);
  if (!(step >= kFinestStep_nm && step <= kCoarsestStep_nm) || nm.size() > kMostSwatchValues)
    refuse(
        source, raw,
        fmt::format("expected wavelengths {} to {} nm apart; they are {:g}", kFinestStep_nm, kCoarsestStep_nm, step));
  if (!even)
    refuse(source, raw,
           fmt::format("expected wavelengths in equal steps, {:g} nm as most are; {}", step, whatIsAmiss(nm, step)));
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
  std::vector<const MeasuredSwatch*> brightened, narrow, included, excluded;
  for (const MeasuredSwatch& swatch : file.swatches) {
    if (*std::max_element(swatch.values.begin(), swatch.values.end()) > 1) brightened.push_back(&swatch);
    if (swatch.specular == SpecularComponent::included) included.push_back(&swatch);
    if (swatch.specular == SpecularComponent::excluded) excluded.push_back(&swatch);
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
  if (!included.empty() && !excluded.empty())
    file.remarks.push_back(
        fmt::format("{} was measured with what the surface mirrors (SCI), {} without (SCE). Only two that agree in it "
                    "should be compared.",
                    countedNames(included), countedNames(excluded)));
}

/// Whether the numbers are percents. Throws InputError where only the file could say it.
bool isPercent(const std::vector<RawSwatch>& raw, ReflectanceUnit unit, const std::string& source,
               std::string_view howToSay) {
  if (unit == ReflectanceUnit::percent || unit == ReflectanceUnit::fraction) return unit == ReflectanceUnit::percent;
  if (looksLikePercent(raw)) return true;
  if (unit == ReflectanceUnit::unsaid && largestIsAbove(raw, 1))
    throw InputError(
        fmt::format("{}: expected a file that says its unit where its largest value is between 1 and 2, which may be a "
                    "black in percent or a brightened white in fractions of 1{}",
                    source, howToSay));
  return false;
}

std::string_view unitRemark(ReflectanceUnit unit, bool percent) {
  if (unit == ReflectanceUnit::unsaid)
    return percent ? "The file does not say its unit; its numbers are taken as percent."
                   : "The file does not say its unit; its numbers are taken as fractions of 1.";
  if (unit == ReflectanceUnit::usuallyFraction && percent)
    return "Files of this kind hold fractions of 1, but these numbers are too large for that; they are taken as "
           "percent.";
  return {};
}

}  // namespace

SwatchFile swatchesOf(std::vector<RawSwatch> raw, ReflectanceUnit unit, const std::string& source,
                      std::string_view howToSay) {
  if (raw.empty()) throw InputError(fmt::format("{}: expected reflectances over wavelength; there are none", source));
  if (raw.size() > kMostSwatches)
    throw InputError(fmt::format("{}: expected at most {} swatches; there are {}", source, kMostSwatches, raw.size()));
  for (const RawSwatch& swatch : raw) expectGrid(swatch, source);
  const bool percent = isPercent(raw, unit, source, howToSay);
  SwatchFile file;
  for (RawSwatch& swatch : raw) {
    // What stands in a swatch's name is nearer to it than what the file says of all.
    if (const auto own = specularIn(swatch.name); own != SpecularComponent::unknown) swatch.specular = own;
    expectReflectances(swatch, percent ? 0.01 : 1, source);
    file.swatches.push_back(measured(swatch, percent ? 0.01 : 1));
    std::string& name = file.swatches.back().name;
    if (!name.empty()) continue;
    name = std::filesystem::path(source).stem().string();
    if (raw.size() > 1) name += fmt::format(" {}", file.swatches.size());
  }
  if (const std::string_view said = unitRemark(unit, percent); !said.empty()) file.remarks.emplace_back(said);
  remark(file);
  return file;
}

bool saysWord(std::string_view text, std::string_view lowerCaseWord) {
  const std::string lower = lowerCase(text);
  const auto isLetter = [&](size_t i) { return i < lower.size() && lower[i] >= 'a' && lower[i] <= 'z'; };
  for (size_t at = lower.find(lowerCaseWord); at != std::string::npos; at = lower.find(lowerCaseWord, at + 1))
    if (!(at > 0 && isLetter(at - 1)) && !isLetter(at + lowerCaseWord.size())) return true;
  return false;
}

SpecularComponent specularIn(std::string_view text) {
  const bool inWords = lowerCase(text).find("specular") != std::string::npos;
  const bool excluded = saysWord(text, "sce") || (inWords && saysWord(text, "excluded"));
  const bool included = saysWord(text, "sci") || (inWords && saysWord(text, "included"));
  if (excluded == included) return SpecularComponent::unknown;
  return excluded ? SpecularComponent::excluded : SpecularComponent::included;
}

void expectNoKubelkaMunk(std::string_view text, const std::string& source) {
  if (saysWord(text, "k/s"))
    throw InputError(fmt::format("{}: expected reflectances; the file says that its numbers are K/S", source));
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
