#pragma once

#include "document/document.hpp"

#include <expected>
#include <string>
#include <string_view>

// A session as one line that can be sent in a message: "zeroset:" and the document's JSON,
// deflated, in base64url [RFC 4648, sec. 5].

namespace zeroset {

inline constexpr std::string_view share_prefix = "zeroset:";

std::string share_text(const Document& document);

/// Whether the text is one of share_text, blanks at its ends aside.
bool is_share_text(std::string_view text);

/// The document's JSON in a text of share_text, which may be broken into lines; or one clause on
/// the damage.
std::expected<std::string, std::string> shared_json(std::string_view text);

}  // namespace zeroset
