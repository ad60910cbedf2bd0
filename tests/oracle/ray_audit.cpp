#include "tests/oracle/ray_audit.hpp"

#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"
#include "engine/rewrite/traceable.hpp"
#include "engine/volume/volume.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/input_error.hpp"
#include "tests/support/formulas.hpp"
#include "tests/support/oracle/random_surface.hpp"
#include "tests/support/oracle/ray_oracle.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <expected>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace zeroset::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest(const glm::dvec3& a) { return std::max({a.x, a.y, a.z}); }

/// Bound of a certified depth's distance from the first root (see engine/trace/tracer.hpp).
double depth_error(const AuditSurface& surface, const AuditSettings& settings,
                   const glm::dvec3& direction, double depth) {
    const Box& clip = surface.clip;
    if (settings.depth_bits > 0)
        return std::exp2(-settings.depth_bits) * clip.size() + 0x1p-24 * std::abs(depth);
    const double reach = largest(glm::max(glm::abs(clip.lo), glm::abs(clip.hi)));
    const double cell = std::max(clip.size() * std::exp2(-settings.d_stop), 0x1p-20 * reach);
    const double stretch = glm::length(direction) / largest(glm::abs(direction));
    return 4 * cell * stretch + 0x1p-21 * (std::abs(depth) + glm::length(surface.camera.eye));
}

std::string joined(std::initializer_list<double> numbers) {
    std::string text;
    for (const double value : numbers) {
        char one[40];
        std::snprintf(one, sizeof one, "%s%.17g", text.empty() ? "" : ",", value);
        text += one;
    }
    return text;
}

std::string joined(const glm::dvec3& a) { return joined({a.x, a.y, a.z}); }

constexpr RayAnswer passes_by{RayTruth::Empty, 0.0, 0.0, false};

/// A pixel of a picture, with what it claims.
struct Shown {
    Certificate certificate;
    double depth;
    double error;  ///< bound of the error of a certified depth
};

/// Compares a pixel with a known first root, which lies between the distances `first` and `last`
/// from the eye. Returns what is wrong, or an empty text.
std::string judge_hit(const Shown& shown, double first, double last, bool crosses,
                      AuditReport& report) {
    ++(crosses ? report.hit : report.touched);
    const auto root = [&] { return " (the first root is at " + joined({first}) + ")"; };
    if (shown.certificate == Certificate::Miss) return "a root, but reported empty" + root();
    if (shown.certificate == Certificate::Certified) {
        if (crosses) ++report.hit_certified;
        const bool near = shown.depth > first - shown.error && shown.depth < last + shown.error;
        return near ? "" : "certified at " + joined({shown.depth}) + root();
    }
    if (crosses && shown.depth == infinity) ++report.hit_not_drawn;
    if (crosses && shown.depth < infinity && shown.depth > last + shown.error) ++report.hit_behind;
    return "";
}

std::string judge(const Shown& shown, const RayAnswer& answer, double length, AuditReport& report) {
    ++report.rays;
    if (shown.certificate == Certificate::Miss && shown.depth != infinity) {
        return "reported empty, but with the depth " + joined({shown.depth});
    }
    switch (answer.truth) {
        case RayTruth::Unknown: ++report.unknown; return "";
        case RayTruth::Hit:
            return judge_hit(shown, answer.from * length, answer.to * length, answer.crosses,
                             report);
        case RayTruth::Empty: break;
    }
    ++report.empty;
    if (shown.certificate == Certificate::Undecided && shown.depth < infinity) ++report.empty_drawn;
    return shown.certificate == Certificate::Certified
               ? "no root, but certified at " + joined({shown.depth})
               : "";
}

RayOracle oracle_of(const AuditSurface& surface) {
    const auto program = read_formula(surface.equation, surface.files);
    if (!program) {
        ADD_FAILURE() << surface.equation << ": " << program.error().reason;
        return {parse("x").value(), std::vector<double>{0.0}};
    }
    std::vector<double> uniforms = std::vector<double>(program->parameters.size(), 1.0);
    uniforms.insert(uniforms.begin(), surface.w);
    return {program->surfaces.front(), uniforms};
}

/// Pixels whose right or lower neighbour differs in its certificate or by much in its depth.
std::vector<std::size_t> edge_pixels(const AuditSurface& surface, const Framebuffer& frame) {
    const auto differ = [&](std::size_t i, std::size_t k) {
        if (frame.certificate[i] != frame.certificate[k]) return true;
        const auto step = std::abs(static_cast<double>(frame.depth[i] - frame.depth[k]));
        return step > 0.05 * surface.clip.size();  // false where both are infinite
    };
    std::vector<std::size_t> edges;
    for (int row = 0; row + 1 < frame.height; ++row) {
        for (int col = 0; col + 1 < frame.width; ++col) {
            const std::size_t i = frame.index(col, row);
            if (differ(i, frame.index(col + 1, row)) || differ(i, frame.index(col, row + 1)))
                edges.push_back(i);
        }
    }
    return edges;
}

std::vector<std::size_t> chosen_pixels(const AuditSurface& surface, const AuditSettings& settings,
                                       const Framebuffer& frame) {
    const std::size_t all = frame.depth.size();
    std::vector<std::size_t> pixels(settings.rays == 0 ? all : settings.rays);
    std::iota(pixels.begin(), pixels.end(), 0U);
    if (settings.rays == 0) return pixels;
    RandomNumbers random(1);
    for (std::size_t& pixel : pixels)
        pixel = random.below(all);
    const std::vector<std::size_t> edges = edge_pixels(surface, frame);
    for (std::size_t i = 0; i < settings.edge_rays && !edges.empty(); ++i)
        pixels.push_back(edges[random.below(edges.size())]);
    return pixels;
}

std::expected<Formula, InputError> interpreted(const AuditSurface& surface, bool knows_fields) {
    auto program = read_formula(surface.equation, surface.files);
    if (!program) return std::unexpected(program.error());
    const Expr drawn = traceable(program->surfaces.front());
    Formula formula;
    formula.text = surface.equation;
    formula.program = std::make_shared<const Program>(std::move(*program));
    formula.surface_rows = {0};
    formula.drawn = {drawn};
    formula.kernels = {knows_fields ? kernel_with_level(drawn) : interpret(drawn)};
    formula.unrestricted = {{}};
    formula.code = CodeState::Interpreted;
    return formula;
}

std::string region_options(const AuditSurface& surface) {
    std::string text;
    if (surface.camera.projection == Projection::Orthographic) text += " --projection orthographic";
    if (const auto& ball = surface.region.ball)
        text += " --sphere " + joined(ball->centre) + "," + joined({ball->radius});
    for (const Section& section : surface.region.sections)
        text += " --section " + joined(section.normal) + "," + joined({section.offset});
    return surface.region.sections.empty() ? text : text + " --hollow";
}

/// Whether the oracles know the formula: parametric surfaces have no equation, and of noise and
/// blobs there is no enclosure but the engine's own (noise_oracle_test.cpp has exact roots of
/// them).
bool is_searched(const Expr& expr) {
    if (is_patch(expr)) return false;
    return std::ranges::all_of(expr.nodes(), [](const Node& node) {
        return node.op != Op::Field || dynamic_cast<const Volume*>(node.field.get()) != nullptr;
    });
}

}  // namespace

std::string command_line(const AuditSurface& surface, const AuditSettings& settings) {
    const Box& box = surface.clip;
    const std::string pixels = std::to_string(settings.size_px);
    return "zeroset render '" + surface.equation + "' --box " +
           joined({box.lo.x, box.hi.x, box.lo.y, box.hi.y, box.lo.z, box.hi.z}) + " --eye " +
           joined(surface.camera.eye) + " --look-at " + joined(surface.camera.look_at) + " --up " +
           joined(surface.camera.up) + " --fov " + joined({glm::degrees(surface.camera.fov_rad)}) +
           region_options(surface) + " --w " + joined({surface.w}) + " --size " + pixels + "x" +
           pixels + " --dstop " + joined({settings.d_stop}) + " --tracer " + settings.tracer +
           " --depth depth.pfm --certificate certificate.png";
}

std::vector<AuditSurface> gallery_surfaces() {
    std::vector<AuditSurface> result;
    for (const GalleryItem& item : gallery()) {
        const auto program = read_formula(item.equation);
        if (!program || program->surfaces.size() != 1) continue;
        if (!is_searched(program->surfaces.front())) continue;
        result.push_back({item.name, item.equation, item.clip, item.w,
                          item.camera.value_or(default_camera(item.clip))});
    }
    return result;
}

std::vector<AuditSurface> random_surfaces(std::size_t count, std::uint64_t seed) {
    constexpr std::array half_edges{1.0, 1.5, 2.0};
    std::vector<AuditSurface> result;
    for (std::size_t i = 0; i < count; ++i) {
        RandomNumbers random((seed << 32U) + i);
        const SurfaceFamily& family = surface_families()[i % surface_families().size()];
        const double half = half_edges.at(random.below(half_edges.size()));
        Camera camera = suite_camera(half);
        const double distance = random.one_in(6) ? 0.7 : random.uniform(1.5, 4);
        glm::dvec3 towards{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        towards.z += 0.01;  // never along the up direction
        towards.x += 0.02;
        camera.eye = distance * half * glm::normalize(towards);
        result.push_back({std::string(family.name) + " " + std::to_string(i),
                          random_surface(family, half, random), Box::cube(half), 0.0, camera});
    }
    return result;
}

std::vector<AuditSurface> cut_open(std::vector<AuditSurface> surfaces, std::uint64_t seed) {
    RandomNumbers random(seed);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        AuditSurface& surface = surfaces[i];
        const glm::dvec3 half = 0.5 * (surface.clip.hi - surface.clip.lo);
        const auto place = [&] {
            const glm::dvec3 share{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6),
                                   random.uniform(-0.6, 0.6)};
            return surface.clip.centre() + half * share;
        };
        if (i % 2 == 0) surface.camera.projection = Projection::Orthographic;
        if (i % 3 != 0) surface.region.ball = Ball{place(), random.uniform(0.4, 1.2) * half.x};
        for (std::size_t k = 0; k < i % 4; ++k) {
            const glm::dvec3 normal = place() - surface.clip.centre();
            surface.region.sections.push_back(
                make_section(normal, glm::dot(normal, place()), false));
        }
    }
    return surfaces;
}

AuditReport& AuditReport::operator+=(const AuditReport& other) {
    rays += other.rays;
    hit += other.hit;
    touched += other.touched;
    empty += other.empty;
    unknown += other.unknown;
    hit_certified += other.hit_certified;
    hit_not_drawn += other.hit_not_drawn;
    hit_behind += other.hit_behind;
    empty_drawn += other.empty_drawn;
    failures.insert(failures.end(), other.failures.begin(), other.failures.end());
    return *this;
}

std::string AuditReport::text() const {
    char line[300];
    std::snprintf(line, sizeof line,
                  "%zu rays: %zu hit (%zu certified, %zu not drawn, %zu behind), %zu touched, "
                  "%zu empty (%zu drawn), %zu unknown; %zu failures",
                  rays, hit, hit_certified, hit_not_drawn, hit_behind, touched, empty, empty_drawn,
                  unknown, failures.size());
    return line;
}

Framebuffer drawn(const AuditSurface& surface, const AuditSettings& settings) {
    Framebuffer frame(settings.size_px, settings.size_px);
    const auto formula = settings.interpreted ? interpreted(surface, settings.knows_fields)
                                              : compile_formula(surface.equation, surface.clip,
                                                                Precision::Float, surface.files);
    if (!formula) {
        ADD_FAILURE() << surface.equation << ": " << formula.error().reason;
        return frame;
    }
    TraceSettings trace;
    trace.tracer = settings.tracer;
    trace.stop.value = settings.d_stop;
    trace.threads = 1;
    Scene scene = make_scene(*formula, surface.clip, surface.w, {});
    scene.region = surface.region;
    render_frame(scene, surface.camera, trace, frame);
    return frame;
}

AuditReport audit(const AuditSurface& surface, const AuditSettings& settings,
                  const Framebuffer& frame) {
    AuditReport report;
    RayOracle oracle = oracle_of(surface);
    const ViewFrame view(surface.camera);
    for (const std::size_t i : chosen_pixels(surface, settings, frame)) {
        const int col = static_cast<int>(i) % frame.width;
        const int row = static_cast<int>(i) / frame.width;
        const glm::dvec3 direction =
            view.direction(pixel_centre(col, row), {.width = frame.width, .height = frame.height});
        const auto depth = static_cast<double>(frame.depth[i]);
        const Shown shown{frame.certificate[i], depth,
                          depth_error(surface, settings, direction, depth)};
        const auto question =
            ray_question(view, surface.clip, surface.region, col, row, frame.width, frame.height);
        const std::string wrong = judge(shown, question ? oracle.answer(*question) : passes_by,
                                        glm::length(direction), report);
        if (wrong.empty()) continue;
        report.failures.push_back(surface.name + ", pixel (" + std::to_string(col) + ", " +
                                  std::to_string(row) + "): " + wrong + "\n  " +
                                  command_line(surface, settings));
    }
    return report;
}

}  // namespace zeroset::test
