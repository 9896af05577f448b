#include "tests/bench/relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/bench/relaxation_contacts.h"

// How it works. Digital elements: each yarn is a bundle of 19 strands, each strand a closed chain of beads (closed over
// the repeat) that cannot be compressed. A step moves the beads as tension and bending want, implicitly, and draws them
// towards the axis of their yarn as a twist under tension does; then contacts push apart what overlaps, and friction
// holds back what slides. All beads are as mobile, so where nothing moves any more all forces balance: those of tension
// and bending per bead, and the equal and opposite ones of contacts. First with the tension of the loom, then with what
// is kept of it; last between plates. The length of step follows from how far it moves the beads.

namespace loomlight {
namespace {

using glm::dvec3;

constexpr int kStrands = 19;
// A strand is fibres and the air between them. Where strands are packed as discs are (0.85) spun yarn has 0.65.
constexpr double kSpunStrand = 0.77, kFilamentStrand = 0.90;
constexpr double kStiffness_cN_mm2 = 0.2, kStiffnessAt_tex = 20;  // cotton: fibres that slide past each other have half
constexpr double kStep = 0.05;                                    // of a bead's radius, at most, for each step

double strandPacking(const RelaxedYarn& yarn) {
  const double filament = std::clamp((yarn.packing - 0.5) / 0.2, 0.0, 1.0);
  return kSpunStrand + filament * (kFilamentStrand - kSpunStrand);
}
double fibreArea_mm2(const RelaxedYarn& yarn) {
  return yarn.count_tex * 1e-3 / yarn.density_g_cm3;
}
double beadRadius_mm(const RelaxedYarn& yarn) {
  return std::sqrt(fibreArea_mm2(yarn) / (strandPacking(yarn) * kStrands * kPi));
}

/// Places of strands in a free yarn, (across, up): a centre and two rings.
std::array<glm::dvec2, kStrands> strandPlaces(double radius_mm, double bead_mm) {
  std::array<glm::dvec2, kStrands> places{};
  for (int i = 1; i < kStrands; ++i) {
    const bool outer = i > 6;
    const double angle = 2 * kPi * (outer ? (i - 7 + 0.25) / 12.0 : (i - 1) / 6.0);
    const double ring = (outer ? 1.0 : 0.5) * std::max(radius_mm - bead_mm, 4.0 * bead_mm);
    places[static_cast<size_t>(i)] = ring * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  return places;
}

/// The yarns of one system: where their beads are among all, and what they are made of.
struct YarnSystem {
  RelaxedYarn yarn;
  int axis = 0;                ///< along x or y
  size_t first = 0;            ///< bead
  int threads = 0, beads = 0;  ///< beads of a strand
  int crossings = 0;           ///< along a thread
  double length_mm = 0;        ///< of the repeat along the yarn
  double stiffness = 0;        ///< of a strand, cN mm2
  std::vector<double> kernel;

  size_t bead(int thread, int strand, int i) const {
    return first + (static_cast<size_t>(thread) * kStrands + static_cast<size_t>(strand)) * static_cast<size_t>(beads) +
           static_cast<size_t>(i);
  }
  double straight(int i) const { return length_mm * i / beads; }
};

class Solver {
 public:
  Solver(const RelaxedCloth& cloth, const Relaxation& how) : cloth_(cloth), how_(how) {
    const double width = cloth.weave.ends() * 10 / cloth.ends_per_cm;
    const double height = cloth.weave.picks() * 10 / cloth.picks_per_cm;
    beads_.period = {width, height};
    lay(0, cloth.warp, 1, cloth.weave.ends(), cloth.weave.picks(), height);
    lay(1, cloth.weft, 0, cloth.weave.picks(), cloth.weave.ends(), width);
  }

  RelaxedMeasures run() {
    run(how_.loomSteps, how_.tension_cN_tex);
    run(4 * how_.washedSteps / 5, how_.keptTension_cN_tex);
    const RelaxedMeasures before = measure();
    run(how_.washedSteps / 5, how_.keptTension_cN_tex);
    RelaxedMeasures after = measure();
    if (how_.plates < 1) {
      const double gap = how_.plates * after.thickness_mm;
      for (int i = 1; i <= 100; ++i) {
        plate_ = 0.5 * (after.thickness_mm + (gap - after.thickness_mm) * i / 100);
        run(2, how_.keptTension_cN_tex);
      }
      after = measure();
    }
    after.drift = std::max(std::abs(after.crimpWarp - before.crimpWarp), std::abs(after.crimpWeft - before.crimpWeft));
    return after;
  }

 private:
  void lay(size_t system, const RelaxedYarn& yarn, int axis, int threads, int crossings, double length_mm) {
    YarnSystem& of = systems_[system];
    const double bead = beadRadius_mm(yarn), pitch = length_mm / crossings;
    const int perPitch = std::max(8, static_cast<int>(std::ceil(1.15 * pitch / bead)));
    of = {yarn, axis, beads_.at.size(), threads, perPitch * crossings, crossings, length_mm, 0, {}};
    of.stiffness = kStiffness_cN_mm2 * std::pow(yarn.count_tex / kStiffnessAt_tex, how_.stiffnessPower) / kStrands;
    const auto places = strandPlaces(freeRadius_mm(yarn), bead);
    const double apart = std::max(freeRadius_mm(cloth_.warp), 2.0 * beadRadius_mm(cloth_.warp) * 2.5) +
                         std::max(freeRadius_mm(cloth_.weft), 2.0 * beadRadius_mm(cloth_.weft) * 2.5);
    const double acrossPitch = beads_.period[static_cast<size_t>(1 - axis)] / threads;
    for (int thread = 0; thread < threads; ++thread)
      for (int strand = 0; strand < kStrands; ++strand)
        for (int i = 0; i < of.beads; ++i) {
          const double along = static_cast<double>(i) / perPitch;
          const int cell = static_cast<int>(along);
          const auto side = [&](int crossing) { return isUp(system, thread, crossing) ? 0.5 * apart : -0.5 * apart; };
          const double onWay = glm::smoothstep(0.0, 1.0, along - cell);
          const double z = side(cell) + onWay * (side(cell + 1) - side(cell));
          const glm::dvec2 place = places[static_cast<size_t>(strand)];
          dvec3 at(0, 0, z + place.y);
          at[axis] = (along + 0.5) * pitch;
          at[1 - axis] = (thread + 0.5) * acrossPitch + place.x;
          beads_.at.push_back(at);
          beads_.radius_mm.push_back(bead);
          beads_.strand.push_back(static_cast<int>(system) * 100'000 + thread * kStrands + strand);
        }
  }

  bool isUp(size_t system, int thread, int crossing) const {
    const int count = systems_[system].crossings, c = (crossing % count + count) % count;
    return cloth_.weave.warpOver(system == 0 ? c : thread, system == 0 ? thread : c) == (system == 0);
  }

  void run(int steps, double tension_cN_tex) {
    Contacts contacts(beads_, how_.friction);
    for (int step = 0; step < steps; ++step) {
      before_ = beads_.at;
      if (step % 10 == 0) {
        findKernels(tension_cN_tex);
        contacts.find();
      }
      double farthest = 0;
      for (YarnSystem& of : systems_) farthest = std::max(farthest, bend(of, tension_cN_tex));
      const double wanted = kStep * std::min(beadRadius_mm(cloth_.warp), beadRadius_mm(cloth_.weft));
      time_ *= std::clamp(wanted / std::max(farthest, 1e-12), 0.8, 1.1);
      for (int sweep = 0; sweep < 6; ++sweep) {
        overlap_ = contacts.sweep(before_);
        if (plate_ > 0)
          for (size_t i = 0; i < beads_.at.size(); ++i)
            beads_.at[i].z = std::clamp(beads_.at[i].z, beads_.radius_mm[i] - plate_, plate_ - beads_.radius_mm[i]);
      }
    }
  }

  /// What a bead's move does to its chain's: (1 + time (tension + bending))^-1, which is a convolution on a ring.
  void findKernels(double tension_cN_tex) {
    for (YarnSystem& of : systems_) {
      const double ds = axisLength(of) / of.beads, tension = tension_cN_tex * of.yarn.count_tex / kStrands;
      const auto n = static_cast<size_t>(of.beads);
      std::vector<double> gain(n);
      for (size_t k = 0; k < n; ++k) {
        const double wave = (2 - 2 * std::cos(2 * kPi * static_cast<double>(k) / of.beads)) / (ds * ds);
        // An elastica whose length is free pushes, by 3/2 of its curvature squared.
        const double push = 1.5 * of.stiffness * meanCurvature2(of, ds);
        gain[k] = 1 / (1 + time_ * ds * wave * std::max(0.0, tension + of.stiffness * wave - push));
      }
      of.kernel.assign(n, 0);
      for (size_t j = 0; j < n; ++j)
        for (size_t k = 0; k < n; ++k)
          of.kernel[j] += gain[k] * std::cos(2 * kPi * static_cast<double>(j * k % n) / of.beads) / of.beads;
    }
  }

  /// Tension, bending and twist of one system for one step. How far the furthest bead went.
  double bend(YarnSystem& of, double tension_cN_tex) {
    const auto n = static_cast<size_t>(of.beads);
    std::vector<dvec3> off(2 * n), axis(n);
    const double ds = axisLength(of) / of.beads;
    const double turn = 2 * kPi * of.yarn.twist_per_m * 1e-3;
    const double tension = std::max(tension_cN_tex, 0.1 * how_.tension_cN_tex) * of.yarn.count_tex / kStrands;
    const double drawn = std::min(0.05, time_ * ds * tension * turn * turn);
    double farthest = 0;
    for (int thread = 0; thread < of.threads; ++thread) {
      for (size_t i = 0; i < n; ++i) axis[i] = axisAt(of, thread, static_cast<int>(i));
      for (int strand = 0; strand < kStrands; ++strand) {
        dvec3* const at = &beads_.at[of.bead(thread, strand, 0)];
        for (size_t i = 0; i < n; ++i) {
          off[i] = at[i];
          off[i][of.axis] -= of.straight(static_cast<int>(i));
          off[i + n] = off[i];
        }
        for (size_t i = 0; i < n; ++i) {
          dvec3 moved(0);
          for (size_t j = 0; j < n; ++j) moved += of.kernel[j] * off[i + j];
          moved += drawn * (axis[i] - at[i]);
          dvec3 step = moved - off[i];
          farthest = std::max(farthest, glm::length(step));
          at[i] += step;
        }
      }
    }
    return farthest;
  }

  dvec3 axisAt(const YarnSystem& of, int thread, int i) const {
    dvec3 mean(0);
    for (int strand = 0; strand < kStrands; ++strand) mean += beads_.at[of.bead(thread, strand, i)] / double(kStrands);
    return mean;
  }
  dvec3 nextAxis(const YarnSystem& of, int thread, int i) const {
    dvec3 at = axisAt(of, thread, (i + 1) % of.beads);
    if (i + 1 == of.beads) at[of.axis] += of.length_mm;
    return at;
  }
  double axisLength(const YarnSystem& of) const {
    double length = 0;
    for (int thread = 0; thread < of.threads; ++thread)
      for (int i = 0; i < of.beads; ++i) length += glm::distance(axisAt(of, thread, i), nextAxis(of, thread, i));
    return length / of.threads;
  }
  double meanCurvature2(const YarnSystem& of, double ds) const {
    double sum = 0;
    for (int thread = 0; thread < of.threads; ++thread)
      for (int i = 0; i + 2 < of.beads; ++i) {
        const dvec3 second = axisAt(of, thread, i) - 2.0 * axisAt(of, thread, i + 1) + axisAt(of, thread, i + 2);
        sum += glm::dot(second, second) / (ds * ds * ds * ds);
      }
    return sum / (of.threads * (of.beads - 2));
  }

  RelaxedMeasures measure() const {
    std::vector<double> tops, bottoms;
    for (size_t i = 0; i < beads_.at.size(); ++i) {
      tops.push_back(beads_.at[i].z + beads_.radius_mm[i]);
      bottoms.push_back(beads_.at[i].z - beads_.radius_mm[i]);
    }
    std::sort(tops.begin(), tops.end());
    std::sort(bottoms.begin(), bottoms.end());
    const size_t hundredth = tops.size() / 100;
    RelaxedMeasures measures;
    measures.crimpWarp = axisLength(systems_[0]) / systems_[0].length_mm - 1;
    measures.crimpWeft = axisLength(systems_[1]) / systems_[1].length_mm - 1;
    measures.thickness_mm = tops[tops.size() - 1 - hundredth] - bottoms[hundredth];
    measures.overlap = overlap_;
    const double middle = 0.5 * (tops[tops.size() - 1 - hundredth] + bottoms[hundredth]);
    for (size_t system = 0; system < 2; ++system) {
      measures.crossings[system] = measureCrossings(system, middle);
      measures.drawnAside_mm[system] = drawnAside_mm(system);
    }
    return measures;
  }
  /// The two yarns that a thread parts there are drawn opposite ways, so that a drift of all of them does not count.
  double drawnAside_mm(size_t system) const {
    const YarnSystem& of = systems_[system];
    const double pitch = beads_.period[static_cast<size_t>(1 - of.axis)] / of.threads;
    double sum = 0;
    int count = 0;
    for (int thread = 0; thread < of.threads; ++thread)
      for (int crossing = 0; crossing < of.crossings; ++crossing) {
        const bool up = isUp(system, thread, crossing);
        const int drawn = (isUp(system, (thread + of.threads - 1) % of.threads, crossing) != up) -
                          (isUp(system, (thread + 1) % of.threads, crossing) != up);
        const double at = axisAt(of, thread, crossing * of.beads / of.crossings)[1 - of.axis];
        sum += drawn * (at - (thread + 0.5) * pitch);
        count += drawn != 0;
      }
    return count > 0 ? sum / count : 0.0;
  }
  std::array<RelaxedCrossings, 3> measureCrossings(size_t system, double middle_mm) const {
    const YarnSystem& of = systems_[system];
    std::array<RelaxedCrossings, 3> all{};
    for (int thread = 0; thread < of.threads; ++thread)
      for (int crossing = 0; crossing < of.crossings; ++crossing) {
        const bool up = isUp(system, thread, crossing);
        const int state = (isUp(system, thread, crossing - 1) == up) + (isUp(system, thread, crossing + 1) == up);
        RelaxedCrossings& mean = all[static_cast<size_t>(state)];
        dvec3 least(1e9), most(-1e9);
        const int i = crossing * of.beads / of.crossings;
        for (int strand = 0; strand < kStrands; ++strand) {
          const dvec3& at = beads_.at[of.bead(thread, strand, i)];
          least = glm::min(least, at);
          most = glm::max(most, at);
        }
        const double bead = beadRadius_mm(of.yarn), height = axisAt(of, thread, i).z - middle_mm;
        mean.count += 1;
        mean.height_mm += up ? height : -height;
        mean.halfUp_mm += 0.5 * (most.z - least.z) + bead;
        mean.halfAcross_mm += 0.5 * (most[1 - of.axis] - least[1 - of.axis]) + bead;
      }
    for (RelaxedCrossings& mean : all) {
      if (mean.count == 0) continue;
      mean.height_mm /= mean.count;
      mean.halfUp_mm /= mean.count;
      mean.halfAcross_mm /= mean.count;
    }
    return all;
  }

  const RelaxedCloth& cloth_;
  const Relaxation& how_;
  std::array<YarnSystem, 2> systems_;
  Beads beads_;
  std::vector<dvec3> before_;
  double time_ = 1e-6, overlap_ = 0, plate_ = 0;
};

}  // namespace

double freeRadius_mm(const RelaxedYarn& yarn) {
  return std::sqrt(fibreArea_mm2(yarn) / (yarn.packing * kPi));
}

RelaxedMeasures relax(const RelaxedCloth& cloth, const Relaxation& how) {
  return Solver(cloth, how).run();
}

}  // namespace loomlight
