#include "app/desktop/session.hpp"
#include "engine/base/translation.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A session's questions, and what follows from the answers.

namespace zeroset {

void Session::ask(Subject what, std::string text, std::vector<std::string> answers) {
    asked_ = what;
    state_.pages.dialogs.question = ui::Question{
        .text = std::move(text), .answers = std::move(answers), .chosen = std::nullopt};
}

void Session::follow_question() {
    std::optional<ui::Question>& question = state_.pages.dialogs.question;
    if (!question || !question->chosen) return;
    const std::size_t answer = *question->chosen;
    question.reset();
    const Subject asked = std::exchange(asked_, Subject::Nothing);
    if (asked == Subject::Restore) answer_restore(answer);
    if (asked == Subject::LoseWork) answer_lose_work(answer);
    if (asked == Subject::Volumes) volumes_.answer(answer == 0);
}

void Session::ask_for_volumes() {
    if (state_.pages.dialogs.question) return;
    if (auto question = volumes_.question())
        ask(Subject::Volumes, std::move(*question), {tr("Allow"), tr("Don't allow")});
}

void Session::answer_restore(std::size_t answer) {
    if (!lost_) return;
    if (answer == 0) {
        const Document untouched = current();
        // Where it was is not known: it may name what the document may that was opened now.
        lost_->document.files = untouched.files;
        begin(std::move(lost_->document), {});
        saved_ = untouched;
        state_.wishes.focus.reset();
        autosave_.keep(current());
    }
    autosave_.discard(*lost_);
    lost_.reset();
}

void Session::answer_lose_work(std::size_t answer) {
    if (!waiting_) return;
    if (answer == 0) return save();
    const Action action = *std::exchange(waiting_, std::nullopt);
    if (answer == 1) perform(action);
}

}  // namespace zeroset
