#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "ui/dialogs/dialogs.h"

namespace loomlight {

/// What unsaved work stands in the way of.
struct Errand {
  enum class Kind { none, quit, beginAnew, open, takeUp };
  Kind kind = Kind::none;
  std::string file{};  ///< that is to be opened, or taken up
};

/// What the designer is told and asked: one thing after the other, each until it is answered.
class QuestionController {
 public:
  enum class Question { none, said, unsaved, forgetRecent, recover };

  /// `safe`: the answer that loses nothing, which Enter gives. `file`: that it is asked of, if any.
  void ask(Question question, std::string title, std::string text, std::vector<std::string> answers, int safe,
           std::string file = {});
  void say(std::string title, std::string text);
  bool isOpen() const { return !asked_.empty(); }
  /// Now, or once what came before it is answered.
  bool isAsking(Question question) const;
  struct Answer {
    Question question = Question::none;
    std::string file;  ///< that it was asked of
    int answer = 0;
  };
  /// Once.
  std::optional<Answer> draw(Ui& ui);

 private:
  struct Asked {
    Question question = Question::none;
    std::string file, title, text;
    std::vector<std::string> answers;
    int safe = 0;
  };
  void showFirst();

  MessageDialog message_;
  std::deque<Asked> asked_;  ///< the first is up
};

}  // namespace loomlight
