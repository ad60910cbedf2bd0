#pragma once

#include "engine/view/camera.hpp"
#include "engine/view/image_point.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

struct Layout;

/// The keyboard goes to a row.
struct RowFocus {
    enum class Caret : std::uint8_t { All, Start, End, At };
    int row = 0;  ///< its id
    Caret caret = Caret::End;
    std::size_t at = 0;  ///< the byte of the text, for Caret::At
};

/// Commands about the document as a whole.
enum class Command : std::uint8_t {
    New,
    Open,
    OpenFolder,  ///< as a gallery
    Save,
    SaveAs,
    Export,  ///< asks for the name of the file for what the export page wishes
    Undo,
    Redo,
    Copy,
    Share,  ///< copies the document as one line of text
    Paste,
    CopyCamera,  ///< as one line of text
    PasteCamera,
    Quit,
};

/// A press of the button over the picture that was no drag.
struct PictureClick {
    ViewPoint cursor;
    int marker = 0;        ///< number of the one that was clicked; 0: none
    bool again = false;    ///< the second of a double click
    bool at_once = false;  ///< no second one follows: it came from the keyboard
};

/// The pictures that the gallery's page has room for.
struct ThumbnailWish {
    std::vector<std::size_t> items;  ///< lines of the gallery whose pictures are in sight
    glm::ivec2 size_px{0};
};

/// The pictures that the saved views in sight have room for.
struct ViewPictureWish {
    std::vector<Camera> cameras;
    glm::ivec2 size_px{0};
};

/// Everything panels ask for. A panel sets a wish; whoever fulfils it clears it: the list of
/// statements the first two, the section of markers `point_field`, the owner all others.
struct Wishes {
    std::optional<RowFocus> focus;
    std::optional<int> reload;                ///< a row whose field must show a text set elsewhere
    bool frame_surfaces = false;              ///< the camera is to see all of the surfaces
    bool frame_box = false;                   ///< the camera is to see the whole clip box
    bool reset_view = false;                  ///< the camera is to be the first one again
    std::optional<std::size_t> gallery_item;  ///< a line of the gallery was picked
    std::optional<std::string> open_path;     ///< a recent file was picked
    std::optional<Command> command;
    std::optional<std::string> export_path;  ///< of the file for what the export page wishes
    std::optional<std::string> show_file;    ///< the folder of this file is to be opened
    bool copy_picture = false;               ///< to the clipboard, in the size of the screen
    bool stop_export = false;                ///< gives up what is being saved
    std::optional<PictureClick> click;
    bool snap_marker = false;  ///< the selected marker goes to a singular point or an extremum
    bool Layout::* section = nullptr;  ///< of the side panel, to be opened and seen; nullptr: none
    bool point_field = false;  ///< the keyboard goes to the field into which a point is typed
    ThumbnailWish thumbnails;  ///< lasts while the page is open
    /// The size of pictures of each look, while those are to be chosen from.
    std::optional<glm::ivec2> look_pictures_px;
    std::optional<ViewPictureWish> view_pictures;  ///< while saved views are in sight
};

}  // namespace zeroset::ui
