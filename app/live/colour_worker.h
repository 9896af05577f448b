#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "render/transport/colour_solver.h"

namespace loomlight {

/// Which colour the cloth shows where a fibre lies on top, or all of its face; and, where one is wanted, how to dye
/// that fibre, or the whole piece, for it. At most one of the two is wanted.
struct ColourWish {
  std::shared_ptr<const Fabric> fabric;
  int fibre = 0;                     ///< or kAnyMaterial: the piece, all of whose fibres are dyed alike
  std::optional<Rgb> wanted;         ///< linear, 1 is white paper
  std::optional<Spectrum> measured;  ///< a reflectance in bands, 1 is a perfect diffuser
  uint64_t number = 0;               ///< the asker's, to know the answer by
};

struct ColourAnswer {
  ColourWish wish;
  bool seen = false;  ///< it lies on top somewhere
  Rgb colour{0};      ///< that the cloth shows now
  std::optional<SolvedColour> solved;
  std::optional<SolvedReflectance> matched;
};

/// Answers the newest wish on a thread of its own, at low priority: light is walked through the cloth once for each
/// construction; every further colour takes a moment. No call here waits.
class ColourWorker {
 public:
  explicit ColourWorker(std::function<void()> wake);

  void request(ColourWish wish) { worker_.ask(std::move(wish)); }
  std::shared_ptr<const ColourAnswer> newest() const;  ///< null before the first
  std::string error() const;                           ///< why the newest wish has no answer

 private:
  struct Result {
    std::shared_ptr<const ColourAnswer> answer;  ///< the last that was found
    std::string error;
  };
  using Answering = Worker<ColourWish, Result>;
  std::optional<Result> answer(ColourWish wish, Answering::Turn& turn);
  bool makeWalks(ColourWish& wish, Answering::Turn& turn);

  // The thread's own:
  std::shared_ptr<const ColourAnswer> last_;
  std::shared_ptr<const Fabric> walked_;  ///< through whose cloth walks_ are
  int walkedFibre_ = 0;
  PathLengthTally walks_;

  Answering worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
