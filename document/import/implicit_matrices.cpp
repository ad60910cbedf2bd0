#include "document/import/implicit_matrices.hpp"

#include <array>
#include <cstddef>

// Nodes of matrices of the implicit extension of 3MF. An inverse is the adjugate, made of the
// minors of the upper two and the lower two rows, divided by the determinant.

namespace zeroset {
namespace {

constexpr std::size_t side = 4;

std::string at(const GraphValue& matrix, std::size_t row, std::size_t column) {
    return matrix[side * row + column];
}

const GraphValue* input(const GraphInputs& in, std::string_view name, std::size_t size) {
    const auto found = in.find(name);
    return found != in.end() && found->second.size() == size ? &found->second : nullptr;
}

GraphValue composed(const GraphInputs& in) {
    GraphValue matrix;
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column) {
            const std::string name = "m" + std::to_string(row) + std::to_string(column);
            const GraphValue* const element = input(in, name, 1);
            if (element == nullptr) return {};
            matrix.push_back((*element)[0]);
        }
    }
    return matrix;
}

/// Four vectors as rows, each with what the fourth column has: 0, 0, 0, 1.
GraphValue from_rows(const GraphInputs& in) {
    GraphValue matrix;
    for (const char* const name : {"A", "B", "C", "D"}) {
        const GraphValue* const row = input(in, name, 3);
        if (row == nullptr) return {};
        matrix.insert(matrix.end(), row->begin(), row->end());
        matrix.emplace_back(matrix.size() + 1 == side * side ? "1" : "0");
    }
    return matrix;
}

GraphValue transposed(const GraphValue& matrix) {
    GraphValue result;
    for (std::size_t i = 0; i < matrix.size(); ++i)
        result.push_back(at(matrix, i % side, i / side));
    return result;
}

GraphValue product(const GraphValue& matrix, const GraphValue& vector,
                   const NameExpression& named) {
    GraphValue result;
    for (std::size_t row = 0; row + 1 < side; ++row) {
        std::string sum;
        for (std::size_t i = 0; i < vector.size(); ++i)
            sum += at(matrix, row, i) + "*" + vector[i] + " + ";
        result.push_back(named(sum + at(matrix, row, 3)));
    }
    return result;
}

/// The minors of two rows, by their columns a < b.
using Minors = std::array<std::array<std::string, side>, side>;

Minors minors_of(const GraphValue& matrix, std::size_t first, const NameExpression& named) {
    Minors result;
    for (std::size_t a = 0; a < side; ++a) {
        for (std::size_t b = a + 1; b < side; ++b)
            result[a][b] = named(at(matrix, first, a) + "*" + at(matrix, first + 1, b) + " - " +
                                 at(matrix, first, b) + "*" + at(matrix, first + 1, a));
    }
    return result;
}

/// Three columns in order, without one.
std::array<std::size_t, 3> others(std::size_t column) {
    std::array<std::size_t, 3> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = i < column ? i : i + 1;
    return result;
}

GraphValue inverse(const GraphValue& matrix, const NameExpression& named) {
    const Minors upper = minors_of(matrix, 0, named);
    const Minors lower = minors_of(matrix, 2, named);
    const std::string determinant =
        named(upper[0][1] + "*" + lower[2][3] + " - " + upper[0][2] + "*" + lower[1][3] + " + " +
              upper[0][3] + "*" + lower[1][2] + " + " + upper[1][2] + "*" + lower[0][3] + " - " +
              upper[1][3] + "*" + lower[0][2] + " + " + upper[2][3] + "*" + lower[0][1]);
    GraphValue result;
    for (std::size_t row = 0; row < side; ++row) {
        const auto [a, b, c] = others(row);
        for (std::size_t column = 0; column < side; ++column) {
            // The cofactor of (column, row): its partner row, and the minors of the other two.
            const Minors& minors = column < 2 ? lower : upper;
            const std::size_t partner = column ^ 1U;
            const std::string cofactor = at(matrix, partner, a) + "*" + minors[b][c] + " - " +
                                         at(matrix, partner, b) + "*" + minors[a][c] + " + " +
                                         at(matrix, partner, c) + "*" + minors[a][b];
            const bool negative = (row + column) % 2 == 1;
            result.push_back(named((negative ? "-(" : "(") + cofactor + ")/" + determinant));
        }
    }
    return result;
}

}  // namespace

GraphValue matrix_value(std::string_view kind, const GraphInputs& in, const NameExpression& named) {
    if (kind == "composematrix") return composed(in);
    if (kind == "matrixfromrows") return from_rows(in);
    if (kind == "matrixfromcolumns") return transposed(from_rows(in));
    const GraphValue* const matrix = input(in, "A", side * side);
    if (matrix == nullptr) return {};
    if (kind == "transpose") return transposed(*matrix);
    if (kind == "inverse") return inverse(*matrix, named);
    // Files of drafts of the extension call it by its longer name.
    if (kind == "matvecmultiplication" || kind == "matrixvectormultiplication") {
        const GraphValue* const vector = input(in, "B", 3);
        if (vector != nullptr) return product(*matrix, *vector, named);
    }
    return {};
}

}  // namespace zeroset
