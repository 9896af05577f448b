#include "app/live/turns.h"

namespace loomlight {

Turn nextTurn(const Contender& picture, const Contender& lens) {
  if (!picture.wants) return lens.wants ? Turn::lens : Turn::none;
  if (!lens.wants) return Turn::picture;
  if (picture.divider == 0) return Turn::picture;
  if (lens.divider == 0) return Turn::lens;
  if (picture.divider == 1 && lens.divider > 1) return Turn::lens;
  if (lens.divider == 1 && picture.divider > 1) return Turn::picture;
  return lens.spent_s < picture.spent_s ? Turn::lens : Turn::picture;
}

}  // namespace loomlight
