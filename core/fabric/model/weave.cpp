#include "core/fabric/model/weave.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "core/base/modulo.h"

namespace loomlight {
namespace {

/// A number of ends or picks that a weave can have.
[[maybe_unused]] bool isSide(size_t n) {
  return n >= 1 && n <= static_cast<size_t>(Weave::kMaxSide);
}

std::vector<Weave::SharedRow> sharedCopies(const std::vector<Weave::Row>& rows) {
  std::vector<Weave::SharedRow> copies;
  copies.reserve(rows.size());
  for (const Weave::Row& row : rows) copies.push_back(std::make_shared<const Weave::Row>(row));
  return copies;
}

}  // namespace

Weave::Weave() : Weave(std::vector<Row>{{1, 0}, {0, 1}}) {}

Weave::Weave(const std::vector<Row>& rows) : Weave(sharedCopies(rows)) {}

Weave::Weave(std::vector<SharedRow> rows) {
  assert(isSide(rows.size()));
  [[maybe_unused]] const auto isAsLong = [&](const SharedRow& row) { return row->size() == rows.front()->size(); };
  assert(isSide(rows.front()->size()) && std::all_of(rows.begin(), rows.end(), isAsLong));
  ends_ = static_cast<int>(rows.front()->size());
  picks_ = static_cast<int>(rows.size());
  const std::shared_ptr<SharedRow[]> kept(new SharedRow[rows.size()]);
  std::move(rows.begin(), rows.end(), kept.get());
  rows_ = kept;
}

bool Weave::warpOver(int pick, int end) const {
  return at(wrap(pick, picks()), wrap(end, ends_));
}

std::vector<uint8_t> Weave::columns(int first, int count) const {
  constexpr size_t kPicks = 64;  // at a time: their cells stay in the cache from end to end
  const auto picks = static_cast<size_t>(picks_);
  std::vector<uint8_t> cells(static_cast<size_t>(count) * picks);
  std::array<const uint8_t*, kPicks> rows{};
  for (size_t from = 0; from < picks; from += kPicks) {
    const size_t n = std::min(kPicks, picks - from);
    for (size_t p = 0; p < n; ++p) rows[p] = rows_[from + p]->data();
    for (int i = 0; i < count; ++i) {
      const int end = wrap(first + i, ends_);
      uint8_t* const column = &cells[static_cast<size_t>(i) * picks + from];
      for (size_t p = 0; p < n; ++p) column[p] = rows[p][end];
    }
  }
  return cells;
}

Weave Weave::with(int pick, int end, bool warpOver) const {
  assert(pick >= 0 && pick < picks() && end >= 0 && end < ends_);
  if (at(pick, end) == warpOver) return *this;
  Row row = *rows_[pick];
  row[end] = warpOver ? 1 : 0;
  std::vector<SharedRow> changed(rows().begin(), rows().end());
  changed[pick] = std::make_shared<const Row>(std::move(row));
  return Weave(std::move(changed));
}

Weave Weave::resized(int ends, int picks) const {
  assert(isSide(static_cast<size_t>(ends)) && isSide(static_cast<size_t>(picks)));
  // Rows are made once for each pick of the old repeat and shared by the picks that continue it.
  std::vector<SharedRow> made(rows().begin(), rows().end());
  if (ends != ends_) {
    for (SharedRow& row : made) {
      Row continued;
      continued.reserve(static_cast<size_t>(ends));
      for (int e = 0; e < ends; e += ends_)
        continued.insert(continued.end(), row->begin(), row->begin() + std::min(ends_, ends - e));
      row = std::make_shared<const Row>(std::move(continued));
    }
  }
  std::vector<SharedRow> rows(static_cast<size_t>(picks));
  for (int p = 0; p < picks; ++p) rows[p] = made[p % this->picks()];
  return Weave(std::move(rows));
}

bool operator==(const Weave& a, const Weave& b) {
  const auto rowsOfA = a.rows(), rowsOfB = b.rows();
  return a.rows_ == b.rows_ ||
         (a.ends_ == b.ends_ && std::equal(rowsOfA.begin(), rowsOfA.end(), rowsOfB.begin(), rowsOfB.end(),
                                           [](const auto& x, const auto& y) { return x == y || *x == *y; }));
}

std::vector<int> pulledShafts(const Draft& draft, size_t pick) {
  std::vector<uint8_t> pulled(static_cast<size_t>(draft.shafts) + 1, 0);
  const auto pull = [&pulled](const std::vector<int>& shafts) {
    for (const int shaft : shafts)
      if (shaft >= 1 && static_cast<size_t>(shaft) < pulled.size()) pulled[shaft] = 1;
  };
  if (!draft.liftplan.empty()) {
    pull(draft.liftplan[pick]);
  } else {
    for (const int treadle : draft.treadling[pick])
      if (treadle >= 1 && static_cast<size_t>(treadle) <= draft.tieUp.size()) pull(draft.tieUp[treadle - 1]);
  }
  std::vector<int> shafts;
  for (int shaft = 1; shaft <= draft.shafts; ++shaft)
    if (pulled[shaft]) shafts.push_back(shaft);
  return shafts;
}

Weave drawdown(const Draft& draft) {
  const size_t picks = draft.liftplan.empty() ? draft.treadling.size() : draft.liftplan.size();
  assert(isSide(picks) && isSide(draft.threading.size()) && draft.shafts >= 0);
  // A liftplan says what is raised, whichever way the loom's treadles would move it.
  const bool rising = draft.risingShed || !draft.liftplan.empty();

  std::vector<std::vector<size_t>> endsOfShaft(static_cast<size_t>(draft.shafts) + 1);
  Weave::Row rest(draft.threading.size(), 0);  // a pick that pulls no shaft: a sinking shed leaves all hung ends up
  for (size_t e = 0; e < draft.threading.size(); ++e)
    for (const int shaft : draft.threading[e])
      if (shaft >= 1 && shaft <= draft.shafts) {
        endsOfShaft[shaft].push_back(e);
        rest[e] = rising ? 0 : 1;
      }

  std::map<std::vector<int>, Weave::SharedRow> rowOfShed;  // a draft has few sheds: picks of the same one share
  std::vector<Weave::SharedRow> rows(picks);
  for (size_t p = 0; p < picks; ++p) {
    const std::vector<int> pulled = pulledShafts(draft, p);
    Weave::SharedRow& row = rowOfShed[pulled];
    if (!row) {
      Weave::Row cells = rest;
      for (const int shaft : pulled)
        for (const size_t end : endsOfShaft[shaft]) cells[end] = rising ? 1 : 0;
      row = std::make_shared<const Weave::Row>(std::move(cells));
    }
    rows[p] = row;
  }
  return Weave(std::move(rows));
}

}  // namespace loomlight
