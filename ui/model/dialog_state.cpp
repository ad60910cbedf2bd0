#include "ui/model/dialog_state.hpp"

#include <filesystem>

namespace zeroset::ui {

std::string ending_of(FileChoice::Purpose purpose) {
    return purpose == FileChoice::Purpose::SavePicture ? ".png" : ".zeroset.json";
}

std::string with_ending(FileChoice::Purpose purpose, const std::string& name) {
    const bool complete = purpose == FileChoice::Purpose::SavePicture
                              ? std::filesystem::path(name).has_extension()
                              : name.ends_with(".json");
    return complete ? name : name + ending_of(purpose);
}

}  // namespace zeroset::ui
