#include "app/editor/services/colour_book_service.h"

#include <fmt/core.h>

#include <utility>

#include "app/editor/model/book_colours.h"
#include "ui/words/error_words.h"

namespace loomlight {

ColourBookService::ColourBookService(std::function<void()> wake)
    : worker_(
          std::move(wake),
          [](const std::string& file, const auto&) -> std::optional<Read> {
            const ColourFile colours = readColourFile(file);
            if (colours.palette.colours.empty()) return Read{file, {}, fmt::format(words::errors::noColourBook, file)};
            return Read{file, colourBook(colours.palette), ""};
          },
          [](const std::string& file, const std::string& problem) { return Read{file, {}, problem}; },
          Backlog::hanging) {}

}  // namespace loomlight
