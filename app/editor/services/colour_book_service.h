#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/live/worker.h"
#include "ui/inspector/colour_book.h"

namespace loomlight {

/// Reads colour books again that were used before; their disk may have gone. All calls in the window's thread, and none
/// waits.
class ColourBookService {
 public:
  struct Read {
    std::string file;
    std::optional<ColourBook> book;
    std::string problem;  ///< why there is none
  };
  explicit ColourBookService(std::function<void()> wake);

  /// Only the book that was asked for last comes.
  void read(const std::string& file) { worker_.ask(file); }
  void forget() { worker_.forget(); }
  std::optional<Read> take() { return worker_.take(); }

 private:
  Worker<std::string, Read> worker_;
};

}  // namespace loomlight
