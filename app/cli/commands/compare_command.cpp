#include "app/cli/commands/compare_command.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/json/json_text.h"
#include "render/metrics/comparison.h"
#include "render/metrics/heat_map.h"

namespace loomlight {
namespace {

/// Of one pair, and of the same pair rendered again.
struct Measures {
  PictureNames names;
  std::optional<PictureNames> again;
  int width = 0, height = 0;
  Comparison comparison;
  std::optional<double> noiseFreeBias;
};

Measures measure(const PictureNames& names, const std::optional<PictureNames>& again, const CompareCommand& command) {
  PicturePair pair = readPair(names.picture, names.reference);
  Measures measures{names, again, pair.reference.width, pair.reference.height, {}, {}};
  if (again) measures.noiseFreeBias = noiseFreeBias(pair, readPair(again->picture, again->reference));
  measures.comparison = compare(std::move(pair), command.viewing, command.threads);
  return measures;
}

/// The measures of a yardstick depend on the size of its pixels, so it must have as many.
void expectSameSize(const Measures& measured, const Measures& yardstick) {
  if (yardstick.width == measured.width && yardstick.height == measured.height) return;
  throw InputError(fmt::format("{}: expected {} x {} pixels as in {}, got {} x {}", yardstick.names.reference,
                               measured.width, measured.height, measured.names.reference, yardstick.width,
                               yardstick.height));
}

/// The root of the squared relative difference; below zero where noise made the estimate so.
double rms_percent(double noiseFreeBias) {
  return 100 * std::copysign(std::sqrt(std::abs(noiseFreeBias)), noiseFreeBias);
}

nlohmann::ordered_json toJson(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

nlohmann::ordered_json toJson(const Measures& of) {
  const Comparison& c = of.comparison;
  nlohmann::ordered_json json;
  json["picture"] = of.names.picture;
  json["reference"] = of.names.reference;
  json["non_finite_pixels"] = c.nonFinite;
  json["reference_non_finite_pixels"] = c.referenceNonFinite;
  json["relative_mse"] = c.relMse;
  json["rmse"] = c.rmse;
  json["mean"] = toJson(c.mean);
  json["reference_mean"] = toJson(c.referenceMean);
  json["mean_difference_percent"] = toJson(c.meanDifference_percent());
  json["ciede2000_of_means"] = c.ciede2000;
  json["flip_mean"] = c.flipMean;
  json["flip_largest"] = c.flipLargest;
  if (of.noiseFreeBias) {
    json["noise_free_bias"] = *of.noiseFreeBias;
    json["noise_free_rms_percent"] = rms_percent(*of.noiseFreeBias);
    json["again"] = {of.again->picture, of.again->reference};
  } else {
    json["noise_free_bias"] = nullptr;
  }
  return json;
}

void printJson(const CompareCommand& command, const Measures& measured, const std::optional<Measures>& yardstick) {
  nlohmann::ordered_json json = toJson(measured);
  json["width"] = measured.width;
  json["height"] = measured.height;
  json["exposure_stops"] = command.viewing.exposure_stops;
  json["pixels_per_degree"] = command.viewing.pixelsPerDegree;
  json["yardstick"] = yardstick ? toJson(*yardstick) : nlohmann::ordered_json(nullptr);
  if (!command.heatMap.empty()) json["heat_map"] = {{"file", command.heatMap}, {"range", {0, command.heatRange}}};
  fmt::print("{}\n", jsonText(json, 2));
}

/// A row: what was measured, and beside it the yardstick.
class Table {
 public:
  explicit Table(bool yardstick) : yardstick_(yardstick) {
    fmt::print("  {:<28}{:>14}", "", "measured");
    if (yardstick_) fmt::print("{:>14}", "yardstick");
    fmt::print("\n");
  }

  void row(const char* label, const char* format, double measured, double yardstick) const {
    fmt::print("  {:<28}{:>14}", label, text(format, measured));
    if (yardstick_) fmt::print("{:>14}", text(format, yardstick));
    fmt::print("\n");
  }

 private:
  static std::string text(const char* format, double value) {
    return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
  }

  bool yardstick_;
};

double biasOf(const Measures& measures) {
  return measures.noiseFreeBias.value_or(std::nan(""));
}

void printTable(const CompareCommand& command, const Measures& measured, const std::optional<Measures>& yardstick) {
  fmt::print("{} against {}: {} x {}, exposure {:+g} stops, {:g} pixels per degree\n", measured.names.picture,
             measured.names.reference, measured.width, measured.height, command.viewing.exposure_stops,
             command.viewing.pixelsPerDegree);
  if (yardstick)
    fmt::print("yardstick: {} against {}\n\n", yardstick->names.picture, yardstick->names.reference);
  else
    fmt::print("yardstick: none; --yardstick takes two fibre arrangements of the same yarns\n\n");

  const Measures& other = yardstick ? *yardstick : measured;
  const Comparison &m = measured.comparison, &y = other.comparison;
  const Table table(yardstick.has_value());
  table.row("relMSE", "{:.4g}", m.relMse, y.relMse);
  table.row("RMSE", "{:.4g}", m.rmse, y.rmse);
  table.row("FLIP, mean", "{:.4f}", m.flipMean, y.flipMean);
  table.row("FLIP, largest", "{:.4f}", m.flipLargest, y.flipLargest);
  table.row("CIEDE2000 of the means", "{:.3f}", m.ciede2000, y.ciede2000);
  const char* const channels[] = {"mean red", "mean green", "mean blue"};
  for (int i = 0; i < 3; ++i)
    table.row(channels[i], "{:+.2f} %", m.meanDifference_percent()[i], y.meanDifference_percent()[i]);
  if (measured.noiseFreeBias || other.noiseFreeBias) {
    table.row("noise-free bias", "{:.3e}", biasOf(measured), biasOf(other));
    table.row("  as relative rms", "{:.2f} %", rms_percent(biasOf(measured)), rms_percent(biasOf(other)));
  }
  if (!command.heatMap.empty())
    fmt::print("\n{}: FLIP from 0 (black) to {:g} (white)\n", command.heatMap, command.heatRange);
}

/// Goes to stderr as well, so that a script that reads one number hears of it.
void warnOfNonFinite(const Measures& of) {
  const auto warn = [](const std::string& file, size_t pixels) {
    if (pixels > 0)
      fmt::print(stderr, "loomlight: {}: {} pixels are not finite, and left out of every measure\n", file, pixels);
  };
  warn(of.names.picture, of.comparison.nonFinite);
  warn(of.names.reference, of.comparison.referenceNonFinite);
}

void writeHeatMap(const CompareCommand& command, const Measures& measured) {
  const std::string range = fmt::format("FLIP from 0 (black) to {:g} (white)", command.heatRange);
  writePng(command.heatMap, heatMap(measured.comparison.flip, measured.width, measured.height, command.heatRange),
           {{"Description", range}});
}

}  // namespace

int run(const CompareCommand& command) {
  if (!command.heatMap.empty() && lowerExtension(command.heatMap) != ".png")
    throw InputError(fmt::format("{}: expected the name of a picture (.png)", command.heatMap));
  const Measures measured = measure(command.pictures, command.again, command);
  std::optional<Measures> yardstick;
  if (command.yardstick) {
    yardstick = measure(*command.yardstick, command.yardstickAgain, command);
    expectSameSize(measured, *yardstick);
  }
  if (!command.heatMap.empty()) writeHeatMap(command, measured);
  warnOfNonFinite(measured);
  if (yardstick) warnOfNonFinite(*yardstick);
  if (command.json)
    printJson(command, measured, yardstick);
  else
    printTable(command, measured, yardstick);
  return 0;
}

}  // namespace loomlight
