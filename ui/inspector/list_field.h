#pragma once

#include <functional>
#include <string>

#include "ui/widgets/field_row.h"
#include "ui/widgets/ui.h"

namespace loomlight {

/// A list of numbers as text, which is taken while it is typed; what is none is refused below the field, with a word of
/// what was expected. `none` stands in a field without text. `take(text)`: whether it is one.
bool listField(Ui& ui, const RowText& text, std::string typed, const char* none, const std::string& expected,
               const std::function<bool(const std::string&)>& take);

}  // namespace loomlight
