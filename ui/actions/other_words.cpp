#include "ui/actions/other_words.hpp"

#include <algorithm>
#include <array>

namespace zeroset::ui {
namespace {

constexpr auto word_table = std::to_array<OtherWords>({
    {.action = "Reset the view", .words = "camera, home view, start view, default view"},
    {.action = "Parallel rays", .words = "camera, orthographic, perspective, isometric projection"},
    {.action = "Mark undecided pixels", .words = "uncertain, unproved, certificate, certified"},
    {.action = "Cost of each pixel", .words = "heatmap, heat map, speed, performance, evaluations"},
    {.action = "Another tracer beside",
     .words = "compare, comparison, side by side, algorithm, method, difference, k-bisection, "
              "newton, octree"},
    {.action = "Difference of two tracers",
     .words = "compare, comparison, error, missed pixels, wrong pixels, algorithm"},
    {.action = "Draw jumps in sign", .words = "discontinuity, step, pole"},
    {.action = "Keep a marker", .words = "point, pin, coordinates, probe"},
    {.action = "Next marker", .words = "point, coordinates"},
    {.action = "Remove the marker", .words = "delete point"},
    {.action = "Snap the marker",
     .words = "singular point, singularity, node, extremum, maximum, minimum, highest point, "
              "lowest point, "
              "critical point, newton"},
    {.action = "Go to a point...", .words = "coordinates, camera, look at, type a point, jump to"},
    {.action = "Color by surface and side", .words = "colour, color, paint, plain"},
    {.action = "Color by normal", .words = "colour, color, orientation"},
    {.action = "Color by height", .words = "colour, color, elevation, altitude"},
    {.action = "Color by distance from the eye", .words = "colour, color, depth"},
    {.action = "Color by mean curvature", .words = "colour, color, heatmap"},
    {.action = "Color by Gaussian curvature", .words = "colour, color, heatmap"},
    {.action = "Color by length of the gradient", .words = "colour, color, slope, heatmap"},
    {.action = "Color by an expression", .words = "colour, color, formula, function, heatmap"},
    {.action = "Look: standard", .words = "material, style, appearance"},
    {.action = "Look: Phong", .words = "material, shiny, plastic, appearance"},
    {.action = "Look: matte", .words = "material, dull, appearance"},
    {.action = "Look: porcelain", .words = "material, ceramic, appearance"},
    {.action = "Look: metal", .words = "material, steel, gold, mirror, reflection, appearance"},
    {.action = "Look: glass", .words = "material, transparent, translucent, appearance"},
    {.action = "Look: clay", .words = "material, ambient occlusion, appearance"},
    {.action = "Look: technical", .words = "material, drawing, outline, silhouette, appearance"},
    {.action = "No contour lines", .words = "level lines, isolines"},
    {.action = "Contour lines of height", .words = "level lines, isolines, topographic"},
    {.action = "Contour lines of x, y and z",
     .words = "level lines, isolines, coordinate lines, grid lines"},
    {.action = "Shadows", .words = "light, shade"},
    {.action = "Smooth edges", .words = "antialias, anti-aliasing, jagged, quality"},
    {.action = "Axes, box and grid", .words = "textbook, coordinate system, ticks, frame, labels"},
    {.action = "Axes", .words = "coordinate system, ticks, numbers, scale"},
    {.action = "Clip box", .words = "bounding box, frame, cube, border"},
    {.action = "Grid", .words = "floor, ground, mesh lines, squares"},
    {.action = "Handles", .words = "clip, cut, section, drag"},
    {.action = "Frame the surface", .words = "camera, fit, zoom to fit, show all, zoom extents"},
    {.action = "View from the front", .words = "camera"},
    {.action = "View from the right", .words = "camera, side"},
    {.action = "View from above", .words = "camera, top, plan"},
    {.action = "View from behind", .words = "camera, back"},
    {.action = "View from the left", .words = "camera, side"},
    {.action = "View from below", .words = "camera, bottom"},
    {.action = "Isometric view", .words = "camera, corner"},
    {.action = "Opposite view", .words = "camera, other side, flip"},
    {.action = "Orbit to the left", .words = "camera, rotate, turn"},
    {.action = "Orbit to the right", .words = "camera, rotate, turn"},
    {.action = "Orbit up", .words = "camera, rotate, turn"},
    {.action = "Orbit down", .words = "camera, rotate, turn"},
    {.action = "Zoom in", .words = "camera, nearer, closer, magnify"},
    {.action = "Zoom out", .words = "camera, farther, away"},
    {.action = "Turn freely", .words = "camera, trackball, rotate, arcball"},
    {.action = "Undo", .words = "back, revert"},
    {.action = "Redo", .words = "again, repeat"},
    {.action = "New", .words = "empty, clear, document"},
    {.action = "Open...", .words = "load, file, import"},
    {.action = "Save", .words = "store, file, document"},
    {.action = "Save as...", .words = "store, file, copy, document"},
    {.action = "Save the picture...",
     .words = "screenshot, image, export, png, jpg, render, photo, print, poster"},
    {.action = "Save a film...",
     .words = "video, animation, movie, gif, mp4, turntable, export, record"},
    {.action = "Save the mesh...",
     .words = "3d print, stl, obj, ply, gltf, triangles, polygons, blender, export"},
    {.action = "Save a drawing...", .words = "svg, pdf, tikz, vector, latex, paper, lines, export"},
    {.action = "Go to the error", .words = "mistake, wrong, syntax error, next error, jump"},
    {.action = "Stop saving", .words = "cancel, abort, export"},
    {.action = "Copy the picture", .words = "screenshot, image, clipboard"},
    {.action = "Copy as text", .words = "clipboard"},
    {.action = "Copy as one line", .words = "share, link, send, clipboard"},
    {.action = "Paste", .words = "insert, clipboard, import"},
    {.action = "Presentation",
     .words = "slideshow, slide show, projector, lecture, class, teach, kiosk, large"},
    {.action = "Full screen", .words = "fullscreen, maximize, whole screen, monitor"},
    {.action = "Larger letters", .words = "font size, text size, zoom, bigger, scale, ui"},
    {.action = "Smaller letters", .words = "font size, text size, zoom, scale, ui"},
    {.action = "Letters as usual", .words = "font size, text size, zoom, reset, 100 %"},
    {.action = "Fold the panel", .words = "hide sidebar, side panel, show panel"},
    {.action = "Section: View", .words = "settings, options, quality, depth"},
    {.action = "Section: Clip", .words = "cut, box, sphere, plane, range, domain"},
    {.action = "Section: Space", .words = "axes, grid, up, directions"},
    {.action = "Section: Look", .words = "colour, color, material, settings"},
    {.action = "Section: Light", .words = "lamp, sun, brightness, background, material"},
    {.action = "Section: Markers", .words = "points, coordinates, distance, measure"},
    {.action = "Section: Advanced", .words = "tracer, compare, algorithm, settings"},
    {.action = "Light theme", .words = "dark theme, dark mode, night, bright"},
    {.action = "Theme of the desktop", .words = "dark mode, light mode, system theme"},
    {.action = "Language of the desktop", .words = "locale, translation, english, system"},
    {.action = "Language: English", .words = "locale, translation"},
    {.action = "Language: German", .words = "deutsch, sprache, locale, translation"},
    {.action = "Language: French",
     .words = "fran\xC3\xA7"
              "ais, langue, locale, translation"},
    {.action = "Language: Spanish", .words = "espa\xC3\xB1ol, idioma, locale, translation"},
    {.action = "Gallery", .words = "examples, surfaces, samples, library"},
    {.action = "Find a command...", .words = "search, palette"},
    {.action = "Help", .words = "keys, shortcuts, manual, formulas, language, functions"},
    {.action = "Tour of the window", .words = "tutorial, introduction, guide, first steps, help"},
    {.action = "Quit", .words = "exit, close, end"},
});

}  // namespace

std::span<const OtherWords> other_words() { return word_table; }

std::string_view other_words_of(std::string_view action) {
    const auto* const found = std::ranges::find(word_table, action, &OtherWords::action);
    return found == word_table.end() ? std::string_view() : found->words;
}

}  // namespace zeroset::ui
