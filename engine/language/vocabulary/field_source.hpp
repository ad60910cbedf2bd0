#pragma once

#include "engine/expr/expr.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Fields that a text names by files: volume("ct.nrrd", edge), blobs("atoms.xyz"). The language
// knows how they are typed, not how files are read.

namespace zeroset {

/// Such a name, in views of the text.
struct FieldCall {
    std::string_view text;                    ///< all of it
    std::string_view word;                    ///< volume, blobs, metaballs or blinn
    std::string_view file;                    ///< between the quotes
    std::vector<std::string_view> arguments;  ///< behind it, without the spaces around them
};

/// The call that starts at the beginning of `text`: from its word to its closing parenthesis.
/// `text` is empty where none starts there; `file` has no data where its quotes are not closed, and
/// `text` ends before a missing parenthesis.
struct FieldCallStart {
    FieldCall call;
    bool quotes_closed = true;
    bool closed = true;
};
FieldCallStart read_field_call(std::string_view text);

struct FieldError {
    std::string reason;   ///< one line
    std::string hint;     ///< what to type instead; may be empty
    std::string_view at;  ///< the part of the call that it is about
};

/// Where the fields of texts come from. Thread-safe.
class FieldSource {
public:
    FieldSource() = default;
    FieldSource(const FieldSource&) = delete;
    FieldSource& operator=(const FieldSource&) = delete;
    virtual ~FieldSource() = default;

    [[nodiscard]] virtual std::expected<std::shared_ptr<const Field>, FieldError> open(
        const FieldCall& call) const = 0;
    /// Grows whenever texts that name files may read otherwise than before.
    [[nodiscard]] virtual std::uint64_t version() const { return 0; }
};

}  // namespace zeroset
