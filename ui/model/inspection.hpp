#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/measure/wrong_pixels.hpp"
#include "engine/view/camera.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

// Tracers at work, for those who want to look into them: which one draws, another one beside it,
// what pixels cost.

namespace zeroset::ui {

/// The choice of what is to be looked into. Not kept from window to window.
struct Inspection {
    std::string tracer = "beams";      ///< that draws the picture
    std::optional<std::string> other;  ///< that draws the same picture beside it
    bool difference = false;           ///< where the two differ, in place of both pictures
    bool costs = false;                ///< colours tell what each pixel took
    float divider = 0.5F;  ///< the part of the picture's width that is left of the other's

    bool operator==(const Inspection&) const = default;
};

/// A tracer that can be chosen.
struct TracerChoice {
    std::string name;
    std::string about;  ///< one line, to be translated
    bool finds_jumps;
};

/// Which of the two pictures tells what is right.
enum class Reference : std::uint8_t {
    None,   ///< neither tracer proves anything
    First,  ///< the picture
    Other,  ///< the other tracer's
};

/// The picture of the other tracer, fine or coarse.
struct OtherPicture {
    std::string tracer;                        ///< that drew it
    std::shared_ptr<const Framebuffer> frame;  ///< nullptr: none yet
    Camera camera;                             ///< that the frame was taken with
    unsigned int texture = 0;  ///< OpenGL's name of it, or of the difference; 0: none
    double frame_ms = 0.0;     ///< of a complete picture
    bool complete = false;
    /// The wrong pixels of two complete pictures of the same view, where the difference is wanted.
    std::optional<WrongPixels> wrong;
    Reference reference = Reference::None;  ///< what `wrong` is told by
};

}  // namespace zeroset::ui
