#include "app/bench/bench_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bench/bench_targets.h"
#include "app/bench/machine_facts.h"
#include "app/bench/studies/accuracy_cloths.h"
#include "app/bench/studies/accuracy_study.h"
#include "app/bench/studies/report_page.h"
#include "app/cli/progress.h"
#include "core/base/stopwatch.h"

namespace loomlight {
namespace {

std::vector<std::string> header() {
  std::vector<std::string> names{"method"};
  for (const AccuracyLight& light : kAccuracyLights) names.push_back(fmt::format("{}, %", light.name));
  names.insert(names.end(), {"half-dome RMS, %", "pixel RMS, %"});
  return names;
}

/// "+0.3 -0.1 +0.2 ± 0.1": the channels, and the largest of their errors.
std::string colourText(const std::array<Estimate, 3>& colour) {
  double error = 0;
  for (const Estimate& e : colour) error = std::max(error, e.standardError);
  return fmt::format("{:+.1f} {:+.1f} {:+.1f} ± {:.1f}", colour[0].value, colour[1].value, colour[2].value, error);
}

std::string estimateText(const Estimate& e) {
  return fmt::format("{:.1f} ± {:.1f}", e.value, e.standardError);
}

void addCloth(ReportPage& page, const std::string& name, const AccuracyStudy& study) {
  std::string file = name;
  std::replace_if(file.begin(), file.end(), [](char c) { return c == ' ' || c == ','; }, '_');
  page.heading(fmt::format("{}{}", static_cast<char>(std::toupper(name.front())), name.substr(1)));
  page.paragraph(fmt::format("A piece of {:.2g} million segments.", study.segments / 1e6));
  std::vector<std::vector<std::string>> rows;
  for (const Accuracy& accuracy : study.methods) {
    std::vector<std::string> row{accuracy.method};
    for (const auto& colour : accuracy.colour) row.push_back(colourText(colour));
    row.push_back(accuracy.halfDome ? estimateText(*accuracy.halfDome) : "-");
    row.push_back(estimateText(accuracy.pixels));
    rows.push_back(std::move(row));
  }
  page.table("accuracy_" + file, header(), rows);
  page.picture("accuracy_" + file, study.picture,
               name +
                   ": fibres, other fibres in the same yarns, ours at resolution 8; under dome, headlight, back light "
                   "and the sun from behind");
}

/// The same of each. nullopt when stopped.
std::optional<std::vector<AccuracyStudy>> addCloths(ReportPage& page, const std::vector<BenchCloth>& cloths,
                                                    const ReportBench& bench, const Task& task) {
  std::vector<AccuracyStudy> studies;
  for (const BenchCloth& cloth : cloths) {
    auto study = studyAccuracy(cloth, bench, task);
    if (!study) return std::nullopt;
    addCloth(page, cloth.name, *study);
    studies.push_back(std::move(*study));
  }
  return studies;
}

/// Of one method, over all cloths: what is measured, in the order of the header. NaN where nothing was.
struct Summary {
  std::string method;
  std::vector<Estimate> rms;
  std::vector<double> worst;
};

/// Of one figure; each inner list is of one cloth, whose channels share their noise.
using PerCloth = std::vector<std::vector<Estimate>>;

/// Root of the mean square, less what noise adds to squares where it does; and the largest.
void addFigure(const PerCloth& cloths, bool noiseAdds, Summary& summary) {
  double squares = 0, variance = 0, worst = 0;
  size_t count = 0;
  for (const std::vector<Estimate>& channels : cloths) {
    double error = 0;
    for (const Estimate& e : channels) {
      squares += std::copysign(e.value * e.value, noiseAdds ? 1 : e.value);
      if (noiseAdds) squares -= e.standardError * e.standardError;
      error += std::hypot(2 * e.value, e.standardError) * e.standardError;
      worst = std::max(worst, std::abs(e.value));
    }
    variance += error * error;
    count += channels.size();
  }
  if (count == 0) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    summary.rms.push_back({kNan, 0});
    summary.worst.push_back(kNan);
    return;
  }
  const double mean = std::max(0.0, squares / static_cast<double>(count));
  const double error = std::sqrt(variance) / static_cast<double>(count);
  // Of a root: d sqrt(x) = dx / (2 sqrt(x)), but no more than the root of an x that is all noise.
  summary.rms.push_back({std::sqrt(mean), std::min(std::sqrt(error), 0.5 * error / std::sqrt(mean))});
  summary.worst.push_back(worst);
}

std::vector<Summary> summarise(const std::vector<AccuracyStudy>& studies) {
  std::vector<Summary> all;
  for (size_t m = 0; m < studies.front().methods.size(); ++m) {
    Summary& summary = all.emplace_back();
    summary.method = studies.front().methods[m].method;
    for (size_t i = 0; i < kAccuracyLights.size(); ++i) {
      PerCloth colours;
      for (const AccuracyStudy& study : studies)
        colours.emplace_back(study.methods[m].colour[i].begin(), study.methods[m].colour[i].end());
      addFigure(colours, true, summary);
    }
    PerCloth halfDomes, pixels;
    for (const AccuracyStudy& study : studies) {
      if (study.methods[m].halfDome) halfDomes.push_back({*study.methods[m].halfDome});
      pixels.push_back({study.methods[m].pixels});
    }
    addFigure(halfDomes, false, summary);
    addFigure(pixels, false, summary);
  }
  return all;
}

std::string figureText(double figure) {
  return std::isnan(figure) ? "-" : fmt::format("{:.2f}", figure);
}

/// Three tables; `csv`: what their files' names begin with.
void addSummaries(ReportPage& page, const std::string& csv, const std::vector<Summary>& summaries) {
  std::vector<std::vector<std::string>> rms, errors, worst;
  for (const Summary& summary : summaries) {
    for (auto* rows : {&rms, &errors, &worst}) rows->push_back({summary.method});
    for (size_t i = 0; i < summary.rms.size(); ++i) {
      const Estimate& e = summary.rms[i];
      rms.back().push_back(figureText(e.value));
      errors.back().push_back(std::isnan(e.value) ? "-" : figureText(e.standardError));
      worst.back().push_back(figureText(summary.worst[i]));
    }
  }
  page.paragraph("Root mean square over cloths and channels, less what noise adds to it:");
  page.table(csv, header(), rms);
  page.paragraph("Its standard error:");
  page.table(csv + "_error", header(), errors);
  page.paragraph("The worst cloth and channel, noise included:");
  page.table(csv + "_worst", header(), worst);
}

constexpr size_t kDome = 0, kHeadlight = 1, kBack = 2, kBehind = 3, kHalfDome = 4, kPixels = 5;

/// NaN where it was not measured.
Estimate rmsOf(const std::vector<Summary>& summaries, const std::string& method, size_t figure) {
  for (const Summary& summary : summaries)
    if (summary.method == method) return summary.rms[figure];
  return {std::numeric_limits<double>::quiet_NaN(), 0};
}

std::vector<Target> targetsOf(const std::vector<Summary>& summaries) {
  const auto target = [&](const char* what, const char* report, const char* prototype, double atLeast, double aim,
                          const char* method, size_t figure) {
    const Estimate ours = rmsOf(summaries, method, figure);
    return Target{what, report, prototype, Target::Kind::percent, atLeast, aim, ours.value, ours.standardError};
  };
  const char *next = "\"next to identical\"", *almost = "\"almost identical\"";
  return {target("mean colour at normal view, dome, resolution 8", next, "2 %", 3, 1, kOurs8, kDome),
          target("the same, headlight", next, "2 %", 5, 1, kOurs8, kHeadlight),
          target("the same, back light", "", "5 %", 3, 1, kOurs8, kBack),
          target("mean colour at normal view, dome, resolution 16", "", "2 %", 2, 0.5, kOurs16, kDome),
          target("the same, headlight", "", "3 %", 3, 1, kOurs16, kHeadlight),
          target("the same, back light", "", "1 %", 2, 0.5, kOurs16, kBack),
          target("half-dome BRDF, dome light, RMS, resolution 8", almost, "5 %", 5, 2, kOurs8, kHalfDome),
          target("light from behind in a direction, resolution 8", "", "17 %", 10, 3, kOurs8, kBehind),
          target("dome RMS per pixel of d / 4.6, resolution 8", "", "4.9 %", 5, 2.5, kOurs8, kPixels)};
}

/// Of cloths as they are worn, at resolution 8: neither the report nor the prototype had any.
std::vector<Target> targetsOfWorn(const std::vector<Summary>& summaries) {
  constexpr struct {
    const char* what;
    size_t figure;
    double atLeast_percent;
  } kWorn[] = {{"cloths as they are worn: dome", kDome, 3}, {"the same, headlight", kHeadlight, 5},
               {"the same, back light", kBack, 5},          {"the same, sun from behind", kBehind, 10},
               {"the same, half-dome, RMS", kHalfDome, 5},  {"the same, RMS per pixel", kPixels, 5}};
  std::vector<Target> targets;
  for (const auto& [what, figure, atLeast_percent] : kWorn) {
    const Estimate ours = rmsOf(summaries, kOurs8, figure);
    targets.push_back(
        {what, "", "", Target::Kind::percent, atLeast_percent, atLeast_percent / 3, ours.value, ours.standardError});
  }
  return targets;
}

}  // namespace

bool benchAccuracy(const ReportBench& bench, const Task& task) {
  Stopwatch watch;
  ReportPage page(bench.folder, "accuracy", "Accuracy: the volume against its own fibres");
  page.paragraph(
      "Each volume is measured against the very fibres that it was made of, in a piece so large that no edge is seen. "
      "Seen from straight above in pixels of d / 4.6 (d: the diameter of the finest yarn): difference of the mean "
      "colour in red, green and blue, under a white dome, a light at the eye, white light from behind, and the sun at "
      "45 degrees from behind. Then the RMS difference of a half-dome of 32 cameras, and of single pixels, under the "
      "dome, both free of noise (<(A1 - R1)(A2 - R2)> / <R1 R2>; below zero where noise has the last word). ± is one "
      "standard error of noise, of the volume and the fibres together. The yardstick is the first line: how far "
      "explicit fibres are from explicit fibres that lie otherwise in the same yarns.");
  std::vector<BenchCloth> cloths = accuracyCloths(), real = realCloths();
  if (bench.quick) {
    cloths.resize(2);
    real.resize(1);
  }
  const auto studies = addCloths(page, cloths, bench, task);
  if (!studies) return false;
  page.heading("Over these cloths");
  const std::vector<Summary> summaries = summarise(*studies);
  addSummaries(page, "accuracy", summaries);
  page.heading("Cloths as they are worn");
  page.paragraph(
      "Those above are of even yarns and, but for the wool, of fibres that lie side by side. Those that follow, of "
      "samples/cloths, have yarns of fibres that stray and stand off, and unevenness in yarns and sett.");
  const auto realStudies = addCloths(page, real, bench, task);
  if (!realStudies) return false;
  page.heading("Over cloths as they are worn");
  const std::vector<Summary> realSummaries = summarise(*realStudies);
  addSummaries(page, "accuracy_real", realSummaries);
  page.paragraph(fmt::format("Measured in {} on {}", durationText(watch.lap()), machineFacts(task.threads)));
  std::vector<Target> targets = targetsOf(summaries);
  for (Target& worn : targetsOfWorn(realSummaries)) targets.push_back(std::move(worn));
  addTargets(page, "accuracy_targets", targets);
  fmt::print("{}\n", page.finish());
  return true;
}

}  // namespace loomlight
