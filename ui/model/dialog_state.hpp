#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// A question over everything, or with one answer a message.
struct Question {
    std::string text;
    /// The last is what Escape gives; each begins with a capital of its own, and that letter gives
    /// it, too.
    std::vector<std::string> answers;
    std::optional<std::size_t> chosen;  ///< set by the panel
    std::size_t marked = 0;  ///< what Enter gives: the first, until arrows or Tab move on
};

/// A choice of a file, in the window itself.
struct FileChoice {
    enum class Purpose : std::uint8_t { Open, OpenFolder, Save, Export };
    Purpose purpose = Purpose::Open;
    std::string title;
    /// The ending of the files that are offered, and of names without one.
    std::string ending = ".zeroset.json";
    /// The endings of other files that are offered; small letters.
    std::vector<std::string> other_endings;
    std::string folder;         ///< shown; absolute
    std::string name;           ///< in the field
    bool finished = false;      ///< set by the panel
    std::string path;           ///< what was chosen, when it is finished; empty: nothing
    bool begins = true;         ///< nobody has asked yet
    bool elsewhere = false;     ///< asked in the desktop's own dialog; here one can only give up
    bool asks_replace = false;  ///< the file exists; another press of Save replaces it

    [[nodiscard]] bool saves() const {
        return purpose == Purpose::Save || purpose == Purpose::Export;
    }
};

/// The name, with the choice's ending where it has none: a document's ends in .json, another file's
/// ending says its format.
inline std::string with_ending(const FileChoice& choice, const std::string& name) {
    const bool complete = choice.purpose == FileChoice::Purpose::Export
                              ? std::filesystem::path(name).has_extension()
                              : name.ends_with(".json");
    return complete ? name : name + choice.ending;
}

/// Questions to the user; the owner sets it, acts on the answer and clears it.
struct Dialogs {
    std::optional<Question> question;
    std::optional<FileChoice> file;
};

}  // namespace zeroset::ui
