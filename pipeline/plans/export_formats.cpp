#include "pipeline/plans/export_formats.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/draw/files/formats.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/films/film_formats.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "engine/mesh/files/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <vector>

namespace zeroset {
namespace {

ExportFormat row_of(const PictureFormat& format) {
    return {.kind = ExportKind::Picture,
            .name = format.name,
            .ending = format.endings[0],
            .about = format.about,
            .bits = format.bits[1] == format.bits[0] ? std::array{format.bits[0], 0} : format.bits,
            .deep = format.bits[1] != format.bits[0],
            .alpha = format.alpha,
            .quality = format.lossy,
            .density = format.density,
            .missing = missing_part(format)};
}

ExportFormat row_of(const FilmFormat& format) {
    return {.kind = ExportKind::Film,
            .name = format.name,
            .ending = format.ending,
            .about = format.about,
            .alpha = format.alpha,
            .quality = format.lossy,
            .even = format.even,
            .missing = missing_encoder(encoder_of(format.codec))};
}

/// Numbered pictures of a film's frames.
ExportFormat frames_of(const PictureFormat& format) {
    ExportFormat row = row_of(format);
    row.kind = ExportKind::Film;
    row.about = marked("a picture for each frame, numbered");
    row.quality = row.density = false;
    row.numbered = true;
    return row;
}

ExportFormat row_of(const MeshFormat& format) {
    return {.kind = ExportKind::Mesh,
            .name = format.name,
            .ending = format.ending,
            .about = format.about};
}

ExportFormat row_of(const DrawingFormat& format) {
    return {.kind = ExportKind::Drawing,
            .name = format.name,
            .ending = format.ending,
            .about = format.about};
}

std::vector<ExportFormat> all_formats() {
    std::vector<ExportFormat> rows;
    for (const PictureFormat& format : picture_formats())
        rows.push_back(row_of(format));
    for (const FilmFormat& format : film_formats())
        rows.push_back(row_of(format));
    for (const PictureFormat& format : picture_formats())
        rows.push_back(frames_of(format));
    for (const MeshFormat& format : mesh_formats())
        rows.push_back(row_of(format));
    for (const DrawingFormat& format : drawing_formats())
        rows.push_back(row_of(format));
    return rows;
}

/// The command that writes files of a kind.
std::string_view command_of(ExportKind kind) {
    switch (kind) {
        case ExportKind::Picture: return "render";
        case ExportKind::Film: return "turntable";
        case ExportKind::Mesh: return "mesh";
        case ExportKind::Drawing: return "draw";
    }
    return "";
}

/// The endings of the files of a kind that are chosen.
template <class Chosen>
std::vector<std::string_view> endings_of(ExportKind kind, const Chosen& chosen) {
    std::vector<std::string_view> endings;
    for (const ExportFormat& format : export_formats()) {
        if (format.kind == kind && !format.numbered && chosen(format))
            endings.push_back(format.ending);
    }
    return endings;
}

bool can_be_written(const ExportFormat& format) { return format.missing.empty(); }

}  // namespace

std::span<const ExportFormat> export_formats() {
    // A table for each language, as what is missing is told in words.
    static std::mutex mutex;
    static std::map<Language, std::vector<ExportFormat>> tables;
    const std::scoped_lock lock(mutex);
    std::vector<ExportFormat>& table = tables[language()];
    if (table.empty()) table = all_formats();
    return table;
}

const ExportFormat* export_format_of(ExportKind kind, const std::filesystem::path& path) {
    std::string ending = lower_case(path.extension().string());
    // The other spellings are the writers' own.
    if (const PictureFormat* const picture = picture_format_of(path)) ending = picture->endings[0];
    const auto formats = export_formats();
    const auto found = std::ranges::find_if(formats, [&](const ExportFormat& format) {
        return format.kind == kind && format.ending == ending;
    });
    return found == formats.end() ? nullptr : &*found;
}

std::string export_endings(ExportKind kind) { return one_of(endings_of(kind, can_be_written)); }

std::string export_endings(ExportKind kind, bool ExportFormat::* has) {
    return one_of(endings_of(
        kind, [has](const ExportFormat& format) { return format.*has && can_be_written(format); }));
}

std::string export_use(ExportKind kind, bool ExportFormat::* has) {
    const std::string endings = export_endings(kind, has);
    return endings.empty() ? "" : "; " + filled(tr("it is for {0}"), {endings});
}

std::string missing_endings(ExportKind kind) {
    std::vector<std::string> reasons;
    for (const ExportFormat& format : export_formats()) {
        if (format.kind == kind && !format.numbered && !can_be_written(format) &&
            std::ranges::find(reasons, format.missing) == reasons.end())
            reasons.push_back(format.missing);
    }
    std::string text;
    for (const std::string& reason : reasons) {
        const auto endings = endings_of(
            kind, [&reason](const ExportFormat& format) { return format.missing == reason; });
        text += (text.empty() ? "" : "; ") + filled(tr("no {0}: {1}"), {one_of(endings), reason});
    }
    return text;
}

std::string other_name(ExportKind kind, const std::filesystem::path& path) {
    std::string text = export_endings(kind);
    text =
        text.empty() ? missing_endings(kind) : filled(tr("type a name that ends in {0}"), {text});
    if (kind == ExportKind::Film)
        text += std::string("; ") + tr("frame####.png makes numbered pictures");
    constexpr std::array kinds{ExportKind::Picture, ExportKind::Film, ExportKind::Mesh,
                               ExportKind::Drawing};
    const ExportFormat* other = nullptr;
    for (const ExportKind of : kinds) {
        const ExportFormat* const format = export_format_of(of, path);
        const bool fits = format != nullptr && !format->numbered && can_be_written(*format);
        if (fits && other == nullptr) other = format;
    }
    if (other == nullptr || other->kind == kind) return text;
    const std::string command = "`zeroset " + std::string(command_of(other->kind)) + "`";
    return text + "; " + filled(tr("{0} is written by {1}"), {other->ending, command});
}

}  // namespace zeroset
