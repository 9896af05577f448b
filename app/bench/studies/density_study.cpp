#include "app/bench/studies/density_study.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/bench/studies/report_page.h"
#include "core/volume/traverse/cloth_volume.h"

namespace loomlight {
namespace {

constexpr int kFine = 4;              // fine cubes along the side of a voxel
constexpr int kPiece = 5, kCell = 2;  // crossings of the piece on a side, and the one in its middle
constexpr int kRim = 1;               // voxels: the largest sphere reaches half of one beyond its voxel

struct Polyline {
  std::vector<glm::dvec3> points;
  double radius_mm = 0;  ///< of the fibre
};

/// Values on a grid of boxes.
struct Grid {
  glm::ivec3 size{0};
  std::vector<double> values;

  explicit Grid(glm::ivec3 cells) : size(cells), values(static_cast<size_t>(cells.x) * cells.y * cells.z) {}
  bool holds(glm::ivec3 c) const {
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, size));
  }
  size_t index(glm::ivec3 c) const {
    return (static_cast<size_t>(c.z) * static_cast<size_t>(size.y) + static_cast<size_t>(c.y)) *
               static_cast<size_t>(size.x) +
           static_cast<size_t>(c.x);
  }
  double& at(glm::ivec3 c) { return values[index(c)]; }
  double at(glm::ivec3 c) const { return values[index(c)]; }
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) visit(glm::ivec3(x, y, z));
  }
};

/// The voxels that are looked at: of one crossing, but for its rim.
struct Region {
  glm::dvec3 lower_mm{0}, voxel_mm{1};
  glm::ivec3 voxels{1};

  glm::dvec3 centre_mm(glm::ivec3 voxel) const { return lower_mm + (glm::dvec3(voxel) + 0.5) * voxel_mm; }
};

Region regionOf(const ClothVolume& volume) {
  const ClothGeometry& geometry = volume.geometry();
  const VoxelGrid& grid = volume.grid();
  Region region;
  region.voxel_mm = glm::dvec3(geometry.warpPitch_mm(), geometry.weftPitch_mm(), 0) / glm::dvec3(grid.cell);
  region.voxel_mm.z = grid.size_mm.z;
  region.voxels = grid.cell - glm::ivec3(2 * kRim, 2 * kRim, 0);
  region.lower_mm = {kCell * geometry.warpPitch_mm() + kRim * region.voxel_mm.x,
                     kCell * geometry.weftPitch_mm() + kRim * region.voxel_mm.y, grid.zLower_mm};
  return region;
}

/// Every fibre that may come near the region, in cloth coordinates. Away from the rim a fibre is one strand.
std::vector<Polyline> fibresAround(const ClothGeometry& geometry) {
  std::vector<Polyline> fibres;
  for (const System system : {System::warp, System::weft})
    for (int across = kCell - 1; across <= kCell + 1; ++across) {
      const bool warp = system == System::warp;
      const int end = warp ? across : kCell, pick = warp ? kCell : across;
      const glm::dvec3 middle((end + 0.5) * geometry.warpPitch_mm(), (pick + 0.5) * geometry.weftPitch_mm(), 0);
      const CellStrands strands = geometry.strands(geometry.key(system, pick, end));
      for (const CellStrands::Strand& strand : strands.strands) {
        Polyline& fibre = fibres.emplace_back();
        fibre.radius_mm = strands.fibreRadius_mm;
        for (uint32_t i = strand.first; i < strand.first + strand.count; ++i) {
          const glm::dvec3 p(strands.points[i]);  // (u, s, z)
          fibre.points.push_back(middle + (warp ? p : glm::dvec3(p.y, -p.x, p.z)));
        }
      }
    }
  return fibres;
}

/// Lines along a segment, evenly over the section of its fibre: offsets from its axis.
std::vector<glm::dvec3> linesOver(glm::dvec3 along, double radius_mm) {
  constexpr int kLines = 16;
  constexpr double kGolden = 2.399963229728653;  // radians
  const glm::dvec3 tangent = glm::normalize(along);
  const glm::dvec3 u =
      glm::normalize(glm::cross(tangent, std::abs(tangent.z) < 0.7 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
  const glm::dvec3 v = glm::cross(tangent, u);
  std::vector<glm::dvec3> offsets;
  for (int i = 0; i < kLines; ++i) {
    const double r = radius_mm * std::sqrt((i + 0.5) / kLines), angle = kGolden * i;
    offsets.push_back(r * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return offsets;
}

/// Fibre in every fine cube: its volume over that of its section, per volume, so that it is a length. Each of the lines
/// over a segment is cut at every plane of the grid that it crosses. Apart from the voxeliser on purpose, which is
/// measured by it.
Grid exactDensity(const std::vector<Polyline>& fibres, const Region& region) {
  Grid lengths(region.voxels * kFine);
  const glm::dvec3 cube_mm = region.voxel_mm / static_cast<double>(kFine);
  std::vector<double> cuts;
  for (const auto& [points, radius_mm] : fibres)
    for (size_t i = 1; i < points.size(); ++i) {
      const std::vector<glm::dvec3> lines = linesOver(points[i] - points[i - 1], radius_mm);
      const double length_mm = glm::distance(points[i - 1], points[i]) / static_cast<double>(lines.size());
      for (const glm::dvec3& line : lines) {
        const glm::dvec3 a = (points[i - 1] + line - region.lower_mm) / cube_mm;
        const glm::dvec3 b = (points[i] + line - region.lower_mm) / cube_mm;
        cuts = {0, 1};
        for (int axis = 0; axis < 3; ++axis)
          for (double plane = std::ceil(std::min(a[axis], b[axis])); plane < std::max(a[axis], b[axis]); ++plane)
            cuts.push_back((plane - a[axis]) / (b[axis] - a[axis]));
        std::sort(cuts.begin(), cuts.end());
        for (size_t k = 1; k < cuts.size(); ++k) {
          const glm::ivec3 cube(glm::floor(glm::mix(a, b, 0.5 * (cuts[k - 1] + cuts[k]))));
          if (lengths.holds(cube)) lengths.at(cube) += (cuts[k] - cuts[k - 1]) * length_mm;
        }
      }
    }
  for (double& value : lengths.values) value /= cube_mm.x * cube_mm.y * cube_mm.z;
  return lengths;
}

/// Means of the fine cubes of every voxel.
Grid coarsened(const Grid& fine) {
  Grid coarse(fine.size / kFine);
  fine.forEach([&](glm::ivec3 cube) { coarse.at(cube / kFine) += fine.at(cube) / (kFine * kFine * kFine); });
  return coarse;
}

/// What the product's volume says.
Grid ourDensity(const ClothVolume& volume, const Region& region) {
  Grid density(region.voxels);
  density.forEach([&](glm::ivec3 voxel) {
    VoxelContent content;
    volume.contentAt(glm::vec3(region.centre_mm(voxel)), content);
    for (int i = 0; i < content.count; ++i)
      for (const Component& component : content.spans[i].components)
        density.at(voxel) += static_cast<double>(component.lengthDensity());
  });
  return density;
}

double distance2(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 way = b - a;
  const double t = std::clamp(glm::dot(p - a, way) / std::max(glm::dot(way, way), 1e-30), 0.0, 1.0);
  const glm::dvec3 off = p - (a + t * way);
  return glm::dot(off, off);
}

Grid countedDensity(const std::vector<Polyline>& fibres, const Region& region, double radius_mm) {
  Grid counts(region.voxels);
  std::vector<size_t> lastFibre(counts.values.size(), 0);  // one that cuts a sphere twice is one fibre
  for (size_t f = 0; f < fibres.size(); ++f)
    for (size_t i = 1; i < fibres[f].points.size(); ++i) {
      const glm::dvec3 a = fibres[f].points[i - 1], b = fibres[f].points[i];
      const glm::ivec3 first(glm::floor((glm::min(a, b) - radius_mm - region.lower_mm) / region.voxel_mm));
      const glm::ivec3 last(glm::floor((glm::max(a, b) + radius_mm - region.lower_mm) / region.voxel_mm));
      const glm::ivec3 from = glm::max(first, glm::ivec3(0)), to = glm::min(last, region.voxels - 1);
      for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
          for (int x = from.x; x <= to.x; ++x) {
            const size_t voxel = counts.index({x, y, z});
            if (lastFibre[voxel] == f + 1 || distance2(region.centre_mm({x, y, z}), a, b) >= radius_mm * radius_mm)
              continue;
            lastFibre[voxel] = f + 1;
            counts.values[voxel] += 1;
          }
    }
  for (double& value : counts.values) value /= kPi * radius_mm * radius_mm;
  return counts;
}

DensityError errorOf(const std::string& method, const Grid& found, const Grid& exact, const Grid& fine) {
  double total = 0, exactTotal = 0, astray = 0, squares = 0, exactSquares = 0, fineSquares = 0, fineExact = 0;
  exact.forEach([&](glm::ivec3 voxel) {
    const double f = found.at(voxel), e = exact.at(voxel);
    total += f;
    exactTotal += e;
    if (e == 0) astray += f;
    squares += (f - e) * (f - e);
    exactSquares += e * e;
  });
  fine.forEach([&](glm::ivec3 cube) {
    const double f = found.at(cube / kFine), e = fine.at(cube);
    fineSquares += (f - e) * (f - e);
    fineExact += e * e;
  });
  return {method, 100 * (total / exactTotal - 1), 100 * std::sqrt(squares / exactSquares),
          100 * std::sqrt(fineSquares / fineExact), 100 * astray / total};
}

/// Where a section across the warp, one voxel thick, is laid.
int middlePick(const Region& region) {
  return region.voxels.y / 2;
}

/// Of the fine cubes, those in one slice of the section: along y over the voxel.
double sliceOf(const Grid& fine, int x, int pick, int z) {
  double sum = 0;
  for (int y = 0; y < kFine; ++y) sum += fine.at({x, pick * kFine + y, z});
  return sum / kFine;
}

std::vector<DensityStudy::Sample> lineThrough(const Grid& fine, const Grid& ours, const Grid& counted,
                                              const Region& region) {
  const int pick = middlePick(region);
  // The layer of voxels with most fibres: the middle of the warp yarn, or near it.
  int layer = 0;
  double most = 0;
  for (int z = 0; z < ours.size.z; ++z) {
    double sum = 0;
    for (int x = 0; x < ours.size.x; ++x) sum += ours.at({x, pick, z});
    if (sum > most) {
      most = sum;
      layer = z;
    }
  }
  std::vector<DensityStudy::Sample> line;
  for (int x = 0; x < fine.size.x; ++x) {
    double exact = 0;
    for (int z = 0; z < kFine; ++z) exact += sliceOf(fine, x, pick, layer * kFine + z) / kFine;
    const glm::ivec3 voxel(x / kFine, pick, layer);
    line.push_back({(x + 0.5) / kFine * region.voxel_mm.x * 1e3, exact, ours.at(voxel), counted.at(voxel)});
  }
  return line;
}

template <class Density>
Pixels8 panel(glm::ivec3 fineSize, double black, Density&& density) {
  Pixels8 picture{fineSize.x, fineSize.z, 3, {}};
  for (int z = fineSize.z - 1; z >= 0; --z)
    for (int x = 0; x < fineSize.x; ++x) {
      const double value = std::clamp(density(x, z) / black, 0.0, 1.0);
      picture.bytes.insert(picture.bytes.end(), 3, static_cast<uint8_t>(std::lround(255 * (1 - value))));
    }
  return magnified(picture, 5);
}

Pixels8 sectionOf(const Grid& fine, const Grid& ours, const Grid& counted, const Region& region) {
  const int pick = middlePick(region);
  const double black = 1.25 * *std::max_element(ours.values.begin(), ours.values.end());
  const auto voxels = [&](const Grid& grid) {
    return panel(fine.size, black, [&](int x, int z) { return grid.at({x / kFine, pick, z / kFine}); });
  };
  return sideBySide({panel(fine.size, black, [&](int x, int z) { return sliceOf(fine, x, pick, z); }), voxels(ours),
                     voxels(counted)});
}

}  // namespace

std::optional<DensityStudy> studyDensity(const Fabric& fabric, int resolution, const Task& task) {
  const auto geometry = std::make_shared<const ClothGeometry>(fabric, kPiece, kPiece);
  const auto volume = ClothVolume::build(geometry, resolution, task);
  if (!volume) return std::nullopt;
  const Region region = regionOf(*volume);
  const std::vector<Polyline> fibres = fibresAround(*geometry);
  const Grid fine = exactDensity(fibres, region), exact = coarsened(fine), ours = ourDensity(*volume, region);
  const double side_mm = std::cbrt(region.voxel_mm.x * region.voxel_mm.y * region.voxel_mm.z);
  const Grid counted = countedDensity(fibres, region, std::sqrt(0.75) * side_mm);
  DensityStudy study;
  study.errors = {errorOf("length of fibre (ours)", ours, exact, fine),
                  errorOf("fibres counted in the sphere within the voxel",
                          countedDensity(fibres, region, 0.5 * side_mm), exact, fine),
                  errorOf("fibres counted in the sphere about the voxel", counted, exact, fine),
                  errorOf("fibres counted in a sphere twice as wide as the voxel",
                          countedDensity(fibres, region, side_mm), exact, fine)};
  study.line = lineThrough(fine, ours, counted, region);
  study.section = sectionOf(fine, ours, counted, region);
  return study;
}

}  // namespace loomlight
