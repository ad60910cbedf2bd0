#include "papers/compare/printed_tables.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

// Each row: surface, tracer, d_stop, value. NOLINTBEGIN(modernize-use-designated-initializers)

// Epsilon 1e-3 and 2e-7 are d_stop 10 and 22 there.
constexpr std::array knoll_table_1{
    PrintedValue{"trilerp", "k-bisection", 10, 10.6},
    PrintedValue{"trilerp", "k-bisection", 22, 2.8},
    PrintedValue{"trilerp", "t-bisection", 10, 9.9},
    PrintedValue{"trilerp", "t-bisection", 22, 0.31},
    PrintedValue{"trilerp", "mitchell", 10, 1.20},
    PrintedValue{"trilerp", "mitchell", 22, 0.75},
    PrintedValue{"mitchell", "k-bisection", 10, 5.9},
    PrintedValue{"mitchell", "k-bisection", 22, 1.3},
    PrintedValue{"mitchell", "t-bisection", 10, 5.7},
    PrintedValue{"mitchell", "t-bisection", 22, 1.0},
    PrintedValue{"mitchell", "mitchell", 10, 0.61},
    PrintedValue{"mitchell", "mitchell", 22, 0.24},
};

constexpr std::array knoll_figure_9{
    PrintedValue{"torus", "k-bisection", 10, 22.9},
    PrintedValue{"sphere", "k-bisection", 10, 20.5},
    PrintedValue{"parabolic_cylinder", "k-bisection", 10, 34.1},
    PrintedValue{"hyperboloid", "k-bisection", 10, 19.2},
    PrintedValue{"steiner1", "k-bisection", 10, 6.1},
    PrintedValue{"steiner2", "k-bisection", 10, 17.2},
    PrintedValue{"mitchell", "k-bisection", 10, 5.9},
    PrintedValue{"tangle", "k-bisection", 10, 3.8},
    PrintedValue{"blobby", "k-bisection", 10, 4.7},
    PrintedValue{"absolute", "k-bisection", 10, 30.8},
    PrintedValue{"inverse", "k-bisection", 10, 20.8},
    PrintedValue{"teardrop", "k-bisection", 10, 15.3},
    PrintedValue{"planes", "k-bisection", 10, 33.0},
    PrintedValue{"klein", "k-bisection", 10, 6.0},
    PrintedValue{"linked_tori", "k-bisection", 10, 4.0},
    PrintedValue{"barth_sextic", "k-bisection", 10, 4.9},
};

constexpr std::array knoll_figure_7{
    PrintedValue{"trilerp", "k-bisection", 4, 24.4},
    PrintedValue{"trilerp", "k-bisection", 8, 13.6},
    PrintedValue{"trilerp", "k-bisection", 12, 7.1},
    PrintedValue{"trilerp", "k-bisection", 16, 4.2},
    PrintedValue{"mitchell", "k-bisection", 4, 20.9},
    PrintedValue{"mitchell", "k-bisection", 8, 9.1},
    PrintedValue{"mitchell", "k-bisection", 12, 4.3},
    PrintedValue{"mitchell", "k-bisection", 16, 2.4},
};

constexpr std::array knoll_figure_8{
    PrintedValue{"teardrop", "k-bisection", 10, 11.0},
    PrintedValue{"teardrop", "k-bisection", 14, 6.5},
};

// The threshold is not printed; "machine precision" is what the text recommends.
constexpr std::array florez_table_4_1{
    PrintedValue{"sphere", "mitchell", 22, 20},
    PrintedValue{"sphere", "newton", 22, 28},
    PrintedValue{"sphere", "alefeld-hansen", 22, 27},
    PrintedValue{"sphere", "mrfro", 22, 48},
    PrintedValue{"sphere", "mrfro-newton", 22, 55},
    PrintedValue{"teardrop", "mitchell", 22, 36},
    PrintedValue{"teardrop", "newton", 22, 47},
    PrintedValue{"teardrop", "alefeld-hansen", 22, 46},
    PrintedValue{"teardrop", "mrfro", 22, 103},
    PrintedValue{"teardrop", "mrfro-newton", 22, 96},
    PrintedValue{"chubs", "mitchell", 22, 98},
    PrintedValue{"chubs", "newton", 22, 94},
    PrintedValue{"chubs", "alefeld-hansen", 22, 92},
    PrintedValue{"chubs", "mrfro", 22, 188},
    PrintedValue{"chubs", "mrfro-newton", 22, 174},
    PrintedValue{"crosscap", "mitchell", 22, 80},
    PrintedValue{"crosscap", "newton", 22, 96},
    PrintedValue{"crosscap", "alefeld-hansen", 22, 99},
    PrintedValue{"crosscap", "mrfro", 22, 105},
    PrintedValue{"crosscap", "mrfro-newton", 22, 151},
    PrintedValue{"mitchell", "mitchell", 22, 240},
    PrintedValue{"mitchell", "newton", 22, 260},
    PrintedValue{"mitchell", "alefeld-hansen", 22, 202},
    PrintedValue{"mitchell", "mrfro", 22, 541},
    PrintedValue{"mitchell", "mrfro-newton", 22, 380},
    PrintedValue{"mcmullen_k3", "mitchell", 22, 102},
    PrintedValue{"mcmullen_k3", "newton", 22, 123},
    PrintedValue{"mcmullen_k3", "alefeld-hansen", 22, 110},
    PrintedValue{"mcmullen_k3", "mrfro", 22, 276},
    PrintedValue{"mcmullen_k3", "mrfro-newton", 22, 221},
    PrintedValue{"kusner_schmitt", "mitchell", 22, 75},
    PrintedValue{"kusner_schmitt", "newton", 22, 94},
    PrintedValue{"kusner_schmitt", "alefeld-hansen", 22, 86},
    PrintedValue{"kusner_schmitt", "mrfro", 22, 210},
    PrintedValue{"kusner_schmitt", "mrfro-newton", 22, 173},
};

// "Classic" is MRFro, as its times are those of table 4.1 (Gumdrop torus 545 and 541 s).
constexpr std::array florez_table_5_1{
    PrintedValue{"sphere", "mrfro", 22, 53.22},
    PrintedValue{"sphere", "florez-trimming", 22, 41.46},
    PrintedValue{"blobby", "mrfro", 22, 107.59},
    PrintedValue{"blobby", "florez-trimming", 22, 64.17},
    PrintedValue{"steiner1", "mrfro", 22, 152.63},
    PrintedValue{"steiner1", "florez-trimming", 22, 94.43},
    PrintedValue{"mitchell", "mrfro", 22, 544.95},
    PrintedValue{"mitchell", "florez-trimming", 22, 381.62},
};
// Tables 5.2 and 5.3.
constexpr std::array florez_boxes_5_1{
    PrintedBoxes{"sphere", 0.79, 92, 33105, 648, 57496, 12.54, 40.67, 0, 0},
    PrintedBoxes{"blobby", 1.33, 171, 59204, 350, 31397, 44.74, 62.84, 0, 0},
    PrintedBoxes{"steiner1", 1.59, 132, 46958, 488, 43643, 59.79, 92.84, 0, 0},
    PrintedBoxes{"mitchell", 3.6, 156, 33087, 648, 57514, 166.93, 378.02, 0, 0},
};

constexpr std::array florez_table_5_4{
    PrintedValue{"orthocircle", "mrfro", 22, 60 * 21.1},
    PrintedValue{"orthocircle", "florez-boxes", 22, 60 * 8.8},
    PrintedValue{"blobby", "mrfro", 22, 60 * 35.6},
    PrintedValue{"blobby", "florez-boxes", 22, 60 * 11.6},
    PrintedValue{"teardrop", "mrfro", 22, 60 * 106.0},
    PrintedValue{"teardrop", "florez-boxes", 22, 60 * 35.0},
};
constexpr std::array florez_boxes_5_4{
    PrintedBoxes{"orthocircle", 0, 0, 0, 0, 0, 0, 0, 68631, 375003},
    PrintedBoxes{"blobby", 0, 0, 0, 0, 0, 0, 0, 58273, 414406},
    PrintedBoxes{"teardrop", 0, 0, 0, 0, 0, 0, 0, 460495, 1620000},
};

// The column of one processor: boxes of 0.025 of the screen are rejected, and rays traced in
// others.
constexpr std::array florez_table_7_1{
    PrintedValue{"orthocircle", "florez-trimming", 22, 119},
    PrintedValue{"steiner1", "florez-trimming", 22, 318},
    PrintedValue{"barth_sextic", "florez-trimming", 22, 2210},
};

constexpr std::array florez_table_7_16{
    PrintedValue{"sphere", "mrf", 22, 300},
    PrintedValue{"kusner_schmitt", "mrf", 22, 720},
    PrintedValue{"tangle", "mrf", 22, 900},
    PrintedValue{"mitchell", "mrf", 22, 1080},
};

// Figure 6.2 has pictures alone.
constexpr std::array florez_csg_surfaces{
    PrintedSurface{"lens", "max((x - 0.5)^2 + y^2 + z^2 - 1, (x + 0.5)^2 + y^2 + z^2 - 1)", 1.5},
    PrintedSurface{"bitten_ball",
                   "max(x^2 + y^2 + z^2 - 1.44, 0.49 - (x - 0.7)^2 - (y + 0.7)^2 - "
                   "(z - 0.5)^2)",
                   1.5},
    PrintedSurface{"eight_balls",
                   "min(min(min((x-0.6)^2+(y-0.6)^2+(z-0.6)^2, (x+0.6)^2+(y-0.6)^2+(z-0.6)^2), "
                   "min((x-0.6)^2+(y+0.6)^2+(z-0.6)^2, (x+0.6)^2+(y+0.6)^2+(z-0.6)^2)), "
                   "min(min((x-0.6)^2+(y-0.6)^2+(z+0.6)^2, (x+0.6)^2+(y-0.6)^2+(z+0.6)^2), "
                   "min((x-0.6)^2+(y+0.6)^2+(z+0.6)^2, (x+0.6)^2+(y+0.6)^2+(z+0.6)^2))) = 0.25",
                   1.5},
    PrintedSurface{"drilled_cube",
                   "max(max(|x|, |y|, |z|) - 1, 0.25 - x^2 - y^2, 0.25 - y^2 - z^2, "
                   "0.25 - z^2 - x^2, x^2 + y^2 + z^2 - 1.9)",
                   1.5},
    PrintedSurface{"cut_tangle",
                   "max(x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8, x^2 + y^2 + z^2 - 6, "
                   "0.5 - x^2 - y^2)",
                   3.0},
    PrintedSurface{"joined_klein",
                   "min((x^2+y^2+z^2+2y-1) ((x^2+y^2+z^2-2y-1)^2-8z^2) + 16x z (x^2+y^2+z^2-2y-1), "
                   "max(x^2 + z^2 - 0.5, |y| - 4))",
                   5.0},
};
constexpr std::array florez_csg{
    PrintedValue{"lens", "mrfro", 22, 0},
    PrintedValue{"lens", "csg-by-roots", 22, 0},
    PrintedValue{"bitten_ball", "mrfro", 22, 0},
    PrintedValue{"bitten_ball", "csg-by-roots", 22, 0},
    PrintedValue{"eight_balls", "mrfro", 22, 0},
    PrintedValue{"eight_balls", "csg-by-roots", 22, 0},
    PrintedValue{"drilled_cube", "mrfro", 22, 0},
    PrintedValue{"drilled_cube", "csg-by-roots", 22, 0},
    PrintedValue{"cut_tangle", "mrfro", 22, 0},
    PrintedValue{"cut_tangle", "csg-by-roots", 22, 0},
    PrintedValue{"joined_klein", "mrfro", 22, 0},
    PrintedValue{"joined_klein", "csg-by-roots", 22, 0},
};

constexpr std::array stolte_surfaces{
    PrintedSurface{"spheres",
                   "x^2 + y^2 + z^2 = 1; (x - 1.2)^2 + y^2 + z^2 = 0.25; "
                   "(x + 1.2)^2 + y^2 + z^2 = 0.25; x^2 + (y - 1.2)^2 + z^2 = 0.25; "
                   "x^2 + (y + 1.2)^2 + z^2 = 0.25; x^2 + y^2 + (z - 1.2)^2 = 0.25",
                   2.0},
};
constexpr std::array stolte_table_1{
    PrintedValue{"spheres", "gargantini", 30, 15.516, 0},
    PrintedValue{"spheres", "octree-unrounded", 30, 15.235, 0},
    PrintedValue{"spheres", "octree", 30, 19.860, 0},
    PrintedValue{"spheres", "gargantini", 30, 21.672, 5},
    PrintedValue{"spheres", "octree-unrounded", 30, 20.687, 5},
    PrintedValue{"spheres", "octree", 30, 27.062, 5},
    PrintedValue{"quartdef", "gargantini", 30, 26.109, 0},
    PrintedValue{"quartdef", "octree-unrounded", 30, 24.719, 0},
    PrintedValue{"quartdef", "octree", 30, 31.891, 0},
    PrintedValue{"quartdef", "gargantini", 30, 37.609, 5},
    PrintedValue{"quartdef", "octree-unrounded", 30, 35.140, 5},
    PrintedValue{"quartdef", "octree", 30, 45.281, 5},
    PrintedValue{"tangle", "gargantini", 30, 30.719, 0},
    PrintedValue{"tangle", "octree-unrounded", 30, 28.813, 0},
    PrintedValue{"tangle", "octree", 30, 37.531, 0},
    PrintedValue{"tangle", "gargantini", 30, 46.437, 5},
    PrintedValue{"tangle", "octree-unrounded", 30, 43.015, 5},
    PrintedValue{"tangle", "octree", 30, 56.078, 5},
    PrintedValue{"holesrot", "gargantini", 30, 30.469, 0},
    PrintedValue{"holesrot", "octree-unrounded", 30, 29.313, 0},
    PrintedValue{"holesrot", "octree", 30, 37.937, 0},
    PrintedValue{"holesrot", "gargantini", 30, 43.719, 5},
    PrintedValue{"holesrot", "octree-unrounded", 30, 41.313, 5},
    PrintedValue{"holesrot", "octree", 30, 53.500, 5},
    PrintedValue{"asterisk_3_4", "gargantini", 30, 113.875, 0},
    PrintedValue{"asterisk_3_4", "octree-unrounded", 30, 109.546, 0},
    PrintedValue{"asterisk_3_4", "octree", 30, 118.750, 0},
    PrintedValue{"asterisk_3_4", "gargantini", 30, 204.327, 5},
    PrintedValue{"asterisk_3_4", "octree-unrounded", 30, 193.233, 5},
    PrintedValue{"asterisk_3_4", "octree", 30, 209.608, 5},
    PrintedValue{"asterisk_9_18", "gargantini", 30, 135.390, 0},
    PrintedValue{"asterisk_9_18", "octree-unrounded", 30, 129.312, 0},
    PrintedValue{"asterisk_9_18", "octree", 30, 140.562, 0},
    PrintedValue{"asterisk_9_18", "gargantini", 30, 435.638, 5},
    PrintedValue{"asterisk_9_18", "octree-unrounded", 30, 410.841, 5},
    PrintedValue{"asterisk_9_18", "octree", 30, 445.982, 5},
};

constexpr std::array tables{
    PrintedTable{.name = "knoll-table-1",
                 .source = "Knoll et al. 2007, table 1",
                 .machine = "Intel Core Duo 2.16 GHz, SSE, 2 x 2 packets",
                 .note = "the trilinear patch has coefficients of its own, as those in the paper "
                         "are not printed",
                 .unit = PrintedUnit::FramesPerSecond,
                 .size_px = 512,
                 .values = knoll_table_1},
    PrintedTable{.name = "knoll-figure-9",
                 .source = "Knoll et al. 2007, figure 9",
                 .machine = "Intel Core Duo 2.16 GHz, SSE, 2 x 2 packets",
                 .note = "the blobby has centres and radii of its own, as those in the paper are "
                         "not printed",
                 .unit = PrintedUnit::FramesPerSecond,
                 .size_px = 512,
                 .values = knoll_figure_9},
    PrintedTable{.name = "knoll-figure-7",
                 .source = "Knoll et al. 2007, figure 7",
                 .machine = "Intel Core Duo 2.16 GHz, SSE, 2 x 2 packets",
                 .note = "the trilinear patch has coefficients of its own, as those in the paper "
                         "are not printed",
                 .unit = PrintedUnit::FramesPerSecond,
                 .size_px = 512,
                 .values = knoll_figure_7},
    PrintedTable{.name = "knoll-figure-8",
                 .source = "Knoll et al. 2007, figure 8",
                 .machine = "Intel Core Duo 2.16 GHz, SSE, 2 x 2 packets",
                 .note = "its view is not that of figure 9, where the same surface has 15.3 frames "
                         "a second",
                 .unit = PrintedUnit::FramesPerSecond,
                 .size_px = 512,
                 .values = knoll_figure_8},
    PrintedTable{.name = "florez-table-4.1",
                 .source = "Florez 2008, table 4.1",
                 .machine = "Pentium 4",
                 .note = "Drop is teardrop here, Gumdrop Torus is mitchell; Horned Cube (99, 180, "
                         "166, 272, 283 s) is left out, as its formula is not printed",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 300,
                 .values = florez_table_4_1},
    PrintedTable{.name = "florez-table-5.1",
                 .source = "Florez 2008, tables 5.1 to 5.3",
                 .machine = "Pentium 4 2.4 GHz",
                 .note = "Gumdrop Torus is mitchell here, Steiner steiner1; the classic method is "
                         "not named, its times are those of MRFro in table 4.1; the blobby has "
                         "centres and radii of its own",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 301,
                 .values = florez_table_5_1,
                 .boxes = florez_boxes_5_1},
    PrintedTable{.name = "florez-table-5.4",
                 .source = "Florez 2008, table 5.4",
                 .machine = "Pentium 4 2.4 GHz",
                 .note = "Drop is teardrop here; frames here have one ray a pixel, those printed "
                         "nine (with boxes one in included ones), to which the second table "
                         "comes back; the blobby has centres and radii of its own",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 300,
                 .values = florez_table_5_4,
                 .boxes = florez_boxes_5_4},
    PrintedTable{.name = "florez-table-7.1",
                 .source = "Florez 2008, table 7.1, the column of one processor",
                 .machine = "Opteron 2.6 GHz",
                 .note = "neither the size of its pictures nor the formula of its fourth surface "
                         "(Weird, 2634 s) is printed; --threads 2 is the column of two processors "
                         "(60, 161 and 1107 s)",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 300,
                 .values = florez_table_7_1},
    PrintedTable{.name = "florez-table-7.16",
                 .source = "Florez 2008, table 7.16, the column of the CPU",
                 .machine = "Xeon 3 GHz",
                 .note = "340 x 340 pixels of nine rays are 1020 x 1020 here; Gumdrop Torus is "
                         "mitchell, the interval bisection is mrf; the column of the GPU (2, 2, 3, "
                         "3 s) is of another kind of machine",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 1020,
                 .values = florez_table_7_16},
    PrintedTable{.name = "florez-figure-6.2",
                 .source = "Florez 2008, section 6.3 and figure 6.2: CSG",
                 .machine = "times are not printed",
                 .note = "what the figure shows is not printed: solids of our own; mrfro is CSG of "
                         "point sets in each subdivision of T, csg-by-roots that by roots of the "
                         "parts, in their order",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 300,
                 .values = florez_csg,
                 .surfaces = florez_csg_surfaces},
    PrintedTable{.name = "stolte-table-1",
                 .source = "Stolte 2005, table 1",
                 .machine = "Pentium 4 2.4 GHz",
                 .note = "30 levels, for tracers without levels d_stop 22; tanglecube is tangle "
                         "here; which spheres, views and lights is not printed: a ball with five "
                         "small ones, metal under two lights; mirrored rays are searched by forms",
                 .unit = PrintedUnit::Seconds,
                 .size_px = 512,
                 .values = stolte_table_1,
                 .surfaces = stolte_surfaces},
};
// NOLINTEND(modernize-use-designated-initializers)

}  // namespace

std::optional<double> PrintedTable::printed_ms(std::string_view surface, std::string_view tracer,
                                               int d_stop, int reflections) const {
    const auto found = std::ranges::find_if(values, [&](const PrintedValue& value) {
        return value.surface == surface && value.tracer == tracer && value.d_stop == d_stop &&
               value.reflections == reflections;
    });
    if (found == values.end() || found->value == 0.0) return std::nullopt;
    return unit == PrintedUnit::Seconds ? 1000.0 * found->value : 1000.0 / found->value;
}

bool PrintedTable::names(std::string_view surface, std::string_view tracer) const {
    return std::ranges::any_of(values, [&](const PrintedValue& value) {
        return value.surface == surface && value.tracer == tracer;
    });
}

const PrintedBoxes* PrintedTable::boxes_of(std::string_view surface) const {
    const auto found = std::ranges::find(boxes, surface, &PrintedBoxes::surface);
    return found == boxes.end() ? nullptr : &*found;
}

std::span<const PrintedTable> printed_tables() { return tables; }

const PrintedTable* find_printed_table(std::string_view name) {
    const auto found = std::ranges::find(tables, name, &PrintedTable::name);
    return found == tables.end() ? nullptr : &*found;
}

}  // namespace zeroset
