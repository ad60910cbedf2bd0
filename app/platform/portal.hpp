#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// Which theme the user of the desktop wants of its programs.
enum class ColorWish : std::uint8_t { None, Dark, Light };

/// A file that is to be chosen in the desktop's dialog.
struct FileRequest {
    bool saves = false;
    std::string folder;  ///< where it begins; absolute
    std::string name;    ///< proposed for a file to be saved
    std::string ending;  ///< of the files that are offered
    std::string parent;  ///< Window::portal_name of the window that the dialog is modal to
};

struct FileAnswer {
    bool asked = false;  ///< false: there is no such dialog; ask in another way
    std::string path;    ///< empty: nothing was chosen
};

/// The desktop's portal on the session's D-Bus (org.freedesktop.portal.Settings and FileChooser).
/// Its thread does all the waiting: members may be called from the UI thread and return at once.
/// Without a bus or a portal there is no wish, and answers say so.
class Portal {
public:
    /// `on_news` is called from the portal's thread when there is something to take.
    explicit Portal(std::function<void()> on_news);
    ~Portal();
    Portal(const Portal&) = delete;
    Portal& operator=(const Portal&) = delete;

    /// The newest wish that was not taken yet.
    std::optional<ColorWish> take_wish();
    /// Opens the dialog, in place of one that is open.
    void ask(const FileRequest& request);
    /// Closes it: there will be no answer.
    void give_up();
    std::optional<FileAnswer> take_answer();

private:
    class Thread;
    std::unique_ptr<Thread> thread_;
};

/// The path of a file URI, or nothing: "file:///a%20b" is "/a b".
std::optional<std::string> path_of_uri(const std::string& uri);

}  // namespace zeroset
