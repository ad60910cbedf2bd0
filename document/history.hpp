#pragma once

#include "document/document.hpp"

#include <functional>
#include <string>
#include <vector>

namespace zeroset {

/// The states of a document, for undo and redo. Changes of one gesture become one step: those of
/// the same part of the document (a row's text, a slider, the camera) during the same gesture that
/// follow each other without a rest.
class History {
public:
    /// Seconds without a change that end a step.
    static constexpr double rest_s = 1.0;
    static constexpr std::size_t most_steps = 500;

    explicit History(Document start) : now_(std::move(start)) {}

    /// What the document is at `time_s` (any clock that does not go back). `gesture` is a number
    /// that changes from one press of a button to the next; while the button is `held`, a rest ends
    /// no step. A step that comes back to where it began is none.
    void follow(const Document& document, double time_s, unsigned gesture, bool held = false);
    /// Changes the newest state without a step: by what no person did.
    void amend(const std::function<void(Document&)>& change) { change(now_); }
    /// The next change begins a step.
    void end_step() { open_part_.clear(); }

    [[nodiscard]] bool can_undo() const { return !undone_to_.empty(); }
    [[nodiscard]] bool can_redo() const { return !redone_to_.empty(); }
    /// The document after one step back or forward; as it is where there is none.
    const Document& undo();
    const Document& redo();

private:
    Document now_;
    std::vector<Document> undone_to_;  ///< the newest last
    std::vector<Document> redone_to_;
    std::string open_part_;  ///< what the newest step changed; empty: it is finished
    unsigned open_gesture_ = 0;
    double changed_s_ = 0.0;
};

}  // namespace zeroset
