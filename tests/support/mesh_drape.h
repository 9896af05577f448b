#pragma once

#include <fstream>

#include "core/fabric/model/fabric.h"
#include "tests/support/scratch_folder.h"

namespace loomlight::test {

/// A saddle of 3 mm in a file, as somebody would model it: bent both ways, and stretched where it is steep.
class MeshDrape {
 public:
  MeshDrape() {
    constexpr int kParts = 8;
    constexpr double kSide_mm = 3;
    std::ofstream obj(file_);
    for (int y = 0; y <= kParts; ++y)
      for (int x = 0; x <= kParts; ++x) {
        const double u = kSide_mm * x / kParts, v = kSide_mm * y / kParts;
        const double across = u - kSide_mm / 2, along = v - kSide_mm / 2;
        obj << "v " << across << ' ' << along << ' ' << 0.2 * (across * across - along * along) << "\nvt " << u << ' '
            << v << '\n';
      }
    for (int y = 0; y < kParts; ++y)
      for (int x = 0; x < kParts; ++x) {
        const int a = y * (kParts + 1) + x + 1, b = a + 1, c = b + kParts + 1, d = c - 1;
        obj << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << c << '/' << c << ' ' << d << '/' << d << '\n';
      }
  }

  void giveTo(Fabric& fabric) const {
    fabric.drape.kind = DrapeKind::mesh;
    fabric.drape.file = file_;
    fabric.drape.uvScale_mm = 1;
  }

 private:
  ScratchFolder folder_;
  std::string file_ = folder_.file("saddle.obj");
};

}  // namespace loomlight::test
