#include "app/main/help.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace zeroset {
namespace {

constexpr std::array groups{
    HelpGroup{
        .name = "Often used",
        .about =
            R"(A picture, a film or a drawing shows what the window would show of the equation in the clip box.
`--fit` encloses the surface first and looks at all of it; where it is bounded and sticks out of the clip box, or is
smaller than a quarter of it, the clip box becomes a cube about it (a given `--box` stays). Without it that happens to
typed surfaces that are bounded and stick out, and graphs z = f(x, y) get a box as high as they are, unless an option
chooses box or view; a line on stderr says so. `--section` cuts by a plane
and keeps one side, up to six times: the solid that it cuts open, f < 0, is filled with a hatched cap in the surface's
colour. `--shadows` misses nothing that throws one, however thin. Edges are smooth: each pixel is weighed by the part that
a surface covers, by beams; `--aa none` leaves that out, 4, 9, 16 or 64 rays a pixel are there to compare with.
`--no-shadows` and its like switch off what a saved session has.)",
        .examples = R"(render "x^2 + y^2 + z^2 = 1" -o sphere.png
render @barth_sextic -o barth.png --size 1920x1080 --shadows
render "a = 2; x^2 + y^2 = a z, z < 1; x^2 + y^2 + (z-1)^2 = b" --set b=0.5 -o cup.png
render @barth_sextic --section y=0 --sphere 1.8 -o cut.png
render @barth_sextic --color-by gaussian-curvature -o curvature.png)",
        .options = "--help --output --size --set --box --fit --section --look "
                   "--color-by --shadows --aa"},
    HelpGroup{
        .name = "Camera",
        .about =
            R"(Without these the whole clip box is seen from a good direction. `--camera` takes one line, as the window
copies it. Parallel rays (`--projection orthographic`) leave the size of the point looked at. Where `--aspect` draws the
axes at scales of their own, `--eye` and `--look-at` are points of the formula, `--camera` is in lengths of the picture.)",
        .examples = R"(render @klein --eye 4,-3,2 --look-at 0,0,0 --fov 30 -o klein.png
render "x^2 + y^2 = z" --box 1,1.000000001,0,1e-9,1,1.000000001 -o deep.png)",
        .options = "--camera --view --eye --look-at --up --fov --projection --aspect"},
    HelpGroup{
        .name = "Clip",
        .about =
            R"(What is shown of the surfaces. Where f < 0 on most of each face of the box, as of `1 = x^2 + y^2 + z^2`, the solid
is f > 0; restrictions do not matter for that; `--solid` chooses the side. A cap is certified by the proved sign of f
where the ray enters. `--section-shows values` colours the plane by the numbers behind the surface, such as a scan's,
`values-in-cap` the caps alone: [volumes.md](volumes.md).)",
        .examples = R"(render 'scan = volume("ct.nrrd"); max(400 - scan(x, y, z), x)' -o cut.png)",
        .options = "--sphere --hollow --section-shows --section-map "
                   "--section-range --solid --surface-box --w"},
    HelpGroup{
        .name = "Light",
        .about =
            R"(Looks shade surfaces as papers do (`phong`), or make them of a material; `technical` adds lines at silhouettes,
creases and edges. Lights that are given take the place of the look's own. [light.md](light.md) says what is proved.)",
        .examples = R"(render @tangle --look metal --reflections 3 --shadows -o metal.png
render "x^2 + y^2 + z^2 = 4; x y z = 0.5" --opacity 1:0.3 --box 2.2 -o layers.png)",
        .options = "--antialias --light --reflections --opacity --absorption "
                   "--surface-look --background --alpha --tone"},
    HelpGroup{
        .name = "Colors",
        .about =
            R"(The scale's ends hold most of what the picture shows, unless `--color-range` sets them. Caps stay plain where
colours tell of curvature or gradient. `balance` suits signs, `cycle` angles.)",
        .examples = "",
        .options = "--color --color-range --color-map --no-legend"},
    HelpGroup{
        .name = "Lines",
        .about =
            R"(Contour lines are at even steps of a height, of the coordinates or of an expression; without a step there are some
ten of them on the surface (`--stats` tells the step). Axes, the box's edges and a grid on its floor are faint behind
the surface. Of drawings, [draw.md](draw.md) tells which lines there are and what is proved of them.)",
        .examples = R"(render @klein --contours "x^2 + y^2; step 0.5; width 2; labels" -o lines.png
render '(cos t, sin t, t/3), 0 < t < 20; x^2 + y^2 + z^2 = 4 and z = x y' --thickness 1:5px -o curves.png
draw @klein -o klein.pdf --hidden dash)",
        .options = "--contours --intersections --mark --thickness --textbook "
                   "--axes --axis-names --clip-box --grid --lines --hidden "
                   "--width draw:--background"},
    HelpGroup{
        .name = "Film",
        .about =
            R"(A film turns, changes parameters, or follows a way of the camera; [export.md](export.md) tells of formats, ways and
numbered pictures.)",
        .examples = R"(turntable @tangle -o tangle.mp4 --shadows
animate "x^2 + y^2 + z^2 = a" --sweep a=0.2..2 -o breath.gif)",
        .options = "--seconds --fps --frames --turn --axis --sweep --through "
                   "--through-views --end --ease --blur --shutter --frame-range "
                   "--resume"},
    HelpGroup{
        .name = "Mesh and volume",
        .about =
            R"(`mesh` writes closed triangle meshes to a tolerance, edges sharp, and says where their topology is proved to be the
surface's: [mesh.md](mesh.md). `sample` writes a formula on a grid: [volumes.md](volumes.md).)",
        .examples = R"(mesh @tangle -o tangle.stl
sample "x^2 + y^2 + z^2 - 1" --size 64 -o ball.nrrd)",
        .options = "mesh:--tolerance --triangles --wall mesh:--surface --open "
                   "--no-thin --implicit mesh:--depth"},
    HelpGroup{
        .name = "Files",
        .about =
            R"(A name's ending chooses what is written: [export.md](export.md). `--depth` writes a grayscale PFM (little endian, rows
from the bottom) with the distance from the eye along each pixel's ray (of parallel rays, from the plane across the
view through the eye), +inf where it hits nothing. `--certificate` writes a PNG of what is proved: green certified
(teal on a bracket wider than asked for), amber drawn but undecided, red undecided and not drawn, black proved empty
([certificates.md](certificates.md)). `--cost` writes one of how often the formula was evaluated for each pixel, from
dark (0.1) to pale (1000) by logarithms. `--stats` counts all of these, says how wide a certified pixel's bracket is
and what drawing and writing took. `--probe` tells of a pixel: the point to the digits of double, what of them is
proved, f, normal, distance and certificate.)",
        .examples = R"(render @klein -o klein.png --size 32768x32768 --dpi 300
render @klein -o klein.exr --depth klein.pfm --certificate proved.png --stats -
render "x^2 + y^2 + z^2 = 1" --probe 512,512)",
        .options = "--bits --dpi --quality --no-session --depth --certificate "
                   "--cost --stats --probe --json --plot --no-pictures "
                   "--quiet"},
    HelpGroup{
        .name = "Search",
        .about =
            R"(`--dstop` is how fine the search along each ray goes: cells of the clip box's edge times 2^-N. A picture takes 30
seconds at most, compiling included, or what `--budget` says; then what is not decided stays undecided, and one line
says how many pixels that are. `--jumps` draws also where f changes its sign in a jump, as `floor` and `if` make it,
without a root. [tracing.md](tracing.md) tells of the tracers.)",
        .examples =
            R"(render "sin(20 x y z) sin(30 x) sin(40 y) = 0.01" -o quick.png --budget 0.5)",
        .options = "--budget --threads --jumps --tracer --dstop --epsilon "
                   "--delta --levels --repeat"},
};

bool has_option(const HelpGroup& group, const std::string& name) {
    return (" " + std::string(group.options) + " ").contains(" " + name + " ");
}

/// The group of an option; nullptr: it is in none.
const HelpGroup* group_of(const std::string& subcommand, const std::string& option) {
    for (const std::string& name : {subcommand + ":" + option, option}) {
        const auto* const found = std::ranges::find_if(
            groups, [&](const HelpGroup& group) { return has_option(group, name); });
        if (found != groups.end()) return found;
    }
    return nullptr;
}

void group_options_of(CLI::App& app) {
    for (CLI::Option* const option : app.get_options()) {
        if (option->get_lnames().empty()) continue;
        const HelpGroup* const group =
            group_of(app.get_name(), "--" + option->get_lnames().front());
        if (group != nullptr) option->group(std::string(group->name));
    }
}

}  // namespace

std::span<const HelpGroup> help_groups() { return groups; }

void group_options(CLI::App& app) {
    group_options_of(app);
    for (CLI::App* const subcommand : app.get_subcommands({}))
        group_options_of(*subcommand);
}

}  // namespace zeroset
