#include "document/import/math_model.hpp"
#include "document/import/readers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <array>

// Equations of K3DSurf: lines "F(): ...", "[x]: lo, hi" and so on; a ";" ends an equation.

namespace zeroset {
namespace {

/// A mark at the beginning of a line, and the fields it fills.
struct Mark {
    std::string_view mark;
    std::string_view field;  ///< of MathMod; a limit's without min and max
    bool is_limit = false;
};
constexpr std::array marks{Mark{.mark = "F():", .field = "Fxyz"},
                           Mark{.mark = "X():", .field = "Fx"},
                           Mark{.mark = "Y():", .field = "Fy"},
                           Mark{.mark = "Z():", .field = "Fz"},
                           Mark{.mark = "[x]:", .field = "X", .is_limit = true},
                           Mark{.mark = "[y]:", .field = "Y", .is_limit = true},
                           Mark{.mark = "[z]:", .field = "Z", .is_limit = true},
                           Mark{.mark = "[u]:", .field = "U", .is_limit = true},
                           Mark{.mark = "[v]:", .field = "V", .is_limit = true},
                           Mark{.mark = "Cnd:", .field = "Cnd"},
                           Mark{.mark = "Name:", .field = "Name"},
                           Mark{.mark = "A[u]:", .field = "A[u]"},
                           Mark{.mark = "B[u]:", .field = "B[u]"},
                           Mark{.mark = "C[u]:", .field = "C[u]"},
                           Mark{.mark = "D[u,v]:", .field = "D[u,v]"},
                           Mark{.mark = "E[u,v]:", .field = "E[u,v]"},
                           Mark{.mark = "F[u,v]:", .field = "F[u,v]"}};

class K3dsReader {
public:
    ReadImport run(std::string_view text) {
        std::size_t line = 0;
        for (const std::string_view row : split(text, '\n'))
            read(row, ++line);
        finish();
        if (imported_.documents.empty())
            return import_error(0, tr("it has no F(): or X():, as equations of K3DSurf have"));
        return std::move(imported_);
    }

private:
    void read(std::string_view row, std::size_t line) {
        if (in_remark_ || row.starts_with("/*")) {
            in_remark_ = !row.contains("*/");
            return;
        }
        if (row.empty() || row.starts_with('#')) return;
        const bool ends = row.ends_with(';');
        if (ends) row = trimmed(row.substr(0, row.size() - 1));
        if (!row.empty()) take(row, line);
        if (ends) finish();
    }

    void take(std::string_view row, std::size_t line) {
        for (const Mark& mark : marks) {
            if (!row.starts_with(mark.mark)) continue;
            const std::string_view value = trimmed(row.substr(mark.mark.size()));
            if (model_.line == 0) model_.line = line;
            open_ = std::string(mark.field);
            if (mark.is_limit) return take_limits(value, line);
            model_.fields[open_] = {std::string(value)};
            return;
        }
        if (open_.empty() || open_.size() == 1) {
            notes_.push_back({.line = line,
                              .entry = std::string(row.substr(0, 20)),
                              .reason = tr("no line of K3DSurf; it is left out")});
            return;
        }
        // A formula goes on in the next line.
        model_.fields[open_].front() += " " + std::string(row);
    }

    void take_limits(std::string_view value, std::size_t line) {
        // A comma in brackets parts arguments, not the limits.
        int depth = 0;
        for (std::size_t i = 0; i < value.size(); ++i) {
            depth += value[i] == '(' ? 1 : value[i] == ')' ? -1 : 0;
            if (value[i] != ',' || depth != 0) continue;
            model_.fields[open_ + "min"] = {std::string(trimmed(value.substr(0, i)))};
            model_.fields[open_ + "max"] = {std::string(trimmed(value.substr(i + 1)))};
            return;
        }
        notes_.push_back({.line = line, .entry = open_, .reason = tr("two limits are missing")});
    }

    void name_fields() {
        for (const Mark& mark : marks) {
            const std::string field = std::string(mark.field) + (mark.is_limit ? "min" : "");
            model_.names_in_file[field] = mark.mark.substr(0, mark.mark.size() - 1);
        }
    }

    void finish() {
        const bool implicit = model_.fields.contains("Fxyz");
        const bool parametric = model_.fields.contains("Fx");
        if ((implicit || parametric) && imported_.documents.size() < most_imported) {
            model_.kind = implicit ? "Iso3D" : "Param3D";
            model_.name = model_.text("Name", 0);
            name_fields();
            ImportedDocument document = document_of(model_);
            document.notes.insert(document.notes.end(), notes_.begin(), notes_.end());
            imported_.documents.push_back(std::move(document));
        } else {
            imported_.notes.insert(imported_.notes.end(), notes_.begin(), notes_.end());
        }
        notes_.clear();
        model_ = {};
        open_.clear();
    }

    MathModel model_{};
    std::string open_;  ///< the field of the last mark
    bool in_remark_ = false;
    std::vector<ImportNote> notes_;
    Imported imported_;
};

}  // namespace

ReadImport read_k3ds(std::string_view text) { return K3dsReader().run(text); }

}  // namespace zeroset
