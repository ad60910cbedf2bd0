#include "engine/mesh/make_mesh.hpp"

#include "engine/mesh/cell_growth.hpp"
#include "engine/mesh/contour.hpp"
#include "engine/mesh/lattice.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/parts_apart.hpp"
#include "engine/mesh/star_proof.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

/// The level whose cells are no larger than the tolerance.
int depth_for(const Box& box, const MeshOptions& options) {
    if (options.depth > 0) return std::min(options.depth, CellTree::deepest_ever);
    const double levels = std::ceil(std::log2(root_edge * box.size() / options.tolerance));
    return static_cast<int>(std::clamp(levels, 4.0, double{CellTree::deepest_ever}));
}

/// The first fifths of the time that is left.
MeshWork fifths_of(const MeshOptions& options, int fifths) {
    return {.threads = options.threads, .limit = options.limit.share(fifths, 5)};
}

class MeshMaker {
public:
    MeshMaker(const MeshSolid& solid, const MeshOptions& options)
        : solid_(solid),
          options_(options),
          tree_(solid.box, depth_for(solid.box, options)),
          growth_(tree_, solid_,
                  {.tolerance = options.tolerance,
                   .most_cells = options.most_cells,
                   .most_uncertain = options.most_uncertain,
                   .work = fifths_of(options, 2)}),
          proving_(fifths_of(options, 3)),
          contouring_(fifths_of(options, 4)),
          work_{.threads = options.threads, .limit = options.limit} {}
    MadeMesh make();

private:
    void enter(MeshStage stage) const {
        if (options_.on_stage) options_.on_stage(stage);
    }
    /// Whether there is time and room for cells that the proof wants divided.
    [[nodiscard]] bool may_prove() const {
        return !growth_.is_cut() && !growth_.is_dense() && !proving_.limit.over();
    }
    void prove();
    void prove_changed();
    [[nodiscard]] std::vector<std::uint32_t> failed_cells() const;
    void divide_at_kinks();
    void contour();
    bool divide_coarse();
    std::vector<std::uint32_t> wanted_finer();
    [[nodiscard]] std::vector<std::uint32_t> divisible(std::vector<std::uint32_t> cells) const;
    void count_cells();
    void thin_mesh();
    void measure();

    const MeshSolid& solid_;
    const MeshOptions& options_;
    CellTree tree_;
    CellGrowth growth_;
    MeshWork proving_, contouring_, work_;  ///< until the end of each
    Lattice lattice_;
    StarProof proof_;
    StarProof proof_without_kinks_;   ///< before the lattice was divided at kinks or turned
    std::uint32_t proved_size_ = 0;   ///< the tree's size when stars were proved last
    std::uint32_t lattice_size_ = 0;  ///< and when the lattice was made, if it is as it was
    Contour contour_;
    MeshReport report_;
};

/// The cells that are to be divided for the proof's sake. Where the function is proved to rise and
/// only the levels between vertices do not, at edges of the solid, dividing helps a few times only:
/// edges look alike on all scales.
std::vector<std::uint32_t> MeshMaker::wanted_finer() {
    constexpr int most_tries = 1;
    std::vector<std::uint32_t> cells = proof_.unknown;
    for (const std::uint32_t cell : proof_.rough) {
        if (tree_[cell].tries++ < most_tries) cells.push_back(cell);
    }
    return divisible(std::move(cells));
}

/// The given cells that can be divided.
std::vector<std::uint32_t> MeshMaker::divisible(std::vector<std::uint32_t> cells) const {
    std::erase_if(cells, [&](std::uint32_t cell) { return tree_[cell].level >= tree_.deepest(); });
    return cells;
}

/// The cells about stars that the proof fails for.
std::vector<std::uint32_t> MeshMaker::failed_cells() const {
    std::vector<std::uint32_t> cells = proof_.rough;
    cells.insert(cells.end(), proof_.unknown.begin(), proof_.unknown.end());
    return cells;
}

/// Proves the stars anew that failed or have changed since.
void MeshMaker::prove_changed() {
    enter(MeshStage::Proving);
    std::vector<std::uint32_t> core = failed_cells();
    std::erase_if(core, [&](std::uint32_t cell) { return !tree_[cell].is_leaf(); });
    for (std::uint32_t cell = proved_size_; cell < tree_.size(); ++cell) {
        if (tree_[cell].is_leaf()) core.push_back(cell);
    }
    const Lattice lattice = make_lattice(tree_, tree_.touching(core), solid_, proving_);
    proof_ = prove_stars(tree_, lattice, core, proved_size_, proving_);
    proved_size_ = static_cast<std::uint32_t>(tree_.size());
}

/// Divides cells until the topology is proved or nothing more can be done; then edges that are too
/// sharp get tetrahedra along them.
void MeshMaker::prove() {
    enter(MeshStage::Proving);
    if (proved_size_ == 0) {
        lattice_ = make_lattice(tree_, solid_, proving_);
        proof_ = prove_stars(tree_, lattice_, proving_);
        lattice_size_ = proved_size_ = static_cast<std::uint32_t>(tree_.size());
    } else {
        proof_ = std::move(proof_without_kinks_);
        prove_changed();
    }
    for (auto cells = wanted_finer(); !cells.empty() && may_prove(); cells = wanted_finer()) {
        enter(MeshStage::Dividing);
        growth_.divide_uncertain(std::move(cells));
        if (proved_size_ < tree_.size()) prove_changed();
    }
    if (lattice_size_ < tree_.size()) {
        lattice_ = make_lattice(tree_, solid_, proving_);
        lattice_size_ = proved_size_;
        if (!proof_.failed.empty())
            proof_ = prove_stars(tree_, lattice_, failed_cells(), proved_size_, proving_);
    }
    proof_without_kinks_ = proof_;
    if (proof_.failed.empty() || proving_.limit.over()) return;
    lattice_size_ = 0;
    divide_at_kinks();
    if (proof_.unknown.empty()) return;
    if (simplify_unproved(tree_, proof_.unknown, proof_.failed, lattice_, proving_))
        proof_ = prove_stars(tree_, lattice_, proving_);
}

void MeshMaker::divide_at_kinks() {
    // The solid has neither pieces nor handles at its edges: what one lattice has more is false.
    std::optional<std::size_t> least;
    const std::vector<std::uint32_t> failed = proof_.failed;
    const std::vector<std::uint32_t> cells = failed_cells();
    const Lattice whole = lattice_;
    for (const int rings : {0, 3}) {
        Lattice divided = whole;
        if (!split_at_kinks(solid_, failed, rings, divided, proving_)) continue;
        if (!least) least = contour_complexity(whole);
        const std::size_t complexity = contour_complexity(divided);
        if (complexity > least) continue;
        StarProof proof = prove_stars(tree_, divided, cells, KeyIndex::none, proving_);
        if (complexity == least && proof.failed.size() >= proof_.failed.size()) continue;
        least = complexity;
        lattice_ = std::move(divided);
        proof_ = std::move(proof);
    }
}

void MeshMaker::contour() {
    enter(MeshStage::Contouring);
    contour_ = options_.thin ? make_coarse_contour(tree_, lattice_, proof_.unknown, solid_,
                                                   options_.tolerance, contouring_)
                             : make_contour(lattice_, solid_, contouring_);
    if (contouring_.limit.over()) return;
    const std::size_t vertices = contour_.mesh.vertices.size();
    sharpen_creases(solid_, lattice_.step, contour_, contouring_);
    add_features(tree_, lattice_, solid_, contour_, contouring_);
    split_creased_sides(solid_, lattice_.step, contour_, contouring_);
    report_.unchanged =
        !options_.thin && contour_.creases.empty() && contour_.mesh.vertices.size() == vertices;
}

/// Divides the cells of triangles that are too far from the surface; false: there are none.
bool MeshMaker::divide_coarse() {
    if (growth_.is_cut() || proving_.limit.over()) return false;
    const std::vector<float> far = deviations(solid_, contour_.mesh, contouring_);
    std::vector<std::uint32_t> cells;
    for (std::size_t i = 0; i < far.size(); ++i) {
        if (far[i] <= static_cast<float>(options_.tolerance)) continue;
        const Tetrahedron& tetrahedron = lattice_.tetrahedra[contour_.tetrahedra[i]];
        cells.insert(cells.end(), tetrahedron.cells.begin(), tetrahedron.cells.end());
    }
    std::erase_if(cells, [&](std::uint32_t cell) { return !tree_[cell].is_active(); });
    cells = divisible(std::move(cells));
    if (cells.empty()) return false;
    enter(MeshStage::Dividing);
    growth_.divide(std::move(cells));
    return true;
}

void MeshMaker::count_cells() {
    report_.cells = tree_.size();
    enum class State : std::uint8_t { Proved, Rough, Unknown };
    std::vector<State> states(tree_.size());
    for (const std::uint32_t cell : proof_.rough)
        states[cell] = State::Rough;
    for (const std::uint32_t cell : proof_.unknown)
        states[cell] = State::Unknown;
    int level = 0;
    for (std::size_t i = 0; i < tree_.size(); ++i) {
        const MeshCell& cell = tree_[i];
        if (!cell.is_leaf() || !cell.is_active()) continue;
        switch (states[i]) {
            case State::Proved: ++report_.proved; break;
            case State::Rough: ++report_.rough; break;
            case State::Unknown: ++report_.unproved; break;
        }
        level = std::max(level, int{cell.level});
    }
    MeshCell smallest;
    smallest.level = static_cast<std::uint8_t>(level);
    report_.smallest_cell = tree_.edge(smallest);
    report_.places = unproved_places(tree_, proof_.unknown);
    report_.rough_places = unproved_places(tree_, proof_.rough);
    report_.dense = growth_.is_dense();
    report_.cut = growth_.is_cut() || contouring_.limit.over();
    report_.isotopic = report_.unproved + report_.rough == 0 && !growth_.is_cut();
}

MadeMesh MeshMaker::make() {
    constexpr int most_rounds = 8;
    enter(MeshStage::Dividing);
    growth_.begin();
    for (int round = 0; round < most_rounds; ++round) {
        prove();
        contour();
        if (!divide_coarse()) break;
    }
    count_cells();
    thin_mesh();
    measure();
    if (options_.limit.cancelled()) return {};
    return {.mesh = std::move(contour_.mesh), .report = std::move(report_)};
}

/// Thins to the tolerance, and beyond it until no more triangles are left than wanted.
void MeshMaker::thin_mesh() {
    report_.thinned_from = contour_.mesh.triangles.size();
    report_.tolerance = options_.tolerance;
    const std::size_t most = options_.most_triangles;
    if (!options_.thin && (most == 0 || report_.thinned_from <= most)) return;
    enter(MeshStage::Thinning);
    ThinOptions how{.tolerance = options_.tolerance, .work = work_};
    if (options_.thin) thin(contour_.mesh, solid_, how);
    how.most_triangles = most;
    constexpr int most_rounds = 40;
    for (int i = 0; i < most_rounds && most > 0 && contour_.mesh.triangles.size() > most; ++i) {
        if (work_.limit.over()) break;
        how.tolerance *= 1.4;
        thin(contour_.mesh, solid_, how);
    }
    report_.tolerance = how.tolerance;
    report_.cut = report_.cut || work_.limit.over();
    if (contour_.mesh.triangles.size() < report_.thinned_from) report_.unchanged = false;
}

/// Measures how far the mesh is from the surface.
void MeshMaker::measure() {
    const std::vector<float> far = deviations(solid_, contour_.mesh, work_);
    for (const MeshVertex& vertex : contour_.mesh.vertices)
        report_.deviation = std::max(report_.deviation, double{vertex.error});
    for (std::size_t i = 0; i < far.size(); ++i) {
        report_.deviation = std::max(report_.deviation, double{far[i]});
        for (const std::uint32_t v : contour_.mesh.triangles[i]) {
            float& error = contour_.mesh.vertices[v].error;
            error = std::max(error, far[i]);
        }
    }
}

}  // namespace

MadeMesh make_mesh(const MeshSolid& solid, const MeshOptions& options) {
    const UpwardRegisters upward;
    if (options.most_triangles == 0 && options.thin) {
        if (const auto gap = gap_between_parts(solid, fifths_of(options, 1))) {
            if (auto made = mesh_of_parts(solid, options, *gap)) return std::move(*made);
        }
    }
    return MeshMaker(solid, options).make();
}

}  // namespace zeroset
