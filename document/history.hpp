#pragma once

#include "document/document.hpp"

#include <functional>
#include <string>
#include <vector>

namespace zeroset {

/// The states of a document, for undo and redo. Changes become one step if they are of the same
/// part of the document (a row's text, a slider, the camera), made during the same gesture, and
/// follow each other without a rest.
class History {
public:
    /// Time without a change that ends a step, in seconds.
    static constexpr double rest_s = 1.0;
    static constexpr std::size_t most_steps = 500;

    explicit History(Document start) : now_(std::move(start)) {}

    /// Records that the document is this at `time_s` (any clock that does not go back). `gesture`
    /// is a number that changes from one press of a button to the next; while the button is `held`,
    /// a rest does not end a step. A step that returns to where it began is dropped.
    void follow(const Document& document, double time_s, unsigned gesture, bool held = false);
    /// Changes the newest state without making a step, for changes that no person made.
    void amend(const std::function<void(Document&)>& change) { change(now_); }
    /// Lets the next change begin a step.
    void end_step() { open_part_.clear(); }

    [[nodiscard]] bool can_undo() const { return !undone_to_.empty(); }
    [[nodiscard]] bool can_redo() const { return !redone_to_.empty(); }
    /// Goes one step back or forward, if there is one, and returns the document.
    const Document& undo();
    const Document& redo();

private:
    Document now_;
    std::vector<Document> undone_to_;  ///< the newest last
    std::vector<Document> redone_to_;
    std::string open_part_;  ///< the part that the newest step changed; empty: the step has ended
    unsigned open_gesture_ = 0;
    double changed_s_ = 0.0;
};

}  // namespace zeroset
