#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit_case.h"

namespace chebnet::bench {

/// An edit by name. The page opens the same under that name.
struct NamedEdit {
    std::string name;
    std::function<Edit()> open;  ///< throws Error
};

/// One way to solve an edit.
struct Variant {
    std::string name;   ///< by which a check asks for it
    std::string label;  ///< for people
    std::string method = "li2022", initialisation = "naive";
    std::vector<std::pair<std::string, std::string>> options = {};
    std::optional<NamedEdit> edit = {};  ///< in place of the figure's
    int frames = 0;         ///< 0: handles jump to their targets; else they are dragged there in so many frames
    bool remeshes = false;  ///< what comes of it is a surface, over which a new net is made
    bool is_ours = false;   ///< no method of the paper, and no part of its claims
};

struct Claim {
    std::string text;   ///< what the paper says, in our words
    std::string check;  ///< name of the test of it; see checks.h
};

/// What a picture's colours show.
enum class Colouring { deviation, longer, angle };

/// One figure of the paper, on nets of our own.
struct Figure {
    std::string name;
    std::optional<int> number;  ///< none: a claim of section 4 without a figure
    std::string title;
    std::string look;  ///< what to look for
    std::vector<NamedEdit> edits;
    std::vector<Variant> variants;
    std::vector<std::string> plots;  ///< names of what is plotted; see plots_of_runs.h
    std::vector<Claim> claims;
    Colouring colouring = Colouring::deviation;

    std::string place() const { return number ? "Figure " + std::to_string(*number) : "Section 4"; }
};

/// The one description of all figures, web/src/experiments/figures.json, from which the page is made as well. Throws
/// Error bad_syntax naming the place.
std::vector<Figure> read_figures(const std::string& path);

}  // namespace chebnet::bench
