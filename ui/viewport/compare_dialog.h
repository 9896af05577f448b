#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// Two kept views against each other.
class CompareDialog {
 public:
  struct Model {
    ImTextureID first{}, second{}, difference{};
    float firstAspect = 1, secondAspect = 1;  ///< width over height
    std::string firstName, secondName;
  };
  void show() { open_ = opening_ = true; }
  bool isOpen() const { return open_; }
  void draw(Ui& ui, const Model& model);

 private:
  enum class Way { slider, sideBySide, difference };
  void drawNames(Ui& ui, const Model& model, float left, float middle, float right) const;
  void drawSlider(Ui& ui, const Model& model, ImVec2 min, ImVec2 max);

  bool open_ = false, opening_ = false;
  Way way_ = Way::slider;
  float divide_ = 0.5f;  ///< where the slider is, 0..1
};

}  // namespace loomlight
