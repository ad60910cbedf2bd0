#include "app/exports/export_run.hpp"

#include "engine/base/translation.hpp"

#include <chrono>
#include <utility>

namespace zeroset {

void ExportRun::start(std::string name, ExportWork work) {
    name_ = std::move(name);
    news_ = std::make_unique<ExportNews>(wake_);
    work_ = std::async(std::launch::async,
                       in_this_style([work = std::move(work), news = news_.get(), wake = wake_] {
                           ExportOutcome outcome = work(*news);
                           wake();
                           return outcome;
                       }));
}

void ExportRun::cancel() {
    if (news_ != nullptr) news_->cancel = true;
}

std::optional<ExportOutcome> ExportRun::take() {
    if (!runs() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    ExportOutcome outcome = work_.get();
    const bool given_up = news_->cancel;
    if (given_up && !outcome) return filled(tr("saving {0} was stopped"), {name_});
    return outcome;
}

}  // namespace zeroset
