#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "core/fabric/model/changes.h"
#include "render/share/cell_deposits.h"
#include "render/share/known_view.h"
#include "render/share/shared_picture.h"

namespace loomlight {

/// What an edit leaves of the light that repeats share.
struct SharedFate {
  enum class Cells {
    live,    ///< all they know is still so
    prior,   ///< nearly all of it is: they count for few paths
    likely,  ///< their light is like what comes from there now: they count for even fewer
    places,  ///< they are there, but other light comes from them
    none
  };
  Cells cells = Cells::none;
  bool hits = false;  ///< pixels show the same cells
  bool operator==(const SharedFate&) const = default;
};
SharedFate sharedFate(const Changes& edit);

/// Light of one picture that repeats of its cloth share, for the display alone: the cells of the cloth, what the paths
/// of the film have brought from them, and which of them each pixel shows. The film stays exact and knows nothing of
/// it. One thread at a time.
class SharedLight {
 public:
  /// Samples of a pixel from which on the film is shown alone.
  static constexpr uint32_t kFilmAlone = 1024;

  /// Whether it pays to share light: not where all fibres are explicit, nor so near, in a picture that is so large,
  /// that a voxel would be seen as a block of one colour.
  static bool serves(const Scene& scene, int width, int height);

  /// `cells_bytes`: what the cells take at most.
  SharedLight(std::shared_ptr<const Scene> scene, std::shared_ptr<const Medium> medium, int width, int height,
              size_t cells_bytes = CellSums::kLimit_bytes);

  /// Goes on with the picture of another scene, with what the edit leaves of what it knows.
  void moveTo(std::shared_ptr<const Scene> scene, std::shared_ptr<const Medium> medium, int width, int height,
              const Changes& edit);

  /// Samples of a pixel from which on cells are as good as they get.
  static constexpr uint32_t kEnough = 32;
  /// Samples of so many pixels that it can hear in one pass: what they bring is kept until settle(), in 200 MB, or else
  /// one sample of each.
  static uint32_t samplesAtOnce(int width, int height);
  /// Hears the paths of the next pass, whose pixels are 1/divider of the resolution and have so many samples; null
  /// where cells need no more of them.
  FirstFibreSink* listener(uint32_t samples, int divider);
  /// After that pass.
  void settle() { deposits_->settle(); }
  /// Whether some of the film's paths at full resolution, and no coarse ones, go among fibres that are not laid yet, as
  /// no whole sample of them has been traced.
  bool waitsForFibres() const;
  /// Tells it that every pixel of the film has a sample, so that the fibres that it meets are laid.
  void wholeSampleTraced();
  uint32_t hits() const { return hits_->perPixel(); }  ///< first fibres of every pixel
  /// Of those, what a pixel keeps beside the first fibres of so many samples of its own.
  uint32_t mostHits(uint32_t samples) const { return hits_->most() - std::min(hits_->most(), samples); }
  /// So many for every pixel, or what there is time for. False when stopped.
  bool addHits(uint32_t perPixel, const Task& task, double budget_s = std::numeric_limits<double>::infinity());

  /// Whether any light is known; straight after moveTo(), that is light of an earlier picture.
  bool knows() const { return cells_->size() > 0 && (*cells_)[0].paths > 0; }
  /// The view as it is known by what the cells have from an earlier picture and from a coarse film of this one, whose
  /// pixels are `finer` of its own each way. None when stopped.
  std::optional<KnownView> known(const CoarseFilm& coarse, int finer, const Task& task) const;

  /// Whether there is anything to show, be it at half the resolution.
  bool shows() const { return hits_->standForAll() && knows(); }
  /// Linear, premultiplied, of the film's size. `coarser`: as for corrected().
  std::vector<glm::vec4> picture(const Film& film, std::span<const CoarseFilm> coarser, int threads) const;

 private:
  bool goAmongFibres(float times) const;

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Medium> medium_;
  size_t cells_bytes_;
  std::unique_ptr<CellSums> cells_;
  std::unique_ptr<FirstHits> hits_;
  std::unique_ptr<CellDeposits> deposits_;
  std::shared_ptr<const FibreBricks> laid_;  ///< those of the cloth, once a whole sample has met them; else null
};

}  // namespace loomlight
