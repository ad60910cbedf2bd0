#include "engine/language/expressions/field_files.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/field_source.hpp"

namespace zeroset {

std::shared_ptr<const Field> FieldFiles::field(const std::string& call, std::size_t offset) {
    const auto known = fields_.find(call);
    if (known != fields_.end()) return known->second;
    if (files_ == nullptr) {
        values_.fail(offset, tr("no files are read here"));
        return nullptr;
    }
    const FieldCall typed = read_field_call(call).call;
    const auto field = files_->open(typed);
    if (!field) {
        const FieldError& error = field.error();
        const bool has_place = !error.at.empty();
        const std::size_t inside =
            has_place ? static_cast<std::size_t>(error.at.data() - typed.text.data()) : 0;
        values_.fail(offset + inside, error.reason, error.hint);
        return nullptr;
    }
    fields_.emplace(call, *field);
    return *field;
}

}  // namespace zeroset
