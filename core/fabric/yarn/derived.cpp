#include "core/fabric/yarn/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/yarn/long_floats.h"

// How it works. What follows from a fabric without its geometry, by the formulas of the trade. Cover (Peirce 1937):
// K = ends or picks per inch / sqrt(cotton count), 28 where round yarns touch, and for both systems together Kw + Kf
// - Kw Kf / 28. Floats: each end and pick is a ring of crossings; one pass over the rows counts the runs of all of
// them at once. Mass: tex times length in a square metre, crimp included. Jamming: Peirce's condition that yarns
// which touch at every interlacing fill the repeat; above 1 they do not fit. Cost: one pass over the weave for
// floats and interlacings, one over the sequences for means.

namespace loomlight {
namespace {

/// Mean of f(yarn, its fibre) over the ends or picks of a system.
template <class F>
double meanOverYarns(const Fabric& fabric, System system, F&& f) {
  const std::vector<int>& sequence = fabric.sequence(system);
  double sum = 0;
  for (const int index : sequence) {
    const Yarn& yarn = fabric.yarns[index];
    sum += f(yarn, meanFibre(yarn, fabric.fibres));
  }
  return sum / static_cast<double>(sequence.size());
}

/// The runs of one end or pick, met crossing by crossing; the run at the start joins the one at the end.
class RunCounter {
 public:
  void meet(bool up) {
    if (length_ > 0 && up == up_) {
      ++length_;
    } else {
      close();
      up_ = up;
      length_ = 1;
    }
  }
  /// Ends it. False if it never changed sides.
  bool finish() {
    if (!changed_) return false;
    if (up_ == firstUp_) {
      length_ += firstLength_;
    } else {
      note(firstUp_, firstLength_);
    }
    note(up_, length_);
    return true;
  }
  int longestUp() const { return longest_[1]; }
  int longestDown() const { return longest_[0]; }

 private:
  void note(bool up, int length) { longest_[up] = std::max(longest_[up], length); }
  void close() {
    if (length_ == 0) return;
    if (changed_) {
      note(up_, length_);
    } else {
      changed_ = true;
      firstUp_ = up_;
      firstLength_ = length_;
    }
  }

  int longest_[2] = {0, 0};
  int length_ = 0;
  int firstLength_ = 0;
  bool up_ = false;
  bool firstUp_ = false;
  bool changed_ = false;
};

int64_t patternRepeat(int weave, const std::vector<int>& sequence, const std::vector<double>& spacing) {
  const int64_t colours = std::lcm(int64_t{weave}, static_cast<int64_t>(sequence.size()));
  return std::lcm(colours, int64_t{spacingRepeat(spacing)});
}

}  // namespace

CoverFactors coverFactors(const Fabric& fabric) {
  constexpr double kClosed = 28;
  // K = ends or picks per inch / sqrt(Ne) with Ne = 590.5 / T.
  const auto factor = [&](System system, double threads_per_cm) {
    return 2.54 * threads_per_cm * meanOverYarns(fabric, system, [](const Yarn& yarn, const Fibre& fibre) {
             return std::sqrt(1.0 / countFromTex(yarnCount_tex(yarn, fibre), CountSystem::cotton));
           });
  };
  CoverFactors k;
  k.warp = factor(System::warp, fabric.ends_per_cm);
  k.weft = factor(System::weft, fabric.picks_per_cm);
  // Yarns that touch cover all there is: those that are closer lie over each other.
  const double warp = std::min(k.warp, kClosed), weft = std::min(k.weft, kClosed);
  k.cloth = warp + weft - warp * weft / kClosed;
  k.fraction = k.cloth / kClosed;
  return k;
}

Floats floats(const Weave& weave) {
  Floats found;
  // Row by row, all columns at once: the weave is stored by rows.
  std::vector<RunCounter> ends(static_cast<size_t>(weave.ends()));
  for (int p = 0; p < weave.picks(); ++p) {
    RunCounter pick;
    const std::span<const uint8_t> row = weave.row(p);
    for (size_t e = 0; e < row.size(); ++e) {
      pick.meet(row[e] != 0);
      ends[e].meet(row[e] != 0);
    }
    if (!pick.finish()) ++found.idlePicks;
    found.weftFace = std::max(found.weftFace, pick.longestDown());
    found.weftBack = std::max(found.weftBack, pick.longestUp());
  }
  for (RunCounter& end : ends) {
    if (!end.finish()) ++found.idleEnds;
    found.warpFace = std::max(found.warpFace, end.longestUp());
    found.warpBack = std::max(found.warpBack, end.longestDown());
  }
  return found;
}

double floatLength_mm(const Fabric& fabric, System system, int cells) {
  return cells * fabric.pitch_mm(crossSystem(system));
}

CrossingShape crossingShape(const Fabric& fabric) {
  constexpr double kFlattest = 0.125;
  const double heightOverWidth = std::clamp(fabric.ends_per_cm / fabric.picks_per_cm, kFlattest, 1 / kFlattest);
  return heightOverWidth < 1 ? CrossingShape{1 / heightOverWidth, 1} : CrossingShape{1, heightOverWidth};
}

int64_t patternEnds(const Fabric& fabric) {
  return patternRepeat(fabric.weave.ends(), fabric.warpSequence, fabric.warpSpacing);
}

int64_t patternPicks(const Fabric& fabric) {
  return patternRepeat(fabric.weave.picks(), fabric.weftSequence, fabric.weftSpacing);
}

Binding binding(const Weave& weave) {
  Binding b;
  for (int p = 0; p < weave.picks(); ++p) {
    const std::span<const uint8_t> row = weave.row(p);
    const std::span<const uint8_t> next = weave.row((p + 1) % weave.picks());
    for (size_t e = 0; e < row.size(); ++e) {
      const bool up = row[e] != 0;
      b.warpUpCells += up;
      b.weftInterlacings += up != (row[e + 1 < row.size() ? e + 1 : 0] != 0);
      b.warpInterlacings += up != (next[e] != 0);
    }
  }
  b.warpOnFace = static_cast<double>(b.warpUpCells) / (static_cast<double>(weave.ends()) * weave.picks());
  return b;
}

double meanCount_tex(const Fabric& fabric, System system) {
  return meanOverYarns(fabric, system, yarnCount_tex);
}

double meanDiameter_mm(const Fabric& fabric, System system) {
  return meanOverYarns(fabric, system, yarnDiameter_mm);
}

std::vector<double> threadDiameters_mm(const Fabric& fabric, System system) {
  std::vector<double> ofYarns;
  for (const Yarn& yarn : fabric.yarns) ofYarns.push_back(yarnDiameter_mm(yarn, meanFibre(yarn, fabric.fibres)));
  std::vector<double> ofThreads;
  for (const int yarn : fabric.sequence(system)) ofThreads.push_back(ofYarns[yarn]);
  return ofThreads;
}

double arealMass_g_m2(const Fabric& fabric, double crimpWarp, double crimpWeft) {
  return 0.1 * (fabric.ends_per_cm * meanCount_tex(fabric, System::warp) * (1.0 + crimpWarp) +
                fabric.picks_per_cm * meanCount_tex(fabric, System::weft) * (1.0 + crimpWeft));
}

double jamming(const Fabric& fabric) {
  const Binding b = binding(fabric.weave);
  const double cells = static_cast<double>(fabric.weave.ends()) * fabric.weave.picks();
  const double d1 = meanDiameter_mm(fabric, System::warp);
  const double d2 = meanDiameter_mm(fabric, System::weft);
  // Peirce: a plain cloth of touching round yarns has sum of sqrt(1 - (p / (d1 + d2))^2) = 1 over both systems.
  const auto term = [&](double pitch, double diameter, int64_t interlacings) {
    if (interlacings == 0) return 0.0;
    const double perInterlacing = cells / static_cast<double>(interlacings);
    const double room = perInterlacing * pitch - (perInterlacing - 1.0) * diameter;
    const double ratio = room / (d1 + d2);
    if (ratio < 0.0) return 1.0 - ratio;  // nor do they fit side by side without the others between them
    return ratio < 1.0 ? std::sqrt(1.0 - ratio * ratio) : 0.0;
  };
  return term(fabric.warpPitch_mm(), d1, b.weftInterlacings) + term(fabric.weftPitch_mm(), d2, b.warpInterlacings);
}

std::vector<std::string> warnings(const Fabric& fabric, const Floats& floats, const LongFloats& tooLong) {
  constexpr double kMostSlub_percent = 70;  // beyond, what lies between two slubs is shorter than the slopes to them
  std::vector<std::string> said;
  if (jamming(fabric) > 1.0)
    said.push_back(
        fmt::format("The sett is jammed: {:.3g} ends and {:.3g} picks per cm are closer than these yarns fit.",
                    fabric.ends_per_cm, fabric.picks_per_cm));
  const int unbound = floats.idleEnds + floats.idlePicks;
  const double longest_mm = std::max(floatLength_mm(fabric, System::warp, floats.warp()),
                                     floatLength_mm(fabric, System::weft, floats.weft()));
  // Ends and picks that nothing binds are counted among them, and told of once more below.
  if (tooLong.count > unbound)
    said.push_back(fmt::format("{} of a repeat {} longer than {:g} mm, {}up to {:.1f} mm: long floats catch.",
                               tooLong.count == 1 ? "1 float" : fmt::format("{} floats", tooLong.count),
                               tooLong.count == 1 ? "is" : "are", tooLong.limit_mm,
                               unbound > 0 ? fmt::format("{} without end, the others ", unbound) : std::string(),
                               longest_mm));
  const auto idle = [&](int count, int all, const char* one, const char* many) {
    if (count > 0)
      said.push_back(fmt::format("{} of {} {} of the repeat never interlace{}: nothing holds {} in the cloth.", count,
                                 all, count == 1 && all == 1 ? one : many, count == 1 ? "s" : "",
                                 count == 1 ? "it" : "them"));
  };
  for (const Yarn& yarn : fabric.yarns) {
    const double slub_percent = 0.1 * yarn.slubs_per_m * yarn.slubLength_mm;
    if (slub_percent <= kMostSlub_percent || isMonofilament(yarn)) continue;
    said.push_back(
        fmt::format("{:g} slubs per m of {:g} mm are {:.0f} % of their yarn: there will be fewer, as more "
                    "than {:g} % find no room.",
                    yarn.slubs_per_m, yarn.slubLength_mm, slub_percent, kMostSlub_percent));
  }
  for (const Yarn& yarn : fabric.yarns) {
    const Fibre fibre = meanFibre(yarn, fabric.fibres);
    const double limit_percent = limitCv_percent(yarn, fibre);
    if (!isSpun(yarn) || yarn.evennessCv_percent == 0 || yarn.evennessCv_percent >= limit_percent) continue;
    std::string tooEven = fmt::format(
        "A CVm of {:g} % is more even than a spun yarn of {:.1f} tex can be: its {:.0f} fibres, laid at random, have "
        "{:.1f} %.",
        yarn.evennessCv_percent, yarnCount_tex(yarn, fibre), fibresInYarn(yarn, fibre), limit_percent);
    if (std::ranges::find(said, tooEven) == said.end()) said.push_back(std::move(tooEven));  // once for yarns alike
  }
  idle(floats.idleEnds, fabric.weave.ends(), "end", "ends");
  idle(floats.idlePicks, fabric.weave.picks(), "pick", "picks");
  return said;
}

}  // namespace loomlight
