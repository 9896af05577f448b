#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/live/worker.h"
#include "render/colour/colour_difference.h"
#include "render/transport/colour_solver.h"

namespace loomlight {

/// Which colour the cloth shows where a part of it lies on top; and, where one is wanted, how to dye that part for it.
/// At most one of the two is wanted.
struct ColourWish {
  std::shared_ptr<const Fabric> fabric;
  ClothPart part;                    ///< that the fabric has
  std::optional<Rgb> wanted;         ///< linear, 1 is white paper
  std::optional<Spectrum> measured;  ///< a reflectance in bands, 1 is a perfect diffuser
  uint64_t number = 0;               ///< the asker's, to know the answer by
};

/// Beside a measured standard, as dyers judge it.
struct LampJudgement {
  StandardIlluminant lamp = StandardIlluminant::d65;
  Judgement judgement;
};

/// The dyes are for the fibres of the part in the fabric that is readyToDye().
struct ColourAnswer {
  ColourWish wish;
  bool seen = false;  ///< it lies on top somewhere
  Rgb colour{0};      ///< that the cloth shows now
  double error = 0;   ///< standard error of the colours, CIEDE2000: of what light has been traced (colourError())
  std::optional<SolvedColour> solved;
  std::optional<SolvedReflectance> matched;
  /// Of the cloth as it is beside what was measured, by the observer of 10 degrees, whatever the scene's: so dyers
  /// judge. Under the cloth's own lamp, then under the others of a booth. Metamerism is told from the booth's first.
  /// Empty where nothing was measured.
  std::vector<LampJudgement> judgements;
};

/// Answers the newest wish on a thread of its own, at low priority: light is traced through the cloth once for each
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
  std::optional<Result> answer(ColourWish wish, Answering::Job& job);
  std::shared_ptr<const Fabric> makePaths(ColourWish& wish, Answering::Job& job);

  // The thread's own:
  std::shared_ptr<const ColourAnswer> last_;
  std::shared_ptr<const Fabric> traced_;  ///< ready to dye, through whose cloth paths_ are
  ClothPart tracedPart_;
  PathLengthTally paths_;
  double error_ = 0;  ///< of the paths

  Answering worker_;  // last: it ends before what it uses is gone
};

}  // namespace loomlight
