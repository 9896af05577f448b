#pragma once

#include <string>

namespace loomlight {

/// What a designer would call an action: a click, a drag, a key with what is held beside it, one value that is typed
/// with the Enter or Tab that takes it, one turn of the wheel. Moving the mouse is none. Tests of the real window count
/// by the same rules.
class ActionCount {
 public:
  int count() const { return count_; }

  /// Something goes down.
  void button() { another(Last::button); }
  void key(const std::string& name) {
    if (name == "ctrl" || name == "shift")
      last_ = Last::held;
    else if (last_ == Last::typed && (name == "Return" || name == "Tab"))
      last_ = Last::taken;
    else
      another(Last::key);
  }
  /// A value, all of it.
  void typed() { another(Last::typed); }
  void wheel() {
    if (last_ != Last::wheel) another(Last::wheel);
  }

 private:
  enum class Last { none, button, key, held, typed, taken, wheel };
  void another(Last kind) {
    ++count_;
    last_ = kind;
  }

  int count_ = 0;
  Last last_ = Last::none;
};

}  // namespace loomlight
