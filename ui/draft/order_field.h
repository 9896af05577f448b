#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"
#include "ui/widgets/fields.h"

namespace loomlight {

/// A yarn order as it was typed. Groups stay as they were written for as long as they say what the cloth has.
struct OrderText {
  bool open = false;    ///< it is being typed
  bool edited = false;  ///< and is another one than it was
  std::string text;
  std::vector<int> sequence;  ///< that the text stood for, or stood beside when it was refused
  float lines = 1;            ///< that the field has room for
  std::string problem;        ///< why it was refused; the text stays, to be mended
  std::vector<int> wanted;    ///< what it asks for where it names yarns that are not there; else empty
};

/// A field as wide as the panel that grows with its text, and the line below: what the order comes to, or why the text
/// is none, with the yarn that it lacks on offer. `pitch_mm`: between ends or picks. Returns the fabric after an edit.
std::optional<Fabric> orderField(Ui& ui, const RowText& text, const Fabric& fabric, std::vector<int> Fabric::* system,
                                 double pitch_mm, OrderText& typing);

}  // namespace loomlight
