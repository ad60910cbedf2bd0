#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Theme that the user prefers according to the desktop's settings.
enum class ColorWish : std::uint8_t { None, Dark, Light };

/// A request for the desktop's file dialog.
struct FileRequest {
    std::string title;
    bool saves = false;
    bool opens_folder = false;  ///< and not a file
    std::string folder;         ///< folder shown first; absolute
    std::string name;           ///< proposed name of a file to be saved
    std::string ending;         ///< ending of the files that are offered
    /// Endings of other files that are offered, too.
    std::vector<std::string> other_endings;
    std::string parent;  ///< Window::portal_name of the window that the dialog is modal to
};

struct FileAnswer {
    bool asked = false;  ///< false: there is no such dialog; use another way
    std::string path;    ///< empty: nothing was chosen
};

/// Client of the desktop portal on the session's D-Bus (org.freedesktop.portal.Settings and
/// FileChooser). A thread of its own does all the waiting: members are called from the UI thread
/// and return at once. Without a bus or a portal there is no wish, and answers have `asked` false.
class Portal {
public:
    /// `on_news` is called on the portal's thread when there is a wish or an answer to take.
    explicit Portal(std::function<void()> on_news);
    ~Portal();
    Portal(const Portal&) = delete;
    Portal& operator=(const Portal&) = delete;

    /// Returns the newest wish that was not taken yet.
    std::optional<ColorWish> take_wish();
    /// Opens the dialog; an open one is closed first.
    void ask(const FileRequest& request);
    /// Closes the dialog; no answer will come.
    void give_up();
    std::optional<FileAnswer> take_answer();
    /// Has the desktop's manager of files show this file in its folder.
    void show(const std::string& path);

private:
    class Thread;
    std::unique_ptr<Thread> thread_;
};

/// Returns the path of a file URI, or nothing: "file:///a%20b" gives "/a b".
std::optional<std::string> path_of_uri(const std::string& uri);
/// The other way round, of an absolute path.
std::string uri_of_path(const std::string& path);

}  // namespace zeroset
