#include "engine/blobs/blob_file.hpp"

#include "engine/base/translation.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

namespace zeroset {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30U;
constexpr double largest = 1e100;
constexpr double least_radius = 1e-100;

std::vector<std::string_view> words_in(std::string_view line) {
    constexpr std::string_view between = " \t\r,;";
    std::vector<std::string_view> words;
    std::size_t at = line.find_first_not_of(between);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(between, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(between, end);
    }
    return words;
}

std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    return is_number && std::abs(number) <= largest ? std::optional(number) : std::nullopt;
}

class BlobReader {
public:
    BlobReader(double radius, std::size_t most) : radius_(radius), most_(most) {}

    /// False: the line is wrong, or one ball too many.
    bool take(std::string_view line) {
        ++line_;
        std::vector<std::string_view> words = words_in(line);
        if (words.empty() || words[0].starts_with('#') || words[0].starts_with("//")) return true;
        const bool is_first = blobs_.empty() && !has_head_;
        if (is_first && line_ == 1 && words.size() == 1 && number_of(words[0])) {
            is_xyz_ = true;  // the number of atoms
            return true;
        }
        if (is_xyz_ && line_ == 2) return true;  // a remark
        const bool has_name = !number_of(words[0]);
        if (has_name && words.size() >= 4 && number_of(words[1]))
            words.erase(words.begin());  // of an atom
        std::vector<double> numbers;
        for (const std::string_view word : words) {
            const auto number = number_of(word);
            if (!number) break;
            numbers.push_back(*number);
        }
        if (is_first && numbers.empty()) {
            has_head_ = true;
            return true;
        }
        const bool is_whole = numbers.size() == words.size() || (is_xyz_ && numbers.size() >= 3);
        return is_whole && numbers.size() >= 3 && numbers.size() <= 5 && add(numbers);
    }
    [[nodiscard]] std::size_t line() const { return line_; }
    [[nodiscard]] bool is_full() const { return is_full_; }
    std::vector<Blob> blobs() { return std::move(blobs_); }

private:
    bool add(const std::vector<double>& numbers) {
        Blob blob{.center = {numbers[0], numbers[1], numbers[2]}, .radius = radius_};
        if (numbers.size() > 3 && !is_xyz_) blob.radius = numbers[3];
        if (numbers.size() > 4 && !is_xyz_) blob.strength = numbers[4];
        if (blob.radius < 0) {
            blob.radius = -blob.radius;
            blob.strength = -blob.strength;
        }
        if (!(blob.radius >= least_radius)) return false;
        if (blob.strength == 0) return true;
        is_full_ = blobs_.size() == most_;
        if (!is_full_) blobs_.push_back(blob);
        return !is_full_;
    }

    double radius_;
    std::size_t most_;
    std::size_t line_ = 0;
    bool is_xyz_ = false, has_head_ = false, is_full_ = false;
    std::vector<Blob> blobs_;
};

}  // namespace

std::expected<std::vector<Blob>, std::string> blobs_of_text(std::string_view text, double radius,
                                                            std::size_t most) {
    BlobReader reader(radius, most);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (!reader.take(text.substr(0, end))) {
            if (reader.is_full()) {
                return std::unexpected(
                    filled(tr("line {0} has one ball more than the {1} that a list may have; split "
                              "the file, and type the sum of both lists"),
                           {std::to_string(reader.line()), std::to_string(most)}));
            }
            return std::unexpected(filled(tr("line {0} is not x y z, x y z r or x y z r strength"),
                                          {std::to_string(reader.line())}));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    std::vector<Blob> blobs = reader.blobs();
    if (blobs.empty())
        return std::unexpected(tr("it has no line x y z, x y z r or x y z r strength"));
    return blobs;
}

std::expected<std::vector<Blob>, std::string> read_blobs(const std::filesystem::path& file,
                                                         double radius) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) return std::unexpected(tr("it cannot be read"));
    if (size > largest_file) return std::unexpected(tr("it is larger than 1 GB"));
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return blobs_of_text(text, radius);
}

}  // namespace zeroset
