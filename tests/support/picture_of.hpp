#pragma once

#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <string_view>
#include <utility>

namespace zeroset::test {

/// The request of a small picture of a text, interpreted.
inline PictureRequest picture_of(std::string_view text) {
    ReadDocument read = read_document_text(text);
    const auto prepared =
        prepare(read.document, std::move(*read.rows), Preparation::Interpreted).value();
    return picture_request(prepared.formula, prepared.colors, read.document, {}, {8, 8});
}

}  // namespace zeroset::test
