#pragma once

#include "engine/export/pictures/picture_writer.hpp"

#include <filesystem>
#include <memory>

// Writers of each kind of file, for picture_formats.hpp; the path was checked by check_writable.

namespace zeroset {

std::unique_ptr<PictureWriter> make_png_picture(const std::filesystem::path& path,
                                                const PictureOptions& options);
/// Colours in linear light, multiplied by alpha, and as named layers opacity, depth (along the ray,
/// +inf: a miss), position, normal, certificate (as the enum) and surface (counted from 0, 255: a
/// miss).
std::unique_ptr<PictureWriter> make_exr_picture(const std::filesystem::path& path,
                                                const PictureOptions& options);
std::unique_ptr<PictureWriter> make_jpeg_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options);
std::unique_ptr<PictureWriter> make_bmp_picture(const std::filesystem::path& path,
                                                const PictureOptions& options);
std::unique_ptr<PictureWriter> make_tga_picture(const std::filesystem::path& path,
                                                const PictureOptions& options);
/// Colours in linear light.
std::unique_ptr<PictureWriter> make_hdr_picture(const std::filesystem::path& path,
                                                const PictureOptions& options);
std::unique_ptr<PictureWriter> make_webp_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options);
std::unique_ptr<PictureWriter> make_tiff_picture(const std::filesystem::path& path,
                                                 const PictureOptions& options);

}  // namespace zeroset
