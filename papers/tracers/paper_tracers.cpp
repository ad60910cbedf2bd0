#include "papers/tracers/paper_tracers.hpp"

#include "engine/render/tracers.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"
#include "papers/florez/cell_grid.hpp"
#include "papers/florez/florez_tracers.hpp"
#include "papers/octree/octree_space.hpp"
#include "papers/octree/octree_tracer.hpp"
#include "papers/tracers/csg_code.hpp"
#include "papers/voxels/voxel_tracers.hpp"

#include <array>

namespace zeroset {

namespace {

constexpr TracerNeeds octree_needs{.prepare = prepare_octree_tracer, .levels = max_levels};
constexpr TracerNeeds isosurface_needs{.refuses = no_isosurface};

constexpr std::array table{
    Tracer{.name = "t-bisection",
           .about = "bisection of packets of rays in their parameter (Knoll 2007)",
           .trace_tile = trace_tile_t_bisection},
    Tracer{.name = "mitchell",
           .about = "roots isolated by f and f' over intervals, then refined (Mitchell 1990)",
           .trace_tile = trace_tile_mitchell},
    Tracer{.name = "newton",
           .about = "interval Newton method along rays (Florez 2008, figure 4.7)",
           .trace_tile = trace_tile_newton},
    Tracer{.name = "alefeld-hansen",
           .about = "interval Newton method with the operator of Alefeld and Hansen "
                    "(Caprani 2000)",
           .trace_tile = trace_tile_alefeld_hansen},
    Tracer{.name = "mrf",
           .about = "interval bisection that looks at signs (Sanjuan-Estrada 2003)",
           .trace_tile = trace_tile_mrf},
    Tracer{.name = "mrfro",
           .about = "the same, f over intervals only between equal signs "
                    "(Sanjuan-Estrada 2003)",
           .trace_tile = trace_tile_mrfro},
    Tracer{.name = "mrfro-newton",
           .about = "mrfro with the interval Newton method (Florez 2008)",
           .trace_tile = trace_tile_mrfro_newton},
    Tracer{.name = "affine",
           .about = "bisection by reduced affine arithmetic along rays (Knoll 2009)",
           .trace_tile = trace_tile_affine},
    Tracer{.name = "lg",
           .about = "roots isolated by Lipschitz bounds along rays (Kalra and Barr 1989)",
           .trace_tile = trace_tile_lg},
    Tracer{.name = "sphere-tracing",
           .about = "steps as long as bounds of the slope allow (Hart 1996)",
           .trace_tile = trace_tile_sphere_tracing},
    Tracer{.name = "florez-boxes",
           .about = "boxes of the image that beams reject or include, then single rays "
                    "(Florez 2008, section 5.4)",
           .trace_tile = trace_tile_florez_boxes},
    Tracer{.name = "florez-trimming",
           .about = "the same with the rejection test alone (Florez 2008, section 5.4.2)",
           .trace_tile = trace_tile_florez_trimming},
    Tracer{.name = "regular-grid",
           .about = "a grid of cells walked by beams, then single rays (Florez 2008, section 6.2)",
           .trace_tile = trace_tile_regular_grid,
           .needs = {.prepare = prepare_cell_grid}},
    Tracer{.name = "csg-by-roots",
           .about = "min and max by the roots of their parts, one after another "
                    "(Florez 2008, section 6.3)",
           .trace_tile = trace_tile_csg_by_roots,
           .needs = {.read_formula = read_csg_parts, .prepare = prepare_csg_parts}},
    Tracer{.name = "point-sampling",
           .about = "marching with sign changes; proves nothing and misses roots",
           .trace_tile = trace_tile_point_sampling,
           .proves = false},
    Tracer{.name = "octree",
           .about = "an octree, in which surface and ray are voxelised together (Stolte 2005)",
           .trace_tile = trace_tile_octree,
           .needs = octree_needs},
    Tracer{.name = "octree-unrounded",
           .about = "the same without outward rounding of the ray",
           .trace_tile = trace_tile_octree_unrounded,
           .proves = false,
           .needs = octree_needs},
    Tracer{.name = "gargantini",
           .about = "the same with the ray's intersections with mid-planes (Gargantini 1993)",
           .trace_tile = trace_tile_gargantini,
           .proves = false,
           .needs = octree_needs},
    Tracer{.name = "midpoint",
           .about = "the middle of each voxel that holds the level (Marmitt 2004)",
           .trace_tile = trace_tile_voxels<VoxelMethod::Midpoint>,
           .proves = false,
           .needs = isosurface_needs},
    Tracer{.name = "linear",
           .about = "linear between where a ray enters and leaves a voxel (Marmitt 2004)",
           .trace_tile = trace_tile_voxels<VoxelMethod::Linear>,
           .proves = false,
           .needs = isosurface_needs},
    Tracer{.name = "neubauer",
           .about = "repeated linear interpolation in a voxel (Neubauer 2002)",
           .trace_tile = trace_tile_voxels<VoxelMethod::Neubauer>,
           .proves = false,
           .needs = isosurface_needs},
    Tracer{.name = "schwarze",
           .about = "all roots of a voxel's cubic by Cardano's formula (Schwarze 1990)",
           .trace_tile = trace_tile_voxels<VoxelMethod::Schwarze>,
           .proves = false,
           .needs = isosurface_needs},
    Tracer{.name = "marmitt",
           .about = "roots of a voxel's cubic apart by its extrema (Marmitt 2004)",
           .trace_tile = trace_tile_voxels<VoxelMethod::Marmitt>,
           .proves = false,
           .needs = isosurface_needs},
};

}  // namespace

void add_paper_tracers() { add_tracers(table); }

}  // namespace zeroset
