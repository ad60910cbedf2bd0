#pragma once

#include "engine/language/dialects/expressions.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {

/// Points of a grid in MATLAB and NumPy, whose names are those of x, y and z: [X, Y, Z] =
/// meshgrid(-2:0.1:2) and X, Y, Z = np.mgrid[-2:2:50j, ...]; and the surfaces that are found on
/// them: isosurface(X, Y, Z, V, 0), surf(X, Y, Z).
class Grids {
public:
    /// Writes with `writer`, and puts the ends of grids into `box`.
    Grids(ExpressionWriter& writer, AskedBox& box);

    /// Whether a statement makes a grid, so that its text is a program's.
    static bool makes_grid(std::string_view row);
    /// Whether a value is points on a line: -2:0.1:2, np.linspace(-2, 2, 50).
    static bool is_line(std::string_view value);
    /// Writes what a statement says of grids; false: nothing.
    bool write(std::string_view row);

private:
    using Ends = AskedRange;
    using GridArguments = std::vector<std::string_view>;

    [[nodiscard]] std::optional<Ends> ends_of(std::string_view argument) const;
    bool write_grid(std::string_view names, std::string_view call);
    bool write_surface(std::string_view row);
    void write_level(std::string_view values, std::string_view level);
    void write_heights(const GridArguments& places);
    [[nodiscard]] bool draws_points(const std::vector<std::string_view>& grid) const;
    bool write_parameters(const std::vector<std::string_view>& grid, const GridArguments& of);
    void remember_points(std::string_view name, std::string_view value);

    ExpressionWriter& writer_;
    AskedBox& box_;
    std::vector<std::pair<std::string_view, Ends>> points_;  ///< names of points on a line
    std::string parameters_;  ///< ranges of a grid whose points are parameters of a surface
    bool is_ahead_ = false;   ///< somewhere in the text a grid is made
    bool has_grid_ = false;
    int grid_count_ = 0;
};

}  // namespace zeroset
