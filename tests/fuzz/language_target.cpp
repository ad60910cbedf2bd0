#include "tests/fuzz/language_target.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "jit/compile.hpp"
#include "tests/support/kernel_batch.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset::test {
namespace {

using Complaint = std::optional<std::string>;

constexpr std::size_t most_text_read_again =
    200'000;  // bytes, for the canonical texts of a program
constexpr std::size_t most_nodes_evaluated = 20'000;
constexpr std::size_t most_nodes_compiled = 60;
constexpr std::size_t compiled_one_in = 16;  // LLVM takes as long as all the rest for 100 texts

std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash;
}

Complaint about_error(const ParseError& error, std::string_view text) {
    if (error.offset > text.size()) return "the error's offset lies outside the text";
    if (error.reason.empty()) return "an error without a reason";
    for (const std::string& line : {error.reason, error.hint}) {
        if (line.find_first_of("\r\n") != std::string::npos) return "more than one line: " + line;
    }
    return std::nullopt;
}

/// Whether the graphs are equal except for the numbers of their parameters.
bool same_graph(const Expr& a, const Expr& b) {
    const auto same = [&](Node left, Node right) {
        if (left.op == Op::Variable && right.op == Op::Variable) {
            return variable_name(left.number, a.parameters()) ==
                   variable_name(right.number, b.parameters());
        }
        return left == right;
    };
    return std::ranges::equal(a.nodes(), b.nodes(), same);
}

/// Whether a canonical text cannot be read because it is larger than the text it was made of.
bool too_large(const ParseError& error) {
    return error.reason.contains("nested more than") || error.reason.contains("is longer than");
}

Complaint about_reading(const Expr& surface, const std::string& text) {
    if (text.ends_with("...")) return std::nullopt;
    const auto again = read_program(text);
    if (!again) {
        if (too_large(again.error())) return std::nullopt;
        return "the canonical text is refused: " + again.error().reason + ": " + text;
    }
    if (again->surfaces.size() != 1) return "the canonical text is no single surface: " + text;
    if (!same_graph(surface, again->surfaces.front())) {
        return "the canonical text has another graph: " + text + "\nwhich is read as " +
               again->readings.front().text;
    }
    return std::nullopt;
}

Complaint about_notes(const Reading& reading) {
    constexpr std::size_t longest_note = 500;  // one line for a person; names in it are any
    for (const std::string& note : reading.notes) {
        if (note.empty()) return "an empty note";
        if (note.find_first_of("\r\n") != std::string::npos) return "a note of more lines: " + note;
        if (note.size() > longest_note) return "a long note: " + note;
    }
    return std::nullopt;
}

Complaint about_readings(const Program& program) {
    std::size_t surface = 0;
    std::size_t length = 0;
    for (const Reading& reading : program.readings) {
        if (reading.text.find('\n') != std::string::npos) return "a reading of more than one line";
        if (const Complaint complaint = about_notes(reading)) return complaint;
        if (reading.kind != StatementKind::Surface) continue;
        const Expr& expr = program.surfaces[surface++];
        length += reading.text.size();
        if (length > most_text_read_again) continue;
        if (const Complaint complaint = about_reading(expr, reading.text)) return complaint;
    }
    if (surface != program.surfaces.size()) return "a surface without a reading";
    return std::nullopt;
}

/// A few boxes, followed by one point in each of them.
class BoxesAndPoints {
public:
    static constexpr std::size_t boxes = batch_multiple / 2;

    BoxesAndPoints(RandomNumbers& random, std::size_t uniforms) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < boxes; ++i) {
                const Interval<float> box = random_box(random);
                // Both ends are floats, so the float nearest to the point lies in the box, too.
                constexpr auto largest = static_cast<double>(std::numeric_limits<float>::max());
                const auto point =
                    static_cast<float>(std::clamp(random.point_in(box), -largest, largest));
                neg_lo_.at(axis).at(i) = box.neg_lo;
                hi_.at(axis).at(i) = box.hi;
                neg_lo_.at(axis).at(boxes + i) = -point;
                hi_.at(axis).at(boxes + i) = point;
            }
        }
        for (std::size_t i = 0; i < uniforms; ++i) {
            const double lo = random.uniform(-2, 2);
            uniforms_.set(i, lo, random.one_in(2) ? lo : lo + random.uniform());
        }
    }

    struct Ranges {
        std::array<float, batch_multiple> neg_lo{};
        std::array<float, batch_multiple> hi{};
        std::array<std::uint32_t, batch_multiple> continuous{};

        [[nodiscard]] bool nowhere(std::size_t i) const {
            return hi.at(i) == -std::numeric_limits<float>::infinity();
        }
    };

    [[nodiscard]] Ranges of(const Kernel& kernel) const {
        Ranges ranges;
        const UpwardRounding upward;
        kernel.in_float.range({batch_multiple,
                               {neg_lo_[0].data(), neg_lo_[1].data(), neg_lo_[2].data()},
                               {hi_[0].data(), hi_[1].data(), hi_[2].data()},
                               uniforms_.neg_lo_hi.data(),
                               ranges.neg_lo.data(),
                               ranges.hi.data(),
                               ranges.continuous.data()});
        return ranges;
    }

private:
    static Interval<float> random_box(RandomNumbers& random) {
        if (random.one_in(3)) return random.interval<float>();
        const auto lo = static_cast<float>(random.uniform(-3, 3));
        const auto size = static_cast<float>(random.uniform(0, 1) * random.uniform(0, 2));
        return {-lo, lo + size};
    }

    std::array<std::array<float, batch_multiple>, 3> neg_lo_{};
    std::array<std::array<float, batch_multiple>, 3> hi_{};
    Uniforms uniforms_;
};

/// Compares two kernels that claim to enclose f: `wide` over boxes, `narrow` at points of them.
Complaint about_inclusion(const BoxesAndPoints::Ranges& wide,
                          const BoxesAndPoints::Ranges& narrow) {
    for (std::size_t box = 0; box < BoxesAndPoints::boxes; ++box) {
        const std::size_t point = BoxesAndPoints::boxes + box;
        if (narrow.nowhere(point)) {
            if (wide.continuous.at(box) != 0) return "claimed defined where a point is not";
            continue;
        }
        if (narrow.continuous.at(point) == 0) continue;
        if (wide.nowhere(box)) return "claimed undefined where a point is defined";
        const bool below = narrow.hi.at(point) < -wide.neg_lo.at(box);
        const bool above = -narrow.neg_lo.at(point) > wide.hi.at(box);
        const bool two_sides = wide.neg_lo.at(box) < 0 && wide.hi.at(box) < 0;
        const bool point_of_two = narrow.neg_lo.at(point) < 0 && narrow.hi.at(point) < 0;
        const bool needs_both = two_sides != point_of_two;
        const bool outside =
            !(two_sides && point_of_two) && (needs_both ? below && above : below || above);
        if (outside) return "a point's value lies outside its box's range";
    }
    return std::nullopt;
}

Complaint about_machine_code(const Expr& expr, RandomNumbers& random) {
    const auto code = jit::compile(expr);
    if (!code) return "it does not compile: " + code.error().message;
    KernelBatch batch(random, batch_multiple);
    for (std::size_t i = 0; i < expr.parameters().size(); ++i)
        batch.uniforms.set(1 + i, random.uniform(-2, 2));
    if (batch.run(*code) == batch.run(interpret(expr))) return std::nullopt;
    return "machine code and interpreter differ: " + expr.canonical();
}

Complaint about_surface(const Expr& expr, std::uint64_t seed) {
    if (expr.nodes().size() > most_nodes_evaluated) return std::nullopt;
    RandomNumbers random(seed);
    const Expr tight = tightened(expr);
    const BoxesAndPoints sample(random, 1 + expr.parameters().size());
    const auto typed_ranges = sample.of(interpret(expr));
    const auto tight_ranges = sample.of(interpret(tight));
    for (const auto& wide : {typed_ranges, tight_ranges}) {
        for (const auto& narrow : {typed_ranges, tight_ranges}) {
            if (const Complaint wrong = about_inclusion(wide, narrow)) {
                return *wrong + ": " + expr.canonical() + "\ntightened: " + tight.canonical();
            }
        }
    }
    if (seed % compiled_one_in != 0 || tight.nodes().size() > most_nodes_compiled) {
        return std::nullopt;
    }
    return about_machine_code(tight, random);
}

}  // namespace

std::optional<std::string> complaint_about(std::string_view text) {
    if (const auto formula = parse(text); !formula) {
        if (const Complaint wrong = about_error(formula.error(), text)) return wrong;
    }
    const auto program = read_program(text);
    if (!program) return about_error(program.error(), text);
    if (const Complaint wrong = about_readings(*program)) return wrong;
    const std::size_t few = std::min<std::size_t>(program->surfaces.size(), 4);
    for (std::size_t i = 0; i < few; ++i) {
        if (auto wrong = about_surface(program->surfaces[i], hash_of(text) + i)) return wrong;
    }
    return std::nullopt;
}

}  // namespace zeroset::test
