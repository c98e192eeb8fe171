#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/editor.h"
#include "edit/length_adapter.h"
#include "edit/rest_search.h"
#include "net_argument.h"
#include "net_output.h"

namespace chebnet {

/// What `solve` and `drag` have in common. Options stay text here: the core reads and checks them.
struct SolverArguments {
    NetArgument net;
    std::string edit;
    std::string method;  ///< empty: usual_method()
    std::string initialisation{"naive"};
    std::string threshold, max_iterations, shear_limit, length_scale;  ///< empty: the default
    bool adapts_lengths = false;                                       ///< see with_lengths_adapted()
    bool searches_rest = false;                                        ///< see with_rest_searched()
    std::string guide, guide_mode;                                     ///< empty: no guide; the default
    std::vector<std::string> settings;                                 ///< each "key=value"
    NetOutput output;
    std::string trace;  ///< file to write; empty: none
    std::string edges;  ///< likewise
    std::string rods;   ///< likewise
};

/// What was solved and, if lengths were adapted then, the search for them; likewise for another net at rest.
struct AdaptedSolve {
    SolveReport solve;  ///< with how all of it ended, and the iterations, time and trace of the solves after searches
    std::optional<AdaptReport> search{};
    std::optional<RestSearchReport> rest_search{};
};

/// Declares the arguments and lists methods and options in the command's help.
void add_solver_arguments(CLI::App& command, SolverArguments& arguments);

/// For helps: which method is taken unless one is given.
std::string usual_methods();

/// The net with method and options as asked for, at rest, without handles. Throws Error.
Editor open_editor(const SolverArguments& arguments);

/// The handles of the edit file (see read_edit), for a net and method as open_editor() gives. Says so where some slide
/// and the method lets none.
std::vector<Handle> open_edit(const SolverArguments& arguments, const Editor& editor);

/// If that was asked for and the net does not keep its lengths: the smallest scale of them with which it meets the
/// handles, see LengthAdapter.
AdaptedSolve with_lengths_adapted(const SolverArguments& arguments, Editor& editor, SolveReport solved);

/// If that was asked for and the net keeps its lengths: another at rest, with less energy, see RestSearch. Throws Error
/// bad_option where the method knows no rest.
AdaptedSolve with_rest_searched(const SolverArguments& arguments, Editor& editor, AdaptedSolve solved);

/// Writes the files that were asked for. Throws Error file_access, too_large.
void write_results(const SolverArguments& arguments, const Editor& editor, std::string_view trace_csv);

}  // namespace chebnet
