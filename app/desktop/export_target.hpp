#pragma once

#include "ui/model/ui_state.hpp"

#include <string>

namespace zeroset {

/// A file in the folder that is not there yet: "NAME.png", else "NAME-2.png" and so on. `ending`
/// with its dot. Empty where all of very many names are taken.
std::string unused_file(const std::string& folder, const std::string& name,
                        const std::string& ending);

/// Keeps Shown::export_target, the file that the export page saves without asking. The window's
/// thread only.
class ExportTarget {
public:
    /// To be called after each frame of the panels; `folder` and `name`: for the next file.
    void follow(ui::UiState& state, const std::string& folder, const std::string& name);

private:
    /// Folder, name and ending of the file that was proposed last; an empty ending: none was.
    struct Proposal {
        std::string folder, name, ending;

        bool operator==(const Proposal&) const = default;
    };
    Proposal last_;
};

}  // namespace zeroset
