#include "tests/support/library_references.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zeroset::test {
namespace {

using std::abs, std::atan2, std::cos, std::exp, std::floor, std::max, std::min, std::pow, std::sin,
    std::sqrt;
using std::numbers::pi;

double cut(double value, double limit = 10) { return min(limit, max(value, -limit)); }
double remainder_of(double a, double b) {
    const double rest = std::fmod(a, b);
    return rest < 0 ? rest + b : rest;
}
double triangle(double a) { return 2 * abs(a - std::round(a)); }
double square(double a) { return a * a; }
double cube(double a) { return a * square(a); }

FunctionReference field(FunctionReference f) {
    return [f](const Arguments& a) { return cut(a.p[0] * f(a)); };
}

/// A curve f of (x, y) that the three parameters from `first` on turn: f gets the turned point.
FunctionReference turned(std::size_t first, FunctionReference f) {
    return [=](Arguments a) {
        if (a.p[first] > 0) {
            const double out = sqrt(a.x * a.x + a.z * a.z) - a.p[first + 1];
            const double angle = a.p[first + 2] * pi / 180;
            const double x = out * cos(angle) - a.y * sin(angle);
            a.y = out * sin(angle) + a.y * cos(angle);
            a.x = x;
        }
        return f(a);
    };
}

double section(double a, double b, double kind) {
    if (kind == 1) return sqrt(a * a + b * b);
    if (kind == 0) return max(abs(a), abs(b));
    return pow(pow(abs(a), 2 / kind) + pow(abs(b), 2 / kind), kind / 2);
}

std::array<double, 3> ellipsoids(const Arguments& a) {
    const auto f = [&](double along, double b, double c) {
        return exp(-(along * along + b * b * a.p[0] + c * c * a.p[0]) * a.p[1]);
    };
    return {f(a.z, a.x, a.y), f(a.y, a.x, a.z), f(a.x, a.y, a.z)};
}

FunctionReference with_ellipsoids(double (*join)(std::array<double, 3>)) {
    return [=](const Arguments& a) { return a.p[3] - a.p[2] * join(ellipsoids(a)); };
}

/// The point (x, y) folded into a sector of the hexagon around its nearest centre.
std::array<double, 2> hexagon(double x, double y) {
    const double wide = sqrt(3.0);
    std::array near{abs(std::fmod(abs(x), wide) - wide / 2), abs(std::fmod(abs(y), 3) - 1.5)};
    const std::array far{wide / 2 - near[0], 1.5 - near[1]};
    if (std::hypot(near[0], near[1]) > std::hypot(far[0], far[1])) near = far;
    if (atan2(near[1], near[0]) < pi / 6) return near;
    return {cos(pi / 3) * near[0] + sin(pi / 3) * near[1],
            abs(cos(pi / 3) * near[1] - sin(pi / 3) * near[0])};
}

double helix1(Arguments a) {
    const double radius = std::hypot(a.x, a.z);
    const double turn = remainder_of(atan2(a.z, a.x) * a.p[0] + a.y * a.p[1] * a.p[0], 2 * pi) - pi;
    double along = turn / a.p[4] / (a.p[1] * a.p[0]);
    double across = radius - a.p[3];
    if (a.p[5] != 1) {
        const double angle = a.p[6] * pi / 180;
        const double turned_across = across * cos(angle) - along * sin(angle);
        along = across * sin(angle) + along * cos(angle);
        across = turned_across;
    }
    return min(a.p[3] + radius, section(across, along, a.p[5])) - a.p[2];
}

double helix2(Arguments a) {
    const double angle = a.y * a.p[1];
    const double dx = a.x - a.p[3] * cos(angle);
    const double dz = a.z - a.p[3] * sin(angle);
    return section(dx * cos(angle) + dz * sin(angle), dz * cos(angle) - dx * sin(angle), a.p[5]) -
           a.p[2];
}

double helical_torus(Arguments a) {
    const auto& p = a.p;
    const double out = std::hypot(a.x, a.z);
    const double around = atan2(a.x, a.z);
    const double tube = std::hypot(out - p[0], a.y);
    const double turn = remainder_of(around * p[1] + atan2(out - p[0], a.y) * p[2], 2 * pi) - pi;
    const double groove = atan2(turn * p[8], tube - p[5]);
    const double winding = sqrt(square(tube - p[5]) + turn * turn * p[6]);
    const double height = cos(groove * p[7] + around * p[9]) * p[3] + p[4];
    return -max(p[4] + p[5] - p[0] - out, height - min(winding, tube + p[5]));
}

double mesh(Arguments a) {
    const auto thread = [&](double place, double half, double height) {
        const double side = abs(remainder_of(place, 2 * half) - half) * a.p[2];
        return std::hypot(side, height * a.p[4]);
    };
    const double wave_z = cos(a.z * pi / a.p[1]) * a.p[3];
    const double wave_x = cos(a.x * pi / a.p[0]) * a.p[3];
    return min({thread(a.x, a.p[0], a.y - wave_z), thread(a.x - a.p[0], a.p[0], a.y + wave_z),
                thread(a.z, a.p[1], a.y + wave_x), thread(a.z - a.p[1], a.p[1], a.y - wave_x)});
}

double polytubes(Arguments a) {
    double radius = 0;
    for (int i = 4; i >= 0; --i)
        radius = radius * a.y + a.p[static_cast<std::size_t>(i) + 1];
    double nearest = 1e300;
    for (int i = 0; i < static_cast<int>(a.p[0]); ++i) {
        const double angle = 2 * pi / a.p[0] * i;
        nearest = min(nearest, std::hypot(a.x - radius * sin(angle), a.z - radius * cos(angle)));
    }
    return nearest;
}

double comma(Arguments a) {
    const double s = a.p[0];
    const double ring = sqrt(square(a.x + s / 4) + a.z * a.z);
    const double tail = cos(atan2(a.z, a.x) / 2) * s / 2 - std::hypot(ring - 0.75 * s, a.y);
    const double head = s / 2 - sqrt(square(a.x - s / 2) + a.z * a.z + a.y * a.y);
    return -max(min(a.z, tail), head);
}

double boy(Arguments a) {
    const double q = a.x * a.x + a.y * a.y;
    const double z = a.z;
    const double w = 1 - z;
    const double root = sqrt(2.0);
    return a.p[1] * (64 * cube(w) * cube(z) - 48 * w * w * z * z * (3 * q + 2 * z * z) +
                     12 * w * z *
                         (27 * q * q - 24 * z * z * q +
                          36 * root * a.y * z * (a.y * a.y - 3 * a.x * a.x) + 4 * pow(z, 4)) +
                     (9 * q - 2 * z * z) *
                         (-81 * q * q - 72 * z * z * q +
                          108 * root * a.x * z * (a.x * a.x - 3 * a.y * a.y) + 4 * pow(z, 4)));
}

/// The cyclide, by the terms of its polynomial.
double dupin(Arguments a) {
    const auto& p = a.p;
    const double x2 = a.x * a.x, y2 = a.y * a.y, z2 = a.z * a.z;
    const double inner = p[2] * p[2], dy2 = p[4] * p[4], k2 = p[5] * p[5];
    const double product =
        (inner - dy2 - square(p[3] + p[1])) * (inner - dy2 - square(p[3] - p[1]));
    const double difference = inner + p[1] * p[1] - dy2 - p[3] * p[3];
    double f = product * (x2 * x2 + y2 * y2 + z2 * z2);
    f += 2 * product * (x2 * y2 + x2 * z2 + y2 * z2);
    f += 2 * k2 * (difference * (2 * a.x * p[3] + 2 * a.y * p[4] - k2) - 4 * p[4] * inner * a.y) *
         (x2 + y2 + z2);
    const double along = p[3] * a.x + p[4] * a.y;
    f += 4 * k2 * k2 * along * (along - k2) + 4 * k2 * k2 * p[1] * p[1] * y2 + pow(k2, 4);
    return -f;
}

double spiral(Arguments a) {
    const double out = std::hypot(a.x, a.z) + a.p[0] * atan2(a.z, a.x) / (2 * pi);
    const double across = std::fmod(out, a.p[0]) - a.p[0] / 2;
    const double radius = sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
    return -min(a.p[2] - radius, a.p[1] - min(section(across, a.y, a.p[5]), radius));
}

double spiral_phase(Arguments a) {
    const double angle = atan2(a.y, a.x) + pi / 2;
    return a.z + std::hypot(a.x, a.y) + 2 * angle / (2 * pi);
}

double brick(Arguments a) {
    const double row = remainder_of((a.y + 0.5) / 3, 1);
    const auto gap = [](double place, double size, double shift) {
        return remainder_of((place + 0.5) / size + shift, 1) <= 0.5 / size;
    };
    const bool low = row <= 0.5;
    if (row <= 0.5 / 3) return 0;
    if (low && (gap(a.x, 8, 0) || gap(a.z, 4.5, 0.5))) return 0;
    return !low && (gap(a.x, 8, 0.5) || gap(a.z, 4.5, 0)) ? 0 : 1;
}

double cushion(Arguments a) {
    const double x2 = a.x * a.x, y2 = a.y * a.y, z = a.z, z2 = z * z;
    return z2 * x2 - z2 * z2 - 2 * z * x2 + 2 * z2 * z + x2 - z2 - square(x2 - z) - y2 * y2 -
           2 * x2 * y2 - y2 * z2 + 2 * y2 * z + y2;
}

double enneper(Arguments a) {
    const double z = abs(a.z) < 0.2 ? 0.2 : a.z;
    const double x2 = a.x * a.x, y2 = a.y * a.y, z2 = a.z * a.z;
    const double f = (y2 - x2) / (2 * z) + 2.0 / 9 * z2 + 2.0 / 3;
    const double g = (y2 - x2) / (4 * z) - 0.25 * (x2 + y2 + 8.0 / 9 * z2) + 2.0 / 9;
    return -(f * f * f - 6 * g * g);
}

#define ZEROSET_TERMS(f)                                                  \
    [](const Arguments& a) {                                              \
        [[maybe_unused]] const double x = a.x, y = a.y, z = a.z;          \
        [[maybe_unused]] const double x2 = x * x, y2 = y * y, z2 = z * z; \
        [[maybe_unused]] const auto& p = a.p;                             \
        return f;                                                         \
    }

// NOLINTNEXTLINE(readability-function-size): a table
References polynomials() {
    return {
        {"f_bicorn", field(ZEROSET_TERMS(y2 * (p[1] * p[1] - (x2 + z2)) -
                                         square(x2 + z2 + 2 * p[1] * y - p[1] * p[1])))},
        {"f_bifolia", field(ZEROSET_TERMS(-(square(x2 + y2 + z2) - p[1] * (x2 + z2) * y)))},
        {"f_boy_surface", field(boy)},
        {"f_crossed_trough", field(ZEROSET_TERMS(x2 * z2 - y))},
        {"f_cubic_saddle", field(ZEROSET_TERMS(-(x2 * x - y2 * y - z)))},
        {"f_cushion", field(cushion)},
        {"f_odd", field(cushion)},
        {"f_devils_curve", field(ZEROSET_TERMS(-(x2 * x2 + 2 * x2 * z2 - 0.36 * x2 - y2 * y2 +
                                                 0.25 * y2 + z2 * z2)))},
        {"f_dupin_cyclid", field(dupin)},
        {"f_enneper", field(enneper)},
        {"f_folium_surface",
         field(ZEROSET_TERMS((y2 + z2) * (1 + (p[2] - 4 * p[1]) * x) + x2 * (1 + p[2])))},
        {"f_glob", field(ZEROSET_TERMS(0.5 * pow(x, 5) + 0.5 * x2 * x2 - (y2 + z2)))},
        {"f_heart",
         field(ZEROSET_TERMS(-(cube(2 * x2 + y2 + z2 - 1) - 0.1 * x2 * z2 * z - y2 * z2 * z)))},
        {"f_hunt_surface", field(ZEROSET_TERMS(-(4 * cube(x2 + y2 + z2 - 13) +
                                                 27 * square(3 * x2 + y2 - 4 * z2 - 12))))},
        {"f_hyperbolic_torus",
         field(ZEROSET_TERMS(-(x2 * x2 + 2 * x2 * y2 - 2 * x2 * z2 + y2 * y2 - 2 * y2 * z2 +
                               z2 * z2 - 2 * (p[1] * p[1] + p[2] * p[2]) * (x2 - z2) +
                               2 * (p[1] * p[1] - p[2] * p[2]) * y2 +
                               square(p[1] * p[1] - p[2] * p[2]))))},
        {"f_kampyle_of_eudoxus",
         field(ZEROSET_TERMS(-(y2 + z2 - p[2] * p[2] * x2 * x2 + square(p[2] * p[1]) * x2)))},
        {"f_klein_bottle", field(ZEROSET_TERMS(-((x2 + y2 + z2 + 2 * y - 1) *
                                                     (square(x2 + y2 + z2 - 2 * y - 1) - 8 * z2) +
                                                 16 * x * z * (x2 + y2 + z2 - 2 * y - 1))))},
        {"f_kummer_surface_v1", field(ZEROSET_TERMS(-(x2 * x2 + y2 * y2 + z2 * z2 - x2 - y2 - z2 -
                                                      x2 * y2 - x2 * z2 - y2 * z2 + 1)))},
        {"f_kummer_surface_v2",
         field(ZEROSET_TERMS(-(x2 * x2 + y2 * y2 + z2 * z2 + p[1] * (x2 + y2 + z2) +
                               p[2] * (x2 * y2 + x2 * z2 + y2 * z2) + p[3] * x * y * z - 1)))},
        {"f_lemniscate_of_gerono", field(ZEROSET_TERMS(-(x2 * x2 - x2 + y2 + z2)))},
        {"f_mitre", field(ZEROSET_TERMS(-(4 * x2 * (x2 + y2 + z2) - y2 * (1 - y2 - z2))))},
        {"f_nodal_cubic", field(ZEROSET_TERMS(-(y2 * y + z2 * z - 6 * y * z)))},
        {"f_ovals_of_cassini",
         field(ZEROSET_TERMS(-(square(x2 + y2 + z2 + p[1] * p[1]) - p[3] * p[1] * p[1] * (x2 + z2) -
                               p[2] * p[2])))},
        {"f_paraboloid", field(ZEROSET_TERMS(-(x2 - y + z2)))},
        {"f_parabolic_torus",
         field(ZEROSET_TERMS(
             -(x2 * x2 + 2 * x2 * y2 - 2 * x2 * z - (p[1] * p[1] + p[2] * p[2]) * x2 + y2 * y2 -
               2 * y2 * z + (p[1] * p[1] - p[2] * p[2]) * y2 + z2 +
               (p[1] * p[1] + p[2] * p[2]) * z + square(p[1] * p[1] - p[2] * p[2]))))},
        {"f_pillow", field(ZEROSET_TERMS(x2 * x2 + y2 * y2 + z2 * z2 - (x2 + y2 + z2)))},
        {"f_piriform", ZEROSET_TERMS(-cut(p[0] * -(x2 * x2 - x2 * x + y2 + z2)))},
        {"f_quartic_cylinder",
         field(ZEROSET_TERMS(-((x2 + z2) * y2 + p[2] * p[2] * (x2 + z2) - square(p[1] * p[2]))))},
        {"f_quartic_paraboloid", field(ZEROSET_TERMS(-(x2 * x2 + z2 * z2 - y)))},
        {"f_quartic_saddle", field(ZEROSET_TERMS(-(x2 * x2 - z2 * z2 - y)))},
        {"f_steiners_roman", field(ZEROSET_TERMS(-(x2 * y2 + x2 * z2 + y2 * z2 + x * y * z)))},
        {"f_strophoid", field(ZEROSET_TERMS(-((p[2] - x) * (y2 + z2) - p[3] * p[3] * p[1] * x2 -
                                              p[3] * p[3] * x2 * x)))},
        {"f_torus2",
         field(ZEROSET_TERMS(-(square(x2 + y2 + z2) - 2 * (p[1] * p[1] + p[2] * p[2]) * (x2 + z2) +
                               2 * (p[1] * p[1] - p[2] * p[2]) * y2 +
                               square(p[1] * p[1] - p[2] * p[2]))))},
        {"f_torus_gumdrop",
         field(ZEROSET_TERMS(
             -(4 * (x2 * x2 + square(y2 + z2)) + 17 * x2 * (y2 + z2) - 20 * (x2 + y2 + z2) + 17)))},
        {"f_umbrella", field(ZEROSET_TERMS(-(x2 - y * z2)))},
        {"f_witch_of_agnesi", field(ZEROSET_TERMS(-(p[1] * (y - 1) + (x2 + z2) * y)))},
    };
}

References curves() {
    return {
        {"f_algbr_cyl1", turned(2, ZEROSET_TERMS(-cut(p[0] * -(x2 * abs(x) - x2 + y2), p[1])))},
        {"f_algbr_cyl2",
         turned(2, ZEROSET_TERMS(
                       cut(p[0] * -(2 * x2 * x2 - 3 * x2 * y + y2 - 2 * y2 * y + y2 * y2), p[1])))},
        {"f_algbr_cyl3",
         turned(2,
                ZEROSET_TERMS(cut(p[0] * -(x2 * x2 + x2 * y2 - 2 * x2 * y - x * y2 + y2), p[1])))},
        {"f_algbr_cyl4",
         turned(2, ZEROSET_TERMS(cut(
                       p[0] * -(x2 * x2 + y2 * y2 + 2 * x2 * y2 + 3 * x2 * y - y2 * y), p[1])))},
        {"f_devils_curve_2d",
         turned(3, field(ZEROSET_TERMS(-(x2 * (x2 - p[1] * p[1]) - y2 * (y2 - p[2] * p[2])))))},
        {"f_folium_surface_2d",
         turned(3, field(ZEROSET_TERMS(-(y2 * (1 + (p[2] - 4 * p[1]) * x) + x2 * (1 + p[2])))))},
        {"f_kampyle_of_eudoxus_2d",
         turned(3, field(ZEROSET_TERMS(
                       -(y2 - p[2] * p[2] * x2 * x2 + p[2] * p[2] * p[1] * p[2] * x2))))},
        {"f_lemniscate_of_gerono_2d",
         turned(3, field(ZEROSET_TERMS(-(y2 - square(p[2] * p[1]) * x2 + p[2] * p[2] * x2 * x2))))},
        {"f_piriform_2d", turned(4, field(ZEROSET_TERMS(-(y2 - p[1] * p[3] * p[3] * x2 * x -
                                                          p[2] * p[3] * p[3] * x2 * x2))))},
        {"f_strophoid_2d",
         turned(4, field(ZEROSET_TERMS(
                       -((p[2] - x) * y2 - p[3] * p[3] * p[1] * x2 - p[3] * p[3] * x2 * x))))},
        {"f_witch_of_agnesi_2d",
         turned(3, field(ZEROSET_TERMS(-(p[1] * p[1] * y + x2 * y - p[2]))))},
    };
}

References shapes() {
    const auto blob = [](const Arguments& a) {
        const auto part = [&](double x, double strength, double inverse) {
            const double r = (x * x + a.y * a.y + a.z * a.z) * inverse * inverse;
            return r > 1 ? 0 : strength * (1 - r) * (1 - r);
        };
        return -part(a.x + a.p[0] / 2, a.p[1], a.p[2]) - part(a.x - a.p[0] / 2, a.p[3], a.p[4]);
    };
    return {
        {"f_blob", blob},
        {"f_blob2", ZEROSET_TERMS(p[3] - p[2] * (exp(-(x2 + y2 + z2) * p[1]) +
                                                 exp(-(square(x - p[0]) + y2 + z2) * p[1])))},
        {"f_comma", comma},
        {"f_cross_ellipsoids", with_ellipsoids([](auto f) { return max({f[0], f[1], f[2]}); })},
        {"f_isect_ellipsoids", with_ellipsoids([](auto f) { return min({f[0], f[1], f[2]}); })},
        {"f_flange_cover", with_ellipsoids([](auto f) { return f[0] + f[1] + f[2]; })},
        {"f_spikes",
         [](const Arguments& a) {
             const auto f = ellipsoids(a);
             const double ball = exp(-(a.x * a.x + a.y * a.y + a.z * a.z) * a.p[3]) * a.p[4];
             return -(ball - f[0] - f[1] - f[2]) * a.p[2];
         }},
        {"f_spikes_2d",
         ZEROSET_TERMS(-(p[0] * cos(p[1] * x) * cos(p[2] * z) * exp(-p[3] * (x2 + z2)) - y))},
        {"f_helical_torus", helical_torus},
        {"f_helix1", helix1},
        {"fhelix1", helix1},
        {"f_helix2", helix2},
        {"fhelix2", helix2},
        {"f_hex_x", [](const Arguments& a) { return hexagon(a.x, a.y)[0]; }},
        {"f_hex_y", [](const Arguments& a) { return hexagon(a.x, a.y)[1]; }},
        {"f_mesh1", mesh},
        {"fmesh", mesh},
        {"f_poly4", ZEROSET_TERMS(sqrt(x2 + z2) - max(-5.0, p[0] + p[1] * y + p[2] * y2 +
                                                                p[3] * y2 * y + p[4] * y2 * y2))},
        {"f_polytubes", polytubes},
        {"f_quantum",
         ZEROSET_TERMS(-0.1 * (square(4 * (x2 + y2 + z2) * exp(-2 * sqrt(x2 + y2 + z2) / 3) *
                                      (3 * y2 / (x2 + y2 + z2) - 1)) -
                               12))},
        {"f_spiral", spiral},
        {"p_skeletal_int",
         ZEROSET_TERMS(cos(x) + cos(y) + cos(z) +
                       0.51 * (cos(x) * cos(y) + cos(y) * cos(z) + cos(z) * cos(x)) + 1.2)},
    };
}

References patterns() {
    const auto density = [](double distance) { return distance > 1 ? 0 : 1 - distance; };
    return {
        {"f_boxed",
         [=](const Arguments& a) { return density(max({abs(a.x), abs(a.y), abs(a.z)})); }},
        {"f_brick", brick},
        {"f_checker",
         ZEROSET_TERMS((static_cast<int>(floor(x) + floor(y) + floor(z)) & 1) == 1 ? 1.0 : 0.0)},
        {"f_cylindrical", [=](const Arguments& a) { return density(std::hypot(a.x, a.z)); }},
        {"f_planar", [=](const Arguments& a) { return density(abs(a.y)); }},
        {"f_spherical", [=](const Arguments& a) { return density(std::hypot(a.x, a.y, a.z)); }},
        {"f_gradientX", ZEROSET_TERMS(remainder_of(x, 1))},
        {"f_gradientY", ZEROSET_TERMS(remainder_of(y, 1))},
        {"f_gradientZ", ZEROSET_TERMS(remainder_of(z, 1))},
        {"f_leopard", ZEROSET_TERMS(square((sin(x) + sin(y) + sin(z)) / 3))},
        {"f_marble", ZEROSET_TERMS(triangle(x))},
        {"f_onion", ZEROSET_TERMS(std::fmod(sqrt(x2 + y2 + z2), 1))},
        {"f_ph", ZEROSET_TERMS(std::acos(y / sqrt(x2 + y2 + z2)))},
        {"f_r", ZEROSET_TERMS(std::hypot(x, y, z))},
        {"f_th", ZEROSET_TERMS(atan2(x, z))},
        {"f_radial", ZEROSET_TERMS(remainder_of(0.25 + (atan2(x, z) + pi) / (2 * pi), 1))},
        {"f_scallop_wave", ZEROSET_TERMS(abs(sin(x * z * pi) * y))},
        {"f_sine_wave", ZEROSET_TERMS(sin(x * z * pi) * y)},
        {"f_spiral1", [](const Arguments& a) { return triangle(spiral_phase(a)); }},
        {"f_spiral2",
         [](const Arguments& a) {
             return triangle(triangle(std::hypot(a.x, a.y)) + triangle(spiral_phase(a)));
         }},
        {"f_wood", ZEROSET_TERMS(triangle(std::hypot(x, y)))},
    };
}

}  // namespace

References library_references() {
    References all = polynomials();
    for (References part : {curves(), shapes(), patterns(), noise_references()})
        all.merge(part);
    return all;
}

}  // namespace zeroset::test
