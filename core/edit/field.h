#pragma once

#include <Eigen/Core>
#include <span>

#include "edit/editor.h"

namespace chebnet {

/// One line of the table of fields: values that are shown as colours on the net. Each has one number for every edge
/// or one for every vertex, at the positions held now.
struct FieldInfo {
    const char* name;
    Eigen::VectorXd (*numbers)(const Editor& editor);
};

std::span<const FieldInfo> field_table();

}  // namespace chebnet
