#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace zeroset {

/// Remarks on what was read in an unusual way, collected while a text is read.
class Notes {
public:
    /// Adds a remark of one line about the text at `offset`.
    void add(std::size_t offset, std::string text);
    /// Adds all remarks of another text.
    void add(const Notes& others);
    /// Moves each remark from its offset to what `place` makes of it.
    void move_offsets(const std::function<std::size_t(std::size_t)>& place);
    /// Moves each remark into the reading of its statement. `readings` must be in the order of the
    /// text.
    void hand_over(std::vector<Reading>& readings);

private:
    struct Note {
        std::size_t offset;
        std::string text;
    };
    std::vector<Note> notes_;
};

}  // namespace zeroset
