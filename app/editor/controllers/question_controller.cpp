#include "app/editor/controllers/question_controller.h"

#include <algorithm>
#include <utility>

#include "ui/words/message_words.h"

namespace loomlight {

void QuestionController::ask(Question question, std::string title, std::string text, std::vector<std::string> answers,
                             int safe, std::string file) {
  asked_.push_back({question, std::move(file), std::move(title), std::move(text), std::move(answers), safe});
  if (asked_.size() == 1) showFirst();
}

void QuestionController::showFirst() {
  const Asked& first = asked_.front();
  message_.show(first.title, first.text, first.answers, first.safe);
}

bool QuestionController::isAsking(Question question) const {
  return std::ranges::any_of(asked_, [question](const Asked& asked) { return asked.question == question; });
}

void QuestionController::say(std::string title, std::string text) {
  ask(Question::said, std::move(title), std::move(text), {words::messages::ok}, 0);
}

std::optional<QuestionController::Answer> QuestionController::draw(Ui& ui) {
  const auto given = message_.draw(ui);
  if (!given) return std::nullopt;
  Answer answer{asked_.front().question, std::move(asked_.front().file), *given};
  asked_.pop_front();
  if (!asked_.empty()) showFirst();
  return answer;
}

}  // namespace loomlight
