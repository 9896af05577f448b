#pragma once

#include <string>

#include "ui/widgets/ui.h"

namespace loomlight {

/// A picture with a name below it, which can be chosen among others.
struct PictureCard {
  std::string id;
  ImVec2 picture;         ///< its size; the card is a line higher
  ImTextureID texture{};  ///< 0: there is none yet
  const char* name = "";
  bool isChosen = false;
  bool isQuiet = false;  ///< the name is
  float right = 0;       ///< width that something else takes beside the name, from the right
  std::string about{};   ///< what is said of it where the mouse rests
};

/// Where a card has been drawn, and what was done to it.
struct DrawnCard {
  ImVec2 corner{};  ///< bottom right of the picture, above the end of the line with the name
  bool isPressed = false;
};
DrawnCard pictureCard(Ui& ui, const PictureCard& card);

}  // namespace loomlight
