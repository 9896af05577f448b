#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

struct _cairo;  // cairo_t, by its own name; NOLINT(bugprone-reserved-identifier)

namespace loomlight {

/// The corner of the drawdown where end 1 and pick 1 are.
struct DraftCorner {
  bool right = false, top = false;
};

/// One repeat as a weaver prints it: drawdown with colours, threading, tie-up and treadling or liftplan where its draft
/// is of a loom, under a line that says what it is. `.pdf`: A4 pages, as many as keep the crossings legible. `.png`:
/// one picture. A jacquard too large for that is drawn as a whole, with a dot for each crossing. Throws InputError when
/// the file cannot be written, or has another extension.
void writeDraftSheet(const std::string& file, const Fabric& fabric, const DraftCorner& corner);

/// As much of the draft as is legible in a rectangle of so many points, from end 1 and pick 1 on, at cairo's origin.
/// Returns what it is, in numbers.
std::string drawDraft(_cairo* canvas, const Fabric& fabric, const DraftCorner& corner, double width, double height);

}  // namespace loomlight
