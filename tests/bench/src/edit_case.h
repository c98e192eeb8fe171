#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edit/editor.h"

namespace chebnet::bench {

/// An edit by name: a recipe or an OBJ file, and a kind of motion or an edit file.
struct EditCase {
    std::string net;
    std::string kind;  ///< "pull", "bend", "spread", "twist", or what the edit file is called
    std::string edit_file;

    bool is_recipe() const { return !net.ends_with(".obj"); }
    /// Such as "vault_2000.pull".
    std::string name() const;
};

struct Edit {
    Net net;
    std::vector<Handle> handles;
};

/// The kinds of motion of generated edits.
const std::vector<std::string>& edit_kinds();

/// Makes net and handles. Always the same for the same input. Throws Error.
Edit make_problem(const EditCase& edit);

/// Every OBJ file of a folder, with its edits: NAME.KIND.json in `edits_folder` if that is not empty, else one of each
/// kind. Throws Error.
std::vector<EditCase> cases_of_folder(const std::string& nets_folder, const std::string& edits_folder);

}  // namespace chebnet::bench
