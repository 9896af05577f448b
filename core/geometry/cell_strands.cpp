#include "core/geometry/cell_strands.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/geometry/stations.h"

namespace loomlight {
namespace {

/// Takes polylines and keeps what of them lies in the cell, |s| <= edge.
class StrandClipper {
 public:
  StrandClipper(CellStrands& out, float edge) : out_(out), edge_(edge) {}

  /// Points [innerBegin, innerEnd) are known to be inside.
  void add(std::span<const glm::vec3> line, size_t innerBegin, size_t innerEnd, uint8_t ply, float packing) {
    attributes_ = {0, 0, ply, 0, packing};
    size_t i = 0;
    while (i + 1 < line.size()) {
      if (i >= innerBegin && i + 1 < innerEnd) {
        if (!open_) begin(line[i]);
        out_.points.insert(out_.points.end(), line.begin() + static_cast<ptrdiff_t>(i + 1),
                           line.begin() + static_cast<ptrdiff_t>(innerEnd));
        i = innerEnd - 1;
      } else {
        segment(line[i], line[i + 1]);
        ++i;
      }
    }
    end();
  }

 private:
  void segment(glm::vec3 a, glm::vec3 b) {
    const float da = a.y, ds = b.y - a.y;
    float enter = 0, leave = 1;
    if (std::max(a.y, b.y) > edge_ || std::min(a.y, b.y) < -edge_) {
      if (ds == 0) return end();
      const float low = (-edge_ - da) / ds, high = (edge_ - da) / ds;
      enter = std::max(enter, std::min(low, high));
      leave = std::min(leave, std::max(low, high));
      if (!(leave - enter > 1e-6f)) return end();
    }
    if (enter > 0 || !open_) {
      end();
      begin(enter > 0 ? onEdge(a, b, enter) : a);
    }
    out_.points.push_back(leave < 1 ? onEdge(a, b, leave) : b);
    if (leave < 1) end();
  }
  /// The point at which a segment meets the nearer edge, exactly on it.
  glm::vec3 onEdge(glm::vec3 a, glm::vec3 b, float x) const {
    glm::vec3 p = a + x * (b - a);
    p.y = std::copysign(edge_, p.y);
    return p;
  }
  void begin(glm::vec3 p) {
    attributes_.first = static_cast<uint32_t>(out_.points.size());
    out_.points.push_back(p);
    open_ = true;
  }
  void end() {
    if (!open_) return;
    attributes_.count = static_cast<uint32_t>(out_.points.size()) - attributes_.first;
    out_.strands.push_back(attributes_);
    open_ = false;
  }

  CellStrands& out_;
  float edge_;
  CellStrands::Strand attributes_;
  bool open_ = false;
};

/// Range of the stations whose body fibres are all inside the cell.
std::pair<size_t, size_t> innerStations(const std::vector<Station>& stations, float edge) {
  size_t first = 0, end = stations.size();
  while (first < end && stations[first].s_mm - stations[first].spill_mm < -edge) ++first;
  while (end > first && stations[end - 1].s_mm + stations[end - 1].spill_mm > edge) --end;
  return {first, end};
}

void layBody(const YarnModel& yarn, const std::vector<Station>& stations, float edge, StrandClipper& clipper) {
  const YarnGeometry& g = yarn.geometry;
  const size_t n = stations.size();
  const auto [innerBegin, innerEnd] = innerStations(stations, edge);
  const float acrossScale = static_cast<float>(yarn.acrossScale()), upScale = static_cast<float>(yarn.upScale());
  const float orbit = static_cast<float>(g.plyOrbit_mm), packing = static_cast<float>(g.packing);
  // Migration: the radius goes between 1 and 1 - migration times its own (Zhao's R_min = 1 - migration).
  const float wanderMean = static_cast<float>(1 - 0.5 * g.migration),
              wanderSwing = static_cast<float>(0.5 * g.migration);

  std::vector<glm::vec2> plyCentre(n);  // (up, across)
  std::vector<glm::vec3> line(n);
  for (int ply = 0; ply < g.plies; ++ply) {
    const float plyCos = std::cos(2 * static_cast<float>(kPi) * ply / g.plies);
    const float plySin = std::sin(2 * static_cast<float>(kPi) * ply / g.plies);
    for (size_t i = 0; i < n; ++i) {
      const Station& x = stations[i];
      plyCentre[i] =
          orbit * glm::vec2(x.orbitCos * plyCos - x.orbitSin * plySin, x.orbitSin * plyCos + x.orbitCos * plySin);
    }
    for (int k = 0; k < g.fibresPerPly; ++k) {
      const YarnModel::Fibre fibre = yarn.fibres[static_cast<size_t>(ply) * g.fibresPerPly + k];
      for (size_t i = 0; i < n; ++i) {
        const Station& x = stations[i];
        const float wander = wanderMean + wanderSwing * (x.wanderCos * fibre.wanderCos - x.wanderSin * fibre.wanderSin);
        // Positive turns go from up (z) towards u: right-handed about s, so Z twist.
        const float up = upScale * (plyCentre[i].x + wander * (fibre.up * x.spinCos - fibre.across * x.spinSin));
        const float across =
            acrossScale * (plyCentre[i].y + wander * (fibre.up * x.spinSin + fibre.across * x.spinCos));
        line[i] = {across, x.s_mm + up * x.normalS, x.z_mm + up * x.normalZ};
      }
      clipper.add(line, innerBegin, innerEnd, static_cast<uint8_t>(ply), packing);
    }
  }
}

/// A loose fibre has its points at the stations too, and at its ends.
void layFlyaway(const YarnModel& yarn, const Flyaway& flyaway, double shift, const std::vector<Station>& stations,
                std::vector<glm::vec3>& line, StrandClipper& clipper) {
  const double bodyUp = yarn.bodyReach_mm * yarn.upScale();
  const auto place = [&](const Station& a, const Station& b, double t) {
    const double x = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
    const auto mix = [x](float from, float to) { return from + x * (static_cast<double>(to) - from); };
    const glm::dvec2 offset = flyawayOffset(flyaway, yarn.geometry, t - shift);
    // Beyond the body hairs stand straight up, or long ones would lean over into cells further along the yarn.
    const double up = std::clamp(offset.y, -bodyUp, bodyUp);
    line.push_back(glm::vec3(offset.x, mix(a.s_mm, b.s_mm) + up * mix(a.normalS, b.normalS),
                             mix(a.z_mm, b.z_mm) + up * mix(a.normalZ, b.normalZ) + (offset.y - up)));
  };
  const double start = flyaway.start + shift, end = flyaway.end + shift;
  line.clear();
  for (size_t i = 0; i + 1 < stations.size(); ++i) {
    const Station &a = stations[i], &b = stations[i + 1];
    if (b.t <= start || a.t >= end) continue;
    if (line.empty()) place(a, b, std::max(start, a.t));
    place(a, b, std::min(end, b.t));
  }
  clipper.add(line, line.size(), line.size(), 0, 0.0f);
}

}  // namespace

double CellStrands::length_mm() const {
  double total = 0;
  for (const Strand& strand : strands) {
    float length = 0;
    for (uint32_t i = strand.first; i + 1 < strand.first + strand.count; ++i)
      length += glm::distance(points[i], points[i + 1]);
    total += length;
  }
  return total;
}

CellStrands layStrands(const YarnModel& yarn, const PathNode& previous, const PathNode& here, const PathNode& next,
                       int phase, double pitch_mm) {
  const std::vector<Station> stations = layStations(yarn, previous, here, next, phase, pitch_mm);
  const float edge = static_cast<float>(0.5 * pitch_mm);
  CellStrands out;
  out.fibreRadius_mm = static_cast<float>(yarn.geometry.fibreRadius_mm);
  out.points.reserve((yarn.fibres.size() + yarn.flyawaysAt[phase].size()) * (stations.size() + 1));
  out.strands.reserve(yarn.fibres.size() + yarn.flyawaysAt[phase].size());
  StrandClipper clipper(out, edge);
  layBody(yarn, stations, edge, clipper);
  std::vector<glm::vec3> line;
  for (const YarnModel::FlyawayUse& use : yarn.flyawaysAt[phase])
    layFlyaway(yarn, yarn.flyaways[use.index], use.shift, stations, line, clipper);
  return out;
}

}  // namespace loomlight
