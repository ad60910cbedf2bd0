#include "document/framing.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// A surface smaller than this part of the clip box gets a clip box of its own.
constexpr double small_part = 0.25;
/// The clip box is larger by this part than what it holds.
constexpr double margin = 0.02;
/// A surface that sticks out by less than this part of its size may only seem to, as its extent is
/// an enclosure.
constexpr double tolerance = 2.0 / 64.0;

double rounded_up(double length) {
    const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
    return std::ceil(length / unit * (1.0 - 1e-12)) * unit;
}

/// A cube around the box, centred on the origin where that makes it not much larger.
Box cube_about(const Box& box) {
    constexpr double not_much = 1.3;
    const glm::dvec3 far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double about_origin = std::max({far.x, far.y, far.z});
    const double about_centre = 0.5 * box.size();
    if (about_origin <= not_much * about_centre) {
        return Box::cube(rounded_up((1.0 + margin) * about_origin));
    }
    const double half = rounded_up((1.0 + margin) * about_centre);
    return {.lo = box.centre() - half, .hi = box.centre() + half};
}

bool sticks_out(const Box& box, const Box& clip) {
    const double slack = tolerance * box.size();
    return glm::any(glm::lessThan(box.lo, clip.lo - slack)) ||
           glm::any(glm::greaterThan(box.hi, clip.hi + slack));
}

/// The box as it lies: "±1.1", or "x 7.9 to 10.1, y -1.1 to 1.1, z -1.1 to 1.1".
std::string box_text(const Box& box) {
    constexpr int digits = 4;
    const double half = 0.5 * box.size();
    if (box == Box::cube(half)) return "\u00B1" + localized(short_number(half, digits));
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ", ";
        text += filled(tr("{0} {1} to {2}"), {std::string(1, static_cast<char>('x' + axis)),
                                              localized(short_number(box.lo[axis], digits)),
                                              localized(short_number(box.hi[axis], digits))});
    }
    return text;
}

Framing shown(const Document& document, const Box& seen, double aspect, std::string note) {
    Framing framing{.document = document, .note = std::move(note), .found = true};
    const Box& looked_at = draws_box(document) ? box_in_view(document) : seen;
    framing.document.camera = framed(camera_of(document, aspect), looked_at, aspect);
    return framing;
}

Framing framed_whole(Document document, const Box& whole, double aspect) {
    document.clip = cube_about(whole);
    std::string note =
        filled(tr("framed the whole surface: clip box {0}"), {box_text(document.clip)});
    return shown(document, whole, aspect, std::move(note));
}

}  // namespace

bool draws_box(const Document& document) {
    return document.axes || document.clip_box || document.grid;
}

Box box_in_view(const Document& document) {
    constexpr double with_numbers = 1.14;
    return document.axes ? scaled(document.clip, with_numbers) : document.clip;
}

Camera whole_view(const Camera& camera, const Document& document, double aspect) {
    return framed(camera, box_in_view(document), aspect);
}

Camera fitting(const Camera& camera, double aspect) {
    if (!(aspect > 0.0) || aspect >= 1.0) return camera;
    Camera wider = camera;
    wider.fov_rad = 2.0 * std::atan(std::tan(0.5 * camera.fov_rad) / aspect);
    return wider;
}

std::optional<Framing> frame_by_itself(const Document& document, const Extent& extent,
                                       double aspect) {
    if (!extent.whole) return std::nullopt;
    if (sticks_out(*extent.whole, Box())) {
        Framing framing = framed_whole(document, *extent.whole, aspect);
        if (framing.document.clip == document.clip) return std::nullopt;
        return framing;
    }
    if (document.clip == Box()) return std::nullopt;
    Document usual = document;
    usual.clip = Box();
    return shown(usual, usual.clip, aspect,
                 filled(tr("framed the whole surface: clip box {0}"), {box_text(usual.clip)}));
}

Extent unstretched(Extent extent, const glm::dvec3& stretch) {
    for (std::optional<Box>* const box : {&extent.whole, &extent.inside, &extent.reached}) {
        if (*box) *box = stretched(**box, 1.0 / stretch);
    }
    return extent;
}

Camera camera_of(const Document& document, double aspect) {
    return camera_of(document, aspect, stretch_of(document));
}

Camera camera_of(const Document& document, double aspect, const glm::dvec3& stretch) {
    if (!document.camera)
        return default_camera(box_in_view(document), aspect, document.up, stretch);
    if (document.camera->stretch == stretch) return *document.camera;
    Camera camera = *document.camera;
    camera.stretch = stretch;
    return framed(camera, box_in_view(document), aspect);
}

Framing frame_surfaces(const Document& document, const Extent& extent, double aspect,
                       bool may_clip) {
    Document wished = document;
    if (may_clip && extent.whole) {
        const bool small = extent.whole->size() < small_part * document.clip.size();
        if (small || sticks_out(*extent.whole, document.clip))
            return framed_whole(document, *extent.whole, aspect);
    }
    if (extent.inside) {
        const char* const note = extent.whole
                                     ? tr("framed the surface")
                                     : tr("framed what the clip box shows: the surface goes on");
        return shown(wished, *extent.inside, aspect, note);
    }
    if (may_clip && extent.reached) {
        wished.clip = *extent.reached;
        return shown(wished, wished.clip, aspect,
                     filled(tr("enlarged the clip box until it meets the surface: {0}"),
                            {box_text(wished.clip)}));
    }
    const bool somewhere = extent.whole || extent.reached;
    return {.document = document,
            .note = somewhere ? tr("the clip box holds nothing of the surface")
                              : tr("no surface: f vanishes nowhere near the clip box"),
            .found = false};
}

}  // namespace zeroset
