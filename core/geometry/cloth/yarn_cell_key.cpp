#include "core/geometry/cloth/yarn_cell_key.h"

#include "core/base/hash.h"

namespace loomlight {

uint64_t hash(const YarnCellKey& key) {
  uint64_t h = hashCombine(0, static_cast<int>(key.system));
  h = hashCombine(h, key.yarn);
  h = hashCombine(h, key.phase);
  h = hashCombine(h, key.stretch);
  for (const PathNode* node : {&key.previous, &key.here, &key.next}) {
    h = hashCombine(h, node->height_mm);
    h = hashCombine(h, node->aside_mm);
    h = hashCombine(h, node->along_mm);
    h = hashCombine(h, node->up);
    h = hashCombine(h, node->across);
  }
  return h;
}

}  // namespace loomlight
