#pragma once

#include <Eigen/Core>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "net/net.h"
#include "program.h"

// Nets and edits to run the program on, and what its answers have in common.

inline const std::string k_recipe = "vault:vertices=400";

nlohmann::json edit_entry(int vertex, const Eigen::Vector3d& target);

/// Anchors at rest; the last handle goes the given fraction of the way to the middle of the net.
nlohmann::json pull_edit(double fraction);

/// Two vertices of a net about 10 across, 1000 apart.
nlohmann::json unreachable_edit();

/// A quad mesh whose edges differ in length.
void write_stretched_vault(const Sandbox& box, const std::string& name);

/// n × n vertices at(u, v) for u and v from 0 to 1; of a ring the first and the last for u are the same.
void write_grid(const Sandbox& box, const std::string& name, int n, bool is_ring,
                const std::function<Eigen::Vector3d(double, double)>& at);

/// The saddle z = x y / 2 over a square.
void write_saddle(const Sandbox& box, const std::string& name, int n);

int line_count(const std::string& text);
int sum(const nlohmann::json& counts);
double handle_distance(const chebnet::Positions& positions, const nlohmann::json& edit);

/// A saved result, measured against the lengths of the net it came from.
double max_deviation_of_file(const Sandbox& box, const std::string& name);

void check_shape_report(const nlohmann::json& report);

/// A user sees exit code 2, nothing on standard output, and one line that holds `what`.
void check_refused(const Run& run, const std::string& what);
