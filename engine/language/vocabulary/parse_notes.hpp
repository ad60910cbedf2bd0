#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace zeroset {

/// Remarks on what was read in an unusual way, collected while a text is read.
class Notes {
public:
    /// One line about what stands at `offset`.
    void add(std::size_t offset, std::string text);
    /// Gives each remark to the reading of its statement. The readings stand in their order.
    void hand_over(std::vector<Reading>& readings);

private:
    struct Note {
        std::size_t offset;
        std::string text;
    };
    std::vector<Note> notes_;
};

}  // namespace zeroset
