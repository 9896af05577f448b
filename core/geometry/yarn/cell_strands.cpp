#include "core/geometry/yarn/cell_strands.h"

#include <algorithm>
#include <cmath>
#include <span>

// How it works. All fibres of a cell have their points at the same stations along the yarn (stations.cpp), which know
// the angles of ply, cord and yarn there. In the round section a fibre turns about its ply (where it has migrated to),
// that about its cord, and that about the yarn; plies and cords give way to one another (ply_shape.h). That place is
// scaled across and up, as the yarn is pressed there, and set into the plane normal to the yarn's path. The
// polylines reach beyond the cell, since its ends cut slanted sections: StrandClipper cuts them there, with the new
// ends exactly on the edge, so that the next cell of the yarn goes on from the very same points.

namespace loomlight {
namespace {

/// Takes polylines and keeps what of them lies in the cell, |s| <= edge.
class StrandClipper {
 public:
  StrandClipper(CellStrands& out, float edge) : out_(out), edge_(edge) {}

  void add(std::span<const glm::vec3> line, uint8_t ply, bool loose) {
    attributes_ = {0, 0, ply, loose};
    // Most often a fibre comes in once and leaves once.
    size_t first = 0, end = line.size();
    while (first < end && line[first].y < -edge_) ++first;
    while (end > first && line[end - 1].y > edge_) --end;
    if (end - first >= 2 && allInside(line.subspan(first, end - first))) {
      if (first > 0) segment(line[first - 1], line[first]);
      if (!open_) begin(line[first]);
      out_.points.insert(out_.points.end(), line.begin() + static_cast<ptrdiff_t>(first + 1),
                         line.begin() + static_cast<ptrdiff_t>(end));
      if (end < line.size()) segment(line[end - 1], line[end]);
    } else {
      for (size_t i = 0; i + 1 < line.size(); ++i) segment(line[i], line[i + 1]);
    }
    finish();
  }

 private:
  bool allInside(std::span<const glm::vec3> line) const {
    bool inside = true;
    for (const glm::vec3& p : line) inside &= std::abs(p.y) <= edge_;
    return inside;
  }
  void segment(glm::vec3 a, glm::vec3 b) {
    const float da = a.y, ds = b.y - a.y;
    float enter = 0, leave = 1;
    if (std::max(a.y, b.y) > edge_ || std::min(a.y, b.y) < -edge_) {
      if (ds == 0) return finish();
      const float low = (-edge_ - da) / ds, high = (edge_ - da) / ds;
      enter = std::max(enter, std::min(low, high));
      leave = std::min(leave, std::max(low, high));
      if (!(leave - enter > 1e-6f)) return finish();
    }
    if (enter > 0 || !open_) {
      finish();
      begin(enter > 0 ? onEdge(a, b, enter) : a);
    }
    out_.points.push_back(leave < 1 ? onEdge(a, b, leave) : b);
    if (leave < 1) finish();
  }
  /// The point at which a segment meets the nearer edge, exactly on it.
  glm::vec3 onEdge(glm::vec3 a, glm::vec3 b, float x) const {
    glm::vec3 p = a + x * (b - a);
    p.y = std::copysign(edge_, p.y);
    return p;
  }
  /// A strand whose last piece was too short to keep ends on the edge all the same, so that it goes on beyond.
  glm::vec3 snapped(glm::vec3 p) const {
    if (std::abs(std::abs(p.y) - edge_) < 4e-6f * edge_) p.y = std::copysign(edge_, p.y);
    return p;
  }
  void begin(glm::vec3 p) {
    attributes_.first = static_cast<uint32_t>(out_.points.size());
    out_.points.push_back(snapped(p));
    open_ = true;
  }
  void finish() {
    if (!open_) return;
    out_.points.back() = snapped(out_.points.back());
    attributes_.count = static_cast<uint32_t>(out_.points.size()) - attributes_.first;
    out_.strands.push_back(attributes_);
    open_ = false;
  }

  CellStrands& out_;
  float edge_;
  CellStrands::Strand attributes_;
  bool open_ = false;
};

/// Numbers of the stations, list by list: what is computed for every fibre goes through them eight at a time.
struct StationLists {
  std::vector<float> s, z, aside, normalS, normalZ, upScale, acrossScale;
  explicit StationLists(const std::vector<Station>& stations) {
    for (const Station& x : stations) {
      s.push_back(x.s_mm);
      z.push_back(x.z_mm);
      aside.push_back(x.aside_mm);
      normalS.push_back(x.normalS);
      normalZ.push_back(x.normalZ);
      upScale.push_back(x.up);
      acrossScale.push_back(x.across);
    }
  }
};

void layBody(const YarnModel& yarn, const std::vector<Station>& stations, StrandClipper& clipper) {
  const YarnGeometry& g = yarn.geometry;
  const size_t n = stations.size();
  const StationLists at(stations);
  const PlyShape plyShape = g.plyShape(), cordShape = g.cordShape();

  std::vector<glm::vec2> inPly(n), inCord(n), inYarn(n);  // directions of the fibre, its ply and its cord
  std::vector<glm::vec2> place(n);                        // up, across
  std::vector<glm::vec3> line(n);
  for (int single = 0; single < g.singles(); ++single) {
    const glm::vec2 cord = directionOf(single / g.plies, g.cords), ply = directionOf(single % g.plies, g.plies);
    for (size_t i = 0; i < n; ++i) {
      inPly[i] = turned(backwards(ply), stations[i].plyTurn);
      inCord[i] = turned(ply, stations[i].yarnTurn);
      inYarn[i] = turned(cord, stations[i].cableTurn);
    }
    const Migration& fibres = yarn.plies[static_cast<size_t>(single % g.plies)];
    for (int fibre = 0; fibre < fibres.fibres(); ++fibre) {
      for (size_t i = 0; i < n; ++i)
        place[i] = fibres.moves() ? fibres.place(fibre, stations[i].migration) : fibres.place(fibre);
      for (size_t i = 0; i < n; ++i) place[i] = turned(inPly[i], place[i]);
      if (g.plies > 1)
        for (size_t i = 0; i < n; ++i) place[i] = turned(inCord[i], plyShape.place(place[i]));
      if (g.cords > 1)
        for (size_t i = 0; i < n; ++i) place[i] = turned(inYarn[i], cordShape.place(place[i]));
      for (size_t i = 0; i < n; ++i) {
        const float up = at.upScale[i] * place[i].x, across = at.acrossScale[i] * place[i].y;
        line[i] = {at.aside[i] + across, at.s[i] + up * at.normalS[i], at.z[i] + up * at.normalZ[i]};
      }
      clipper.add(line, static_cast<uint8_t>(single), false);
    }
  }
}

constexpr double kWrapStep = 0.5;  // radians: chords stay within 3 % of the radius

/// A loose fibre has its points at the stations too, and at its ends.
void layFlyaway(const YarnModel& yarn, const Flyaway& flyaway, double shift, const std::vector<Station>& stations,
                std::vector<glm::vec3>& line, StrandClipper& clipper) {
  const auto place = [&](const Station& a, const Station& b, double t) {
    const double x = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
    const auto mix = [x](float from, float to) { return from + x * (static_cast<double>(to) - from); };
    const AxisPosition axis{mix(a.z_mm, b.z_mm),
                            mix(a.crown_mm, b.crown_mm),
                            mix(a.lift_mm, b.lift_mm),
                            {mix(a.up, b.up), mix(a.across, b.across)},
                            mix(a.aside_mm, b.aside_mm)};
    const double bodyUp = yarn.bodyReach_mm * axis.section.up;
    const glm::dvec2 offset = flyawayOffset(flyaway, yarn.geometry, t - shift, axis);
    // Beyond the body hairs stand straight up, or long ones would lean over into cells further along the yarn.
    const double up = std::clamp(offset.y, -bodyUp, bodyUp);
    line.push_back(glm::vec3(offset.x, mix(a.s_mm, b.s_mm) + up * mix(a.normalS, b.normalS),
                             axis.here_mm + up * mix(a.normalZ, b.normalZ) + (offset.y - up)));
  };
  const double start = flyaway.start + shift, end = flyaway.end + shift;
  line.clear();
  for (size_t i = 0; i + 1 < stations.size(); ++i) {
    const Station &a = stations[i], &b = stations[i + 1];
    if (b.t <= start || a.t >= end) continue;
    const double from = std::max(start, a.t), to = std::min(end, b.t);
    if (line.empty()) place(a, b, from);
    // Wrapper fibres go around between stations.
    const double turned = std::abs(flyaway.angleSpan) * (to - from) / (end - start);
    const int steps = 1 + static_cast<int>(turned / kWrapStep);
    for (int k = 1; k < steps; ++k) place(a, b, from + (to - from) * k / steps);
    place(a, b, to);
  }
  clipper.add(line, 0, true);
}

}  // namespace

double CellStrands::length_mm() const {
  // In two steps, of which the first has nothing that one segment must wait for another.
  std::vector<float> lengths;
  double total = 0;
  for (const Strand& strand : strands) {
    lengths.resize(strand.count - 1);
    const glm::vec3* const p = points.data() + strand.first;
    for (size_t i = 0; i < lengths.size(); ++i) {
      const glm::vec3 d = p[i + 1] - p[i];
      lengths[i] = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    }
    for (const float length : lengths) total += length;
  }
  return total;
}

CellStrands layStrands(const YarnModel& yarn, const PathNode& previous, const PathNode& here, const PathNode& next,
                       const CellOfYarn& cell, double pitch_mm) {
  const std::vector<Station> stations = layStations(yarn, previous, here, next, cell, pitch_mm);
  const std::vector<YarnModel::FlyawayUse>& flyaways = yarn.flyawaysAt[static_cast<size_t>(cell.phase)];
  const float edge = static_cast<float>(0.5 * pitch_mm);
  CellStrands out;
  out.fibreRadius_mm = static_cast<float>(yarn.geometry.fibreRadius_mm);
  out.points.reserve((yarn.fibreCount() + flyaways.size()) * (stations.size() + 1));
  out.strands.reserve(yarn.fibreCount() + flyaways.size());
  StrandClipper clipper(out, edge);
  layBody(yarn, stations, clipper);
  std::vector<glm::vec3> line;
  for (const YarnModel::FlyawayUse& use : flyaways)
    layFlyaway(yarn, yarn.flyaways[use.index], use.shift, stations, line, clipper);
  return out;
}

}  // namespace loomlight
