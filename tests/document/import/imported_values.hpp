#pragma once

#include "document/import/import.hpp"
#include "document/row_program.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace zeroset::test {

/// The contents of a file, which must be readable.
inline Imported read(std::string_view file, std::string_view bytes) {
    auto imported = read_import(file, bytes);
    EXPECT_TRUE(imported) << imported.error();
    return imported ? *imported : Imported{};
}

/// f of a document's surface at a point, its parameters as its sliders say, without its conditions.
inline double value(const ImportedDocument& imported, std::size_t surface, double x, double y,
                    double z, double w = 0.0) {
    Document document = imported.document;
    // Sliders become values.
    for (const auto& [name, slider] : document.parameters) {
        Statement row;
        row.id = unused_id(document);
        row.text = name + " := " + std::to_string(slider.value);
        document.statements.insert(document.statements.begin(), row);
    }
    const auto rows = read_rows(document);
    EXPECT_TRUE(rows) << rows.error().reason;
    if (!rows || surface >= rows->program->surfaces.size()) return std::nan("");
    const Reference at = reference(rows->program->surfaces[surface], std::array{x, y, z, w});
    return at.defined ? at.value.nearest() : std::nan("");
}

inline bool has_note(const ImportedDocument& imported, std::string_view entry) {
    return std::ranges::any_of(
        imported.notes, [entry](const ImportNote& note) { return note.entry.contains(entry); });
}

}  // namespace zeroset::test
