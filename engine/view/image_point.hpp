#pragma once

// Sizes of an image and points in it, each unit with a type of its own.

namespace zeroset {

/// Width and height of an image in pixels.
struct ImageSize {
    int width = 0, height = 0;

    bool operator==(const ImageSize&) const = default;
};

/// A point of an image in pixels from its upper left corner: to the right and downwards. The centre
/// of a pixel is at (i + 0.5, j + 0.5).
struct PixelPoint {
    double col = 0.0, row = 0.0;
};

/// The centre of a pixel.
constexpr PixelPoint pixel_centre(int col, int row) { return {.col = col + 0.5, .row = row + 0.5}; }

/// A way in an image, in heights of the image: to the right and upwards.
struct ViewShift {
    double x = 0.0, y = 0.0;

    bool operator==(const ViewShift&) const = default;
    constexpr ViewShift operator-() const { return {.x = -x, .y = -y}; }
};

/// A point of an image, in heights of the image from its centre: to the right and upwards.
struct ViewPoint {
    double x = 0.0, y = 0.0;

    bool operator==(const ViewPoint&) const = default;
    friend constexpr ViewShift operator-(const ViewPoint& a, const ViewPoint& b) {
        return {.x = a.x - b.x, .y = a.y - b.y};
    }
    friend constexpr ViewPoint operator+(const ViewPoint& a, const ViewShift& b) {
        return {.x = a.x + b.x, .y = a.y + b.y};
    }
    friend constexpr ViewPoint operator-(const ViewPoint& a, const ViewShift& b) {
        return {.x = a.x - b.x, .y = a.y - b.y};
    }
};

/// A point of the image in pixels.
constexpr PixelPoint pixel_point(const ViewPoint& at, const ImageSize& image) {
    return {.col = 0.5 * image.width + image.height * at.x,
            .row = 0.5 * image.height - image.height * at.y};
}

/// An image for what does not depend on the number of pixels: as high as the view, without width.
inline constexpr ImageSize unit_image{.width = 0, .height = 2};

}  // namespace zeroset
