#include "app/editor/controllers/question_controller.h"

#include <utility>

#include "ui/words/message_words.h"

namespace loomlight {

void QuestionController::ask(Question question, std::string title, std::string text, std::vector<std::string> answers,
                             int safe, std::string file) {
  asked_ = {question, std::move(file)};
  message_.show(std::move(title), std::move(text), std::move(answers), safe);
}

void QuestionController::say(std::string title, std::string text) {
  ask(Question::said, std::move(title), std::move(text), {words::messages::ok}, 0);
}

std::optional<QuestionController::Answer> QuestionController::draw(Ui& ui) {
  const auto answer = message_.draw(ui);
  if (!answer) return std::nullopt;
  asked_.answer = *answer;
  return std::exchange(asked_, {});
}

}  // namespace loomlight
