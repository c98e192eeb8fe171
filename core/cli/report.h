#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "edit/editor.h"
#include "edit/rest_search.h"

namespace chebnet {

/// Keys keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// How the net stands now: max dL, handle error, bend, corner angles, quads beyond the shear limit as the net came and
/// now, and handle pairs that are out of reach.
Json shape_report(const Editor& editor);

/// Handle pairs that are out of reach, as a list.
Json unreachable_report(const std::vector<UnreachablePair>& pairs);

/// What is left to do until the net is at rest, null where the method does not tell.
Json to_rest_report(const std::optional<ToRest>& left);

/// What a search for another net at rest has come to.
Json rest_search_report(const RestSearchReport& search);

/// What holds the net at rest: the energy of each term, the forces at handles and at corners, and the edges that pull
/// and push most. Empty where the method does not tell.
Json forces_report(const Editor& editor);

/// Whether every edge has its length and every exact handle its place after a solve that ended so, also short of rest,
/// or with corners sharper than the limit.
bool has_lengths(const Editor& editor, const SolveReport& end);

/// Tells on standard error that every edge has its length, but so many quads have corners sharper than this limit,
/// radians.
void tell_sharp_quads(int count, double limit);
/// Likewise after a solve that ended so, if there are any and the method keeps to a limit: where handles leave no other
/// net, or edges are so unlike that they allow no more.
void tell_sharp_quads(const Editor& editor, const SolveReport& end);
/// Says on standard error that every edge has its length, but the net is crumpled at so many edges, if it is: it folds
/// there by 60 degrees more than that, a net before or a surface; and the way out, a sentence, unless it is empty.
void tell_crumpled(int edges, std::string_view than, std::string_view way_out);
/// Likewise where an edit has done that; what may help is another method, or by `equilibrium` this.
void tell_crumpled(const Editor& editor, const SolveReport& end, const char* what_helps);

/// Writes to standard output; numbers that are not finite become null. Throws Error file_access.
void print(const Json& report);

}  // namespace chebnet
