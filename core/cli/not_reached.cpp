#include "not_reached.h"

#include <iostream>
#include <string>
#include <vector>

#include "base/number.h"
#include "edit/length_adapter.h"

namespace chebnet {
namespace {

/// What happened, and what may help.
struct Sentences {
    std::string what, way_out;
};

/// Whether edges that grow as far as they may could bring two handles within reach. Ends of an edge that are nearer to
/// each other than it is long come no nearer with longer ones.
bool may_grow_there(const Editor& editor, const UnreachablePair& pair) {
    const double most = LengthAdapter::k_largest_scale / editor.options().length_scale;
    return pair.distance > pair.reach && pair.distance <= most * pair.reach;
}

Sentences out_of_reach(const Editor& editor, bool has_grown_edges) {
    const std::vector<UnreachablePair> pairs = editor.unreachable_pairs();
    std::string what = "no way was found for the net to where its handles are to be";
    if (!pairs.empty())
        what = "handles " + std::to_string(pairs[0].vertex_a) + " and " + std::to_string(pairs[0].vertex_b) +
               " are to be " + number_text(pairs[0].distance, 6) + " apart, but the net between them is " +
               number_text(pairs[0].reach, 6) + " long";
    what += ", and it holds its best shape";
    if (has_grown_edges)
        return {what,
                "edges up to " + number_text(LengthAdapter::k_largest_scale, 2) + " times as long do not do, either"};
    if (!pairs.empty() && !may_grow_there(editor, pairs[0])) return {what, "other targets may do"};
    return {what, "other targets, or --adapt-lengths, which lets edges grow, may do"};
}

Sentences sentences_of(const Editor& editor, const SolveReport& end, bool has_grown_edges) {
    const bool is_usual = editor.method() == k_default_method;
    const std::string usual = "--method " + std::string(k_default_method);
    switch (end.status) {
        case Status::unreachable:
            return out_of_reach(editor, has_grown_edges);
        case Status::max_iterations:
            return {"the iteration limit, " + std::to_string(editor.options().max_iterations) +
                        ", was reached before every edge had its length",
                    "a larger --max-iterations" + (is_usual ? "" : ", or " + usual + ",") + " may do"};
        case Status::non_finite:
            return {"a number overflowed, and the last finite shape is held", "targets nearer to the net may do"};
        default:
            return {"stuck: no shape near by was found with every edge at its length",
                    is_usual ? "targets that are nearer, or soft handles, may do" : usual + " often finds one"};
    }
}

}  // namespace

void tell_not_reached(const Editor& editor, const SolveReport& end, bool has_grown_edges) {
    const auto [what, way_out] = sentences_of(editor, end, has_grown_edges);
    std::cerr << "chebnet: " << what << "; " << way_out << '\n';
}

}  // namespace chebnet
