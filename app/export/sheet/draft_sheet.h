#pragma once

#include <span>
#include <string>

#include "core/base/task.h"
#include "core/fabric/model/fabric.h"

struct _cairo;  // cairo_t, by its own name; NOLINT(bugprone-reserved-identifier)

namespace loomlight {

/// The corner of the drawdown where end 1 and pick 1 are.
struct DraftCorner {
  bool right = false, top = false;
};

/// One repeat as a weaver prints it: drawdown with colours, threading, tie-up and treadling or liftplan where its draft
/// is of a loom, under a line that says what it is. `.pdf`: A4 pages, as many as keep the crossings legible. `.png`:
/// one picture. A jacquard too large for that is drawn as a whole, with a dot for each crossing. Yarns have the colours
/// that the cloth reaches (reachedColours()), for which light is traced through it. False, and nothing is written, when
/// stopped. Throws InputError when the file cannot be written, or has another extension.
bool writeDraftSheet(const std::string& file, const Fabric& fabric, const DraftCorner& corner, const Task& task);

/// As much of the draft as is legible in a rectangle of so many points, from end 1 and pick 1 on, at cairo's origin.
/// `yarnColours`: linear, one for each. Returns what it is, in numbers.
std::string drawDraft(_cairo* canvas, const Fabric& fabric, std::span<const Rgb> yarnColours, const DraftCorner& corner,
                      double width, double height);

}  // namespace loomlight
