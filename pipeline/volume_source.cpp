#include "pipeline/volume_source.hpp"

#include "engine/base/file_stamp.hpp"
#include "engine/base/translation.hpp"
#include "engine/blobs/blob_file.hpp"
#include "engine/blobs/blobs.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/volume_file.hpp"
#include "engine/volume/made_volumes.hpp"
#include "engine/volume/spline.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

namespace fs = std::filesystem;

/// The arguments that are typed behind the file's name.
struct Wanted {
    VolumeOptions options;
    std::optional<SplineKind> spline;  ///< absent: trilinear
    RawLayout layout;
    bool raw = false;  ///< whether something was typed that a header would tell
};

class ArgumentReader {
public:
    using Result = std::expected<Wanted, FieldError>;

    static Result read(const FieldCall& call) {
        ArgumentReader reader;
        for (const std::string_view argument : call.arguments) {
            if (auto error = reader.take(argument)) return std::unexpected(std::move(*error));
        }
        if (reader.wanted_.raw && !reader.wanted_.layout.size) {
            return std::unexpected(FieldError{.reason = tr("raw samples need their sizes"),
                                              .hint = filled(tr("type {0}"), {"size 256 256 109"}),
                                              .at = call.text.substr(0, 1)});
        }
        return reader.wanted_;
    }

private:
    std::optional<FieldError> take(std::string_view argument) {
        const std::string text = lower_case(argument);
        if (take_spline(text)) return std::nullopt;
        if (text == "edge" || text == "undefined") {
            wanted_.options.outside = text == "edge" ? Outside::Edge : Outside::Undefined;
            return std::nullopt;
        }
        if (const auto number = number_from<double>(text)) return outside_is(*number, argument);
        if (text == "big" || text == "little") {
            wanted_.layout.big_endian = text == "big";
            wanted_.raw = true;
            return std::nullopt;
        }
        if (const auto type = sample_type(text)) {
            wanted_.layout.type = *type;
            wanted_.raw = true;
            return std::nullopt;
        }
        return take_named(text, argument);
    }
    bool take_spline(std::string_view text) {
        if (text == "trilinear") {
            wanted_.spline.reset();
        } else if (text == "cubic") {
            wanted_.spline = SplineKind::Interpolating;
        } else if (text == "smooth") {
            wanted_.spline = SplineKind::Smoothing;
        } else {
            return false;
        }
        return true;
    }
    std::optional<FieldError> outside_is(double number, std::string_view argument) {
        constexpr double largest = 1e300;
        if (!(std::abs(number) <= largest)) return unknown(argument);
        wanted_.options = {.outside = Outside::Constant, .constant = number};
        return std::nullopt;
    }
    std::optional<FieldError> take_named(const std::string& text, std::string_view argument) {
        const auto words = words_of(text);
        const std::string_view name = words.empty() ? std::string_view() : words[0];
        const std::string_view rest = std::string_view(text).substr(name.size());
        wanted_.raw = true;
        if (name == "size") {
            const auto sizes = numbers_in<std::uint64_t>(rest);
            if (!sizes || (sizes->size() != 3 && sizes->size() != 1)) return unknown(argument);
            const std::size_t last = sizes->size() - 1;
            wanted_.layout.size =
                GridSize{(*sizes)[0], (*sizes)[std::min<std::size_t>(1, last)], (*sizes)[last]};
            return std::nullopt;
        }
        if (name == "skip") {
            const auto bytes = numbers_in<std::uint64_t>(rest);
            if (!bytes || bytes->size() != 1) return unknown(argument);
            wanted_.layout.skip = bytes->front();
            return std::nullopt;
        }
        if (name == "spacing" || name == "origin") {
            const auto numbers = numbers_in<double>(rest);
            if (!numbers || numbers->size() != 3) return unknown(argument);
            auto& target = name == "spacing" ? wanted_.layout.spacing : wanted_.layout.origin;
            std::ranges::copy(*numbers, target.begin());
            return std::nullopt;
        }
        return unknown(argument);
    }
    static FieldError unknown(std::string_view argument) {
        return {
            .reason = filled(tr("{0} says nothing of a volume"), {quoted(argument)}),
            .hint = filled(
                tr("known are {0}"),
                {"trilinear, cubic, smooth, edge, undefined, 0.5, size 256 256 109, uint8, big, "
                 "skip 512, spacing 1 1 2, origin 0 0 0"}),
            .at = argument};
    }

    Wanted wanted_;
};

class VolumeSource final : public FieldSource {
public:
    VolumeSource(VolumeFolder folder, std::shared_ptr<FileAccess> access)
        : folder_(std::move(folder)), access_(std::move(access)) {}

    [[nodiscard]] std::expected<std::shared_ptr<const Field>, FieldError> open(
        const FieldCall& call) const override {
        if (call.word != "volume") return blobs(call);
        const auto wanted = ArgumentReader::read(call);
        if (!wanted) return std::unexpected(wanted.error());
        const std::scoped_lock lock(mutex_);
        auto data = call.file.starts_with('@') ? made(call, *wanted) : read(call, *wanted);
        if (!data) return std::unexpected(std::move(data.error()));
        return known_or_new(std::move(*data), *wanted, call);
    }
    [[nodiscard]] std::uint64_t version() const override { return access_->version(); }

private:
    using Data = std::expected<std::shared_ptr<const VolumeData>, FieldError>;

    static Data made(const FieldCall& call, const Wanted& wanted) {
        std::optional<std::uint64_t> size;
        if (wanted.layout.size) size = (*wanted.layout.size)[0];
        auto data = made_volume(call.file.substr(1), size);
        if (data) return std::move(*data);
        return std::unexpected(FieldError{
            .reason = quoted(call.file) + ": " + data.error(), .hint = {}, .at = call.file});
    }
    /// The file's path, if it may be read.
    [[nodiscard]] std::expected<fs::path, FieldError> allowed_path(const FieldCall& call) const {
        fs::path file = folder_.folder / fs::path(call.file);
        if (!folder_.closed || may_read(file)) return file;
        return std::unexpected(FieldError{
            .reason = filled(tr("{0} lies outside the document's folder"), {quoted(call.file)}),
            .hint = tr("open that file itself to allow it, or put it beside the "
                       "document"),
            .at = call.file});
    }
    /// The soft balls of a file.
    [[nodiscard]] std::expected<std::shared_ptr<const Field>, FieldError> blobs(
        const FieldCall& call) const {
        double radius = 1;
        if (!call.arguments.empty()) {
            const auto number = number_from<double>(call.arguments.front());
            if (!number || !(*number > 0 && *number < 1e100) || call.arguments.size() > 1) {
                return std::unexpected(FieldError{
                    .reason = filled(tr("behind the file {0} takes the radius of its balls"),
                                     {std::string(call.word)}),
                    .hint = filled(tr("type {0}"), {std::string(call.word) + "(\"" +
                                                    std::string(call.file) + "\", 0.5)"}),
                    .at = call.arguments.back()});
            }
            radius = *number;
        }
        const auto file = allowed_path(call);
        if (!file) return std::unexpected(file.error());
        const FileStamp stamp = FileStamp::now(*file);
        const auto read = read_blobs(*file, radius);
        if (!read) {
            return std::unexpected(FieldError{.reason = quoted(call.file) + ": " + read.error(),
                                              .hint = {},
                                              .at = call.file.empty() ? call.text : call.file});
        }
        const BlobKind kind = call.word == "metaballs" ? BlobKind::Metaball
                              : call.word == "blinn"   ? BlobKind::Blinn
                                                       : BlobKind::Wyvill;
        auto field = blobs_field(kind, *read, std::string(call.text));
        access_->note_read(field, {stamp});
        return field;
    }
    [[nodiscard]] Data read(const FieldCall& call, const Wanted& wanted) const {
        const auto allowed = allowed_path(call);
        if (!allowed) return std::unexpected(allowed.error());
        const fs::path& file = *allowed;
        auto data = open_volume(file, wanted.layout);
        if (data) {
            access_->note_read(*data, files_of(**data));
            return std::move(*data);
        }
        std::string hint;
        if (!is_volume_file(file) && !wanted.layout.size) {
            hint = filled(tr("type {0}, or name a file that ends in {1}"),
                          {"volume(\"" + std::string(call.file) + "\", size 256 256 109, uint8)",
                           known_endings()});
        }
        return std::unexpected(FieldError{.reason = quoted(call.file) + ": " + data.error(),
                                          .hint = hint,
                                          .at = call.file.empty() ? call.text : call.file});
    }
    [[nodiscard]] bool may_read(const fs::path& file) const {
        return is_within(real_path(file), real_path(folder_.folder)) || access_->allows(file);
    }

    /// Equal texts get the same function, so that code made for it is found again.
    std::expected<std::shared_ptr<const Field>, FieldError> known_or_new(
        std::shared_ptr<const VolumeData> data, const Wanted& wanted, const FieldCall& call) const {
        constexpr std::size_t most_kept = 4;
        const auto same = std::ranges::find_if(latest_, [&](const auto& volume) {
            return &volume->data() == data.get() && volume->options() == wanted.options &&
                   volume->text() == call.text;
        });
        if (same != latest_.end()) {
            auto volume = *same;
            latest_.erase(same);
            latest_.push_back(volume);
            return volume;
        }
        auto volume = made_of(std::move(data), wanted, std::string(call.text));
        if (!volume) {
            return std::unexpected(FieldError{.reason = quoted(call.file) + ": " + volume.error(),
                                              .hint = {},
                                              .at = call.file.empty() ? call.text : call.file});
        }
        // Only the newest volume of a file that has changed is kept.
        std::erase_if(latest_, [&](const auto& old) { return old->text() == call.text; });
        latest_.push_back(*volume);
        if (latest_.size() > most_kept) latest_.pop_front();
        return std::move(*volume);
    }
    static std::expected<std::shared_ptr<const Volume>, std::string> made_of(
        std::shared_ptr<const VolumeData> data, const Wanted& wanted, std::string text) {
        if (!wanted.spline) return Volume::make(std::move(data), wanted.options, std::move(text));
        auto spline = SplineData::of(data, *wanted.spline);
        if (!spline) return std::unexpected(spline.error());
        return Volume::make(std::move(*spline), wanted.options, std::move(text));
    }

    VolumeFolder folder_;
    std::shared_ptr<FileAccess> access_;
    mutable std::mutex mutex_;
    mutable std::deque<std::shared_ptr<const Volume>> latest_;
};

}  // namespace

std::shared_ptr<const FieldSource> volume_source(const VolumeFolder& folder,
                                                 std::shared_ptr<FileAccess> access) {
    return std::make_shared<const VolumeSource>(folder, std::move(access));
}

}  // namespace zeroset
