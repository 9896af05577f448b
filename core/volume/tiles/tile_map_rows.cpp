#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/tiles/phase_counts.h"
#include "core/volume/tiles/shape_table.h"
#include "core/volume/tiles/tile_map.h"

// How a TileMap is read from the weave, and counted.
// How it works. Reading a repeat means to number every cell's shape code, by a table that gives new codes the next
// number. Bands of yarns are read side by side, each with a table of its own that continues a common one; then, one
// band after the other, their new numbers are replaced by common ones. The first band is read alone, since it finds
// most of the shapes. As the bands are joined in order, numbers do not depend on how many threads there are.
//
// A row has the low 16 bits of its numbers, and their high bits only where some number needs them.

namespace loomlight {
namespace {

/// The bricks of more would not fit into memory anyway.
void checkShapes(const ShapeTable& table) {
  constexpr uint32_t kMaxShapes = uint32_t{1} << 20;
  if (table.end() > kMaxShapes)
    throw InputError(
        fmt::format("the cloth has more than {} shapes of yarn cells: expected fewer different yarns, a smaller "
                    "repeat or no crowding",
                    kMaxShapes));
}

/// Numbers the shapes of cells from `along` on. The codes of a few at a time stay in the cache.
void readCells(const ClothGeometry& geometry, System system, int across, const YarnCrossings& crossings, int along,
               std::span<uint32_t> shapes, ShapeTable& table) {
  std::array<ShapeCode, 512> codes;
  for (size_t done = 0; done < shapes.size();) {
    const auto some = std::span(codes).first(std::min(codes.size(), shapes.size() - done));
    geometry.codes().read(system, across, along + static_cast<int>(done), crossings, some);
    for (const ShapeCode code : some) shapes[done++] = table.number(code);
  }
}

}  // namespace

/// Neighbouring yarns, read by one thread, with numbers of its own for the shapes that are new.
struct TileMap::Band {
  Band(const ClothGeometry& geometry, System system, int firstYarn, int endYarn, const ShapeTable& all)
      : first(firstYarn), end(endYarn), table(geometry, system, all) {}
  int first, end;
  ShapeTable table;
  std::vector<std::shared_ptr<Row>> rows;
};

/// All rows, into `rows_`, which has those that are kept. `table` has the shapes there are.
void TileMap::readRows(const ClothGeometry& geometry, const Task& task, const Kept& kept, ShapeTable& table) {
  constexpr int kBand = 32;         // yarns
  constexpr size_t kTogether = 16;  // bands: their tables must not pile up
  const int standing = kept.wholeRows ? kept.yarns : 0;
  if (standing == repeatAcross_ && rows_.size() == static_cast<size_t>(standing)) return;
  table.index();
  std::vector<SharedList<Row>::Pointer> rows = rows_.all();
  rows.resize(static_cast<size_t>(repeatAcross_));
  low_.resize(rows.size());
  if (!high_.empty()) high_.resize(rows.size());
  for (int first = standing; first < repeatAcross_;) {
    std::vector<Band> bands;
    // The first alone: then the others know most of the shapes, and seldom have to be renumbered.
    const size_t together = first == standing ? 1 : kTogether;
    for (; first < repeatAcross_ && bands.size() < together; first += kBand)
      bands.emplace_back(geometry, system_, first, std::min(first + kBand, repeatAcross_), table);
    parallelFor(bands.size(), task.threads, [&](size_t band) { readBand(geometry, task, kept, bands[band]); });
    if (task.stopped()) return;
    // In order, so that the numbers are the same for any number of threads.
    for (Band& band : bands) {
      renumber(band, table);
      for (size_t i = 0; i < band.rows.size(); ++i) {
        const size_t number = static_cast<size_t>(band.first) + i;
        pointTo(number, *band.rows[i]);
        rows[number] = std::move(band.rows[i]);
      }
    }
  }
  rows_ = SharedList<Row>(rows);
  addShapes(table);
}

void TileMap::readBand(const ClothGeometry& geometry, const Task& task, const Kept& kept, Band& band) const {
  const Weave& weave = geometry.weave();
  std::vector<uint8_t> columns;  // with those of the yarns beside the band
  if (system_ == System::warp) columns = weave.columns(band.first - 1, band.end - band.first + 2);
  const auto crossingsOf = [&](int yarn) -> std::span<const uint8_t> {
    if (system_ == System::weft) return weave.row(wrap(yarn, weave.picks()));
    const auto picks = static_cast<size_t>(weave.picks());
    return std::span<const uint8_t>(columns).subspan(static_cast<size_t>(yarn - band.first + 1) * picks, picks);
  };
  std::vector<uint32_t> shapes(static_cast<size_t>(repeatAlong_));
  for (int across = band.first; across < band.end && !task.stopped(); ++across) {
    const YarnCrossings crossings{crossingsOf(across), crossingsOf(across - 1), crossingsOf(across + 1)};
    const auto read = [&](int from, int to) {
      const auto run = std::span(shapes).subspan(from, to - from);
      readCells(geometry, system_, across, crossings, from, run, band.table);
      return run;
    };
    if (across < kept.yarns) {
      const auto row = std::make_shared<Row>(*rows_[across], shapes.size());
      row->set(0, read(0, kept.from));
      row->set(static_cast<size_t>(kept.to), read(kept.to, repeatAlong_));
      band.rows.push_back(row);
    } else {
      band.rows.push_back(std::make_shared<Row>(read(0, repeatAlong_)));
    }
    checkShapes(band.table);
  }
}

/// By the numbers of all shapes, which get those of the band that are new.
void TileMap::renumber(Band& band, ShapeTable& all) {
  const uint32_t first = band.table.first();
  std::vector<uint32_t> numbers;
  bool same = true;
  for (uint32_t shape = first; shape < band.table.end(); ++shape) {
    numbers.push_back(all.number(band.table.code(shape)));
    same &= numbers.back() == shape;
  }
  if (same) return;
  for (const auto& row : band.rows)
    for (size_t along = 0; along < row->low.size(); ++along)
      if (const uint32_t shape = row->at(along); shape >= first) row->set(along, numbers[shape - first]);
}

TileMap::Row::Row(std::span<const uint32_t> shapes) : low(shapes.begin(), shapes.end()) {
  if (std::all_of(shapes.begin(), shapes.end(), [](uint32_t shape) { return shape >> 16 == 0; })) return;
  high.reserve(shapes.size());
  for (const uint32_t shape : shapes) high.push_back(static_cast<uint16_t>(shape >> 16));
}

TileMap::Row::Row(const Row& other, size_t size) {
  const auto copied = [size](const std::vector<uint16_t>& bits) {
    std::vector<uint16_t> copy;
    copy.reserve(size);
    copy.assign(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(std::min(size, bits.size())));
    copy.resize(size);
    return copy;
  };
  low = copied(other.low);
  if (!other.high.empty()) high = copied(other.high);
}

void TileMap::Row::set(size_t from, std::span<const uint32_t> shapes) {
  for (const uint32_t shape : shapes) set(from++, shape);
}

void TileMap::Row::set(size_t i, uint32_t shape) {
  low[i] = static_cast<uint16_t>(shape);
  if (shape >> 16 != 0) high.resize(low.size());
  if (!high.empty()) high[i] = static_cast<uint16_t>(shape >> 16);
}

/// The traversal goes straight to the numbers.
void TileMap::pointTo(size_t number, const Row& row) {
  low_[number] = row.low.data();
  if (!row.high.empty()) high_.resize(low_.size());
  if (!high_.empty()) high_[number] = row.high.empty() ? nullptr : row.high.data();
}

void TileMap::addShapes(const ShapeTable& table) {
  checkShapes(table);
  for (auto shape = static_cast<uint32_t>(shapes_.size()); shape < table.end(); ++shape) {
    shapes_.push_back(table.shape(shape));
    codes_.push_back(table.code(shape));
  }
  cellsOf_.resize(phaseIndex(table.end(), 0));
  bricks_.resize(index({table.end()}));
}

void TileMap::countCells(const Task& task) {
  const int most = task.threads > 0 ? task.threads : hardwareThreads();
  constexpr int kMostWorkers = 8;  // each counts in a table of its own
  const int workers = std::min({most, repeatAcross_, kMostWorkers});
  std::vector<std::vector<uint64_t>> counts(static_cast<size_t>(workers));
  parallelFor(counts.size(), task.threads, [&](size_t worker) {
    counts[worker].resize(cellsOf_.size());
    for (int row = static_cast<int>(worker); row < repeatAcross_ && !task.stopped(); row += workers)
      PhaseCounts(*this, row).addAll(counts[worker]);
  });
  cellsOf_ = std::move(counts[0]);
  for (size_t i = 1; i < counts.size(); ++i)
    std::transform(cellsOf_.begin(), cellsOf_.end(), counts[i].begin(), cellsOf_.begin(), std::plus<>());
}

}  // namespace loomlight
