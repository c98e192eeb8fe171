// A program as the README promises it to others: opens a shape, lifts its first suggested handle, and solves.
#include <cstdio>

#include "edit/editor.h"
#include "shapes/shapes.h"

int main() {
    chebnet::Shape shape = chebnet::make_shape("sheet:vertices=400");
    chebnet::Editor editor(shape.net);
    std::vector<chebnet::Handle> handles;
    for (const int vertex : shape.suggested_handles)
        handles.push_back({vertex, shape.net.rest_positions().col(vertex)});
    handles.back().target.z() += 1;
    editor.set_handles(handles);
    const chebnet::SolveReport report = editor.solve();
    std::printf("%s, largest dL %.1e\n", chebnet::to_string(report.status), report.max_deviation);
    return report.status == chebnet::Status::converged && report.max_deviation < 1e-9 ? 0 : 1;
}
