#include "ui/model/dialog_state.hpp"

#include <filesystem>

namespace zeroset::ui {

std::string with_ending(const FileChoice& choice, const std::string& name) {
    const bool complete = choice.purpose == FileChoice::Purpose::Export
                              ? std::filesystem::path(name).has_extension()
                              : name.ends_with(".json");
    return complete ? name : name + choice.ending;
}

}  // namespace zeroset::ui
