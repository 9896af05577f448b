#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/dialogs/dialogs.h"

namespace loomlight {

/// What the designer is told and asked, one thing at a time, and what waits for the answer.
class QuestionController {
 public:
  enum class Question { none, said, unsaved, forgetRecent, recover };
  /// What unsaved work stands in the way of.
  enum class Afterwards { nothing, quit, beginAnew, open, takeUp };

  /// `safe`: the answer that loses nothing, which Enter gives.
  void ask(Question question, std::string title, std::string text, std::vector<std::string> answers, int safe);
  void say(std::string title, std::string text);
  bool isOpen() const { return message_.isOpen(); }
  bool isAsking(Question question) const { return question_ == question && message_.isOpen(); }
  struct Answer {
    Question question = Question::none;
    int answer = 0;
  };
  /// Once.
  std::optional<Answer> draw(Ui& ui);

  Afterwards afterwards = Afterwards::nothing;  ///< once the work is saved, or need not be
  std::string pendingFile;                      ///< to be opened once the designer has agreed
  std::string leftBehind;    ///< the copy of unsaved work that was found, and is asked about or taken up
  bool recoveryDue = false;  ///< an offer is to be made

 private:
  MessageDialog message_;
  Question question_ = Question::none;
};

}  // namespace loomlight
