#include "tests/support/csg_scenes.hpp"

#include "tests/support/random_numbers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace zeroset::test {
namespace {

/// A sphere with places on its side towards the eye; `seen`: whether no other sphere hides the
/// place.
struct Watched {
    CsgSphere sphere;
    std::array<glm::dvec3, 24> places;
    std::array<bool, 24> seen;
};

/// Whether the sphere lies between the eye and the place.
bool hides(const CsgSphere& sphere, const glm::dvec3& eye, const glm::dvec3& place) {
    const glm::dvec3 ray = place - eye;
    const double along = glm::dot(sphere.centre - eye, ray) / glm::dot(ray, ray);
    const glm::dvec3 nearest = eye + std::min(along, 1.0 - 1e-6) * ray;
    return along > 0 && glm::distance(nearest, sphere.centre) < sphere.radius;
}

Watched watched(const CsgSphere& sphere, const glm::dvec3& eye, RandomNumbers& random) {
    Watched result{sphere, {}, {}};
    for (glm::dvec3& place : result.places) {
        glm::dvec3 out{};
        do {
            out = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        } while (glm::length(out) > 1 || glm::length(out) < 0.1);
        if (glm::dot(out, eye - sphere.centre) < 0) out = -out;
        place = sphere.centre + 1.001 * sphere.radius * glm::normalize(out);
    }
    return result;
}

/// Marks the places that the sphere `by` hides; false where none is left to see.
bool still_seen(Watched& watched, const CsgSphere& by, const glm::dvec3& eye) {
    bool any = false;
    for (std::size_t i = 0; i < watched.places.size(); ++i) {
        watched.seen[i] = watched.seen[i] && !hides(by, eye, watched.places[i]);
        any = any || watched.seen[i];
    }
    return any;
}

/// Adds the sphere if something of every sphere can still be seen; returns whether it did.
bool add(std::vector<Watched>& all, Watched added, const glm::dvec3& eye) {
    added.seen.fill(true);
    for (const Watched& other : all) {
        if (!still_seen(added, other.sphere, eye)) return false;
    }
    std::vector<Watched> rest = all;
    for (Watched& other : rest) {
        if (!still_seen(other, added.sphere, eye)) return false;
    }
    all = std::move(rest);
    all.push_back(added);
    return true;
}

}  // namespace

std::string CsgSphere::text() const {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "(x%+.5f)^2+(y%+.5f)^2+(z%+.5f)^2-%.7f", -centre.x,
                  -centre.y, -centre.z, radius * radius);
    return text.data();
}

std::vector<CsgSphere> visible_spheres(int count, const glm::dvec3& eye) {
    RandomNumbers random(static_cast<std::uint64_t>(count));
    const double largest = std::min(0.9, 1.6 / std::sqrt(count));
    std::vector<Watched> all;
    while (all.size() < static_cast<std::size_t>(count)) {
        const double radius = largest * random.uniform(0.7, 1.0);
        const double reach = 1 - radius;
        const glm::dvec3 centre{random.uniform(-reach, reach), random.uniform(-reach, reach),
                                random.uniform(-reach, reach)};
        add(all, watched({centre, radius}, eye, random), eye);
    }
    std::vector<CsgSphere> spheres;
    for (const Watched& each : all)
        spheres.push_back(each.sphere);
    return spheres;
}

std::string combined(const std::string& function, const std::vector<CsgSphere>& parts) {
    if (parts.size() == 1) return parts.front().text();
    std::string text = function + "(";
    for (const CsgSphere& part : parts)
        text += (&part == parts.data() ? "" : ", ") + part.text();
    return text + ")";
}

}  // namespace zeroset::test
