#pragma once

#include "engine/blobs/blob_kind.hpp"
#include "engine/blobs/blob_set.hpp"
#include "engine/real/total_field.hpp"

#include <array>
#include <memory>
#include <span>
#include <string>

// The field of soft balls [Blinn82, Nishimura85, Wyvill86] as a function of a point: the sum of
// their heights (blob_kind.hpp). Points and boxes ask only the blobs that reach them, found in a
// tree. Over a box each height has its exact range, as it falls with the distance, and slopes are
// products of ranges; a box larger than supports is told by sums over parts of the tree.

namespace zeroset {

class Blobs {
public:
    Blobs(BlobKind kind, std::span<const Blob> blobs)
        : kind_(kind), set_(std::make_shared<const BlobSet>(blobs, blob_facts(kind).reach)) {}

    [[nodiscard]] BlobKind kind() const { return kind_; }
    [[nodiscard]] const BlobSet& set() const { return *set_; }

    [[nodiscard]] PointAnswer at(const std::array<double, 3>& point, bool with_bends) const;
    void at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const;
    void over(std::span<const FieldBox> boxes, BoxAnswer* answers) const;
    [[nodiscard]] BendAnswer bend(const FieldBox& box,
                                  const std::array<std::size_t, 2>& axes) const;

private:
    [[nodiscard]] bool is_large(const FieldBox& box) const;
    [[nodiscard]] BoxAnswer over_large(const FieldBox& box) const;
    void over_near(std::span<const FieldBox> boxes, std::span<const std::size_t> of,
                   BoxAnswer* answers) const;

    BlobKind kind_;
    std::shared_ptr<const BlobSet> set_;
};

using BlobsField = TotalField<Blobs>;

/// The blobs as a field. Equal ones with equal texts are the same object as long as they are among
/// the latest, so that code made for them is found again.
std::shared_ptr<const Field> blobs_field(BlobKind kind, std::span<const Blob> blobs,
                                         const std::string& text);

}  // namespace zeroset
