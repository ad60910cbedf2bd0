#include "app/main/add_options.hpp"

#include "engine/render/tracers.hpp"

#include <cstdint>
#include <string>

namespace zeroset {
namespace {

/// All of them, the usual one first.
std::string names_of_tracers() {
    std::string names;
    for (const Tracer& tracer : tracers()) {
        const bool is_first = names.empty();
        names += (is_first ? "" : ", ") + std::string(tracer.name) + (is_first ? " (default)" : "");
    }
    return names;
}

void add_look_options(CLI::App& app, LookText& look) {
    add_color_options(app, look);
    add_value(app, "--contours", look.contours,
              "contour lines: height, xyz (the coordinates' grid), an expression, or none; then, "
              "each after a ;, step S, width W in pixels, of drawings in points, and labels");
    add_switch(app, "intersections", look.intersections, "draw lines where two surfaces meet");
    add_repeated(app, "--mark", look.marks,
                 "a marker at x,y,z; then, after a ;, label TEXT; may be repeated");
}

void add_light_options(CLI::App& app, LightText& light) {
    add_value(app, "--look", light.look,
              "standard (default), phong, matte, porcelain, metal, glass, clay or technical");
    add_repeated(app, "--light", light.lights,
                 "a light instead of the look's own: X,Y,Z towards it, or camera X,Y,Z (right, up, "
                 "back); then, each after a ;, power P, size DEGREES (soft shadows), color "
                 "#RRGGBB; up to four times");
    add_value(app, "--reflections", light.reflections,
              "how often a ray is mirrored, 0 (default) to 5");
    add_value(app, "--absorption", light.absorption,
              "how much of other colors solids swallow of what is seen through them, per unit of "
              "length (default 0)");
    add_value(app, "--background", light.background,
              "#RRGGBB, #RRGGBB,#RRGGBB from top to bottom, or default");
    add_value(app, "--tone", light.tone, "bright light: plain (default, cut off) or filmic");
}

}  // namespace

void add_equation(CLI::App& app, std::string& equation) {
    add_value(app, "EQUATION", equation,
              "the formula, @NAME, FILE.zeroset.json, a PNG of ours, zeroset:..., or -")
        ->required();
}

CLI::Option* add_switch(CLI::App& app, const std::string& name, std::optional<bool>& value,
                        const std::string& about) {
    const std::function<void(std::int64_t)> take = [&value](std::int64_t count) {
        value = count > 0;
    };
    return app.add_flag_function("--" + name + ",!--no-" + name, take, about);
}

void add_repeated(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                  const std::string& about) {
    app.add_option(name, values, about)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_color_options(CLI::App& app, LookText& look) {
    add_value(app, "--color-by", look.color_by,
              "what colors tell: plain, normal, height, depth, mean-curvature, "
              "gaussian-curvature, gradient, or an expression in x, y, z, w and the parameters");
    add_value(app, "--color-range", look.color_range,
              "the numbers at the ends of the colors: A,B, or auto (default)");
    add_value(app, "--color-map", look.color_map, "aurora, ember, balance, gray or cycle");
}

void add_parameters(CLI::App& app, std::vector<std::string>& set) {
    add_repeated(app, "--set", set,
                 "value of a parameter: NAME=VALUE (default 1); may be repeated");
}

void add_region_options(CLI::App& app, ViewText& view) {
    add_value(app, "--box", view.box, "clip box: L for [-L,L]^3, or x0,x1,y0,y1,z0,z1 (default 2)");
    add_value(app, "--sphere", view.sphere,
              "shows only what is in a sphere: R about the origin, or x,y,z,R");
    app.add_option("--section", view.sections,
                   "cuts by a plane and keeps one side: x<0.3, y>0, z=1 (the side away from the "
                   "eye), or nx,ny,nz,d for nx x + ny y + nz z <= d; may be repeated")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_repeated(app, "--solid", view.surfaces.solids,
                 "the side that is solid, which sections fill: f<0, f>0 or auto (default), of all "
                 "surfaces or of one: 2:f>0; may be repeated");
    add_repeated(
        app, "--surface-box", view.surfaces.boxes,
        "shows only what is in a box, as of --box, of all surfaces or of one: 2:0.5; may be "
        "repeated");
    add_value(app, "--w", view.w, "value of the variable w (default 0)");
    add_parameters(app, view.set);
    app.add_flag("--quiet", view.quiet, "no notes on what of the formula was read unusually");
}

void add_view_options(CLI::App& app, ViewText& view) {
    add_region_options(app, view);
    add_value(app, "--aspect", view.aspect,
              "how long one unit is drawn along x, y and z: 1:1:0.01, or auto (default: all alike, "
              "unless an edge of the box is ten times another)");
    auto* const saved = add_value(app, "--view", view.saved_view,
                                  "look from a saved view of the document: its name");
    add_value(app, "--camera", view.camera,
              "look from there: eye x,y,z, and each after a ;, look-at x,y,z, up x,y,z, and fov "
              "DEGREES or, for parallel rays, height H; as the window copies it")
        ->excludes(saved);
    add_value(app, "--eye", view.eye, "where the eye is: x,y,z");
    add_value(app, "--look-at", view.look_at, "the point looked at: x,y,z");
    add_value(app, "--up", view.up, "the direction that is up: x,y,z (default 0,0,1)");
    add_value(app, "--fov", view.fov, "vertical field of view in degrees (default 42)");
    add_value(app, "--projection", view.projection, "perspective (default) or orthographic");
    auto* const hollow =
        app.add_flag("--hollow", view.hollow, "do not fill the solids that sections cut open");
    add_value(app, "--section-shows", view.section_shows,
              "what is seen on all sections: cap, values (of what the surface is a level of), "
              "values-in-cap or nothing")
        ->excludes(hollow);
    add_value(app, "--section-map", view.section_map,
              "the colors of values on sections: gray (default), aurora, ember, balance or cycle");
    add_value(app, "--section-range", view.section_range,
              "the values at the ends of these colors: A,B, or auto (default)");
    add_repeated(app, "--opacity", view.surfaces.opacities,
                 "how opaque surfaces are, 0 to 1, all or one: 2:0.5; may be repeated");
    add_repeated(app, "--surface-look", view.surfaces.looks,
                 "look of a surface instead of the picture's, all or one: 2:metal; may be "
                 "repeated");
    add_repeated(app, "--color", view.surfaces.colors,
                 "color of a surface's front, all or one: 2:#D9763A; may be repeated");
    add_repeated(
        app, "--thickness", view.surfaces.thicknesses,
        "width of curves and points, in units, or in pixels: 3px; all or one: 2:3px; may be "
        "repeated");
    app.add_flag("--fit", view.fit,
                 "look at all of the surface; without --box the clip box follows it, too");
    add_look_options(app, view.look);
}

void add_trace_options(CLI::App& app, TraceText& trace) {
    add_value(app, "--tracer", trace.tracer, "how roots are found: " + names_of_tracers());
    auto* const d_stop =
        add_value(app, "--dstop", trace.d_stop,
                  "stop at cells of the clip box's edge times 2^-N (default 22, in the window 14)");
    auto* const epsilon = add_value(app, "--epsilon", trace.epsilon,
                                    "stop at boxes with a diagonal below E, world units");
    auto* const delta =
        add_value(app, "--delta", trace.delta, "stop where the enclosure of f is narrower than D");
    add_value(app, "--levels", trace.levels,
              "of the octree's tracers: halve the clip box N times, 10 to 53, in place of --dstop")
        ->excludes(d_stop)
        ->excludes(epsilon)
        ->excludes(delta);
    d_stop->excludes(epsilon)->excludes(delta);
    epsilon->excludes(delta);
    add_value(app, "--threads", trace.threads, "threads (default: all cores)");
    add_switch(app, "shadows", trace.shadows, "let the surfaces throw shadows");
    auto* const smooth = add_switch(app, "antialias", trace.antialias, "smooth edges: --aa iaa");
    add_value(app, "--aa", trace.aa,
              "smooth edges: iaa (default; exact, by beams), none, or 4, 9, 16, 64 rays a pixel")
        ->excludes(smooth);
    add_light_options(app, trace.light);
    add_switch(app, "jumps", trace.jumps, "draw also where f changes its sign in a jump");
    add_axes_options(app, trace);
}

void add_axes_options(CLI::App& app, TraceText& trace) {
    add_switch(app, "textbook", trace.textbook, "draw axes, clip box and grid");
    add_switch(app, "axes", trace.axes, "draw axes with numbers");
    add_value(app, "--axis-names", trace.axis_names, "names of the axes: X,Y,Z (default x,y,z)");
    add_switch(app, "clip-box", trace.clip_box, "draw the clip box's edges");
    add_switch(app, "grid", trace.grid, "draw a grid on the clip box's floor");
}

}  // namespace zeroset
