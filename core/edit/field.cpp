#include "edit/field.h"

#include "net/measures.h"
#include "surface/guide.h"

namespace chebnet {

namespace {

/// E, dL (see deviation()).
Eigen::VectorXd deviations(const Editor& editor) {
    return edge_ratios(editor.net(), editor.positions()).unaryExpr([](double ratio) { return deviation(ratio); });
}

/// V (see vertex_corner_angles()).
Eigen::VectorXd corner_angles(const Editor& editor) { return vertex_corner_angles(editor.net(), editor.positions()); }

/// E (see Editor::edge_forces()).
Eigen::VectorXd edge_forces(const Editor& editor) { return editor.edge_forces(); }

/// V, heights over the guide (see heights_over()); zeros without one.
Eigen::VectorXd heights(const Editor& editor) {
    if (!editor.guide()) return Eigen::VectorXd::Zero(editor.net().vertex_count());
    return heights_over(*editor.guide(), editor.positions());
}

constexpr FieldInfo k_fields[] = {
    {"deviation", deviations}, {"angle", corner_angles}, {"force", edge_forces}, {"height", heights}};

}  // namespace

std::span<const FieldInfo> field_table() { return k_fields; }

}  // namespace chebnet
