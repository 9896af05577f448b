#include "app/bench/bench_targets.h"

#include <fmt/format.h>

#include <cmath>

#include "app/bench/studies/report_page.h"

namespace loomlight {
namespace {

std::string text(double value, Target::Kind kind) {
  if (std::isnan(value)) return "-";
  switch (kind) {
    case Target::Kind::ratio:
      return ratioText(value);
    case Target::Kind::perSecond:
      return fmt::format("{:.3g} M", value / 1e6);
    case Target::Kind::percent:
      return fmt::format("{:.2f} %", value);
    case Target::Kind::count:
      return fmt::format("{:.0f}", value);
    case Target::Kind::milliseconds:
      return fmt::format("{:.3g} ms", value);
    case Target::Kind::flip:
      return fmt::format("{:.3f}", value);
    case Target::Kind::stepBack:
      return fmt::format("{:.2f} x", value);
  }
  return {};
}

}  // namespace

std::string ratioText(double ratio) {
  if (!(ratio > 0)) return "-";
  return ratio < 1000 ? fmt::format("{:.3g} : 1", ratio) : fmt::format("{:.0f} : 1", ratio);
}

void addTargets(ReportPage& page, const std::string& csv, const std::vector<Target>& targets) {
  page.heading("Where it must get to");
  std::vector<std::vector<std::string>> rows;
  for (const Target& t : targets) {
    std::string ours = text(t.ours, t.kind);
    if (t.standardError > 0) ours += " ± " + text(t.standardError, t.kind);
    rows.push_back({t.what, t.report, t.prototype, text(t.atLeast, t.kind), text(t.aim, t.kind), ours,
                    t.reaches(t.atLeast) ? "yes" : "no", t.reaches(t.aim) ? "yes" : "no"});
  }
  page.table(csv, {"what", "report", "prototype", "at least", "aim", "ours", "at least met", "aim met"}, rows);
}

}  // namespace loomlight
