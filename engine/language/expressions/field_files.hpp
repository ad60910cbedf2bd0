#pragma once

#include "engine/language/values/graph_values.hpp"

#include <map>
#include <memory>
#include <string>

namespace zeroset {

class FieldSource;

/// The fields of the files that a text names, each opened once.
class FieldFiles {
public:
    /// `files`: where they come from; nullptr: none are read. Both outlive this object.
    FieldFiles(const FieldSource* files, GraphValues& values) : files_(files), values_(values) {}

    /// The field of a call as it is typed: volume("ct.nrrd", edge). nullptr is an error, at
    /// `offset` or within the call that starts there.
    std::shared_ptr<const Field> field(const std::string& call, std::size_t offset);

private:
    const FieldSource* files_;
    GraphValues& values_;
    std::map<std::string, std::shared_ptr<const Field>> fields_;  ///< by their calls
};

}  // namespace zeroset
