#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

/// What a run of the program left behind.
struct Run {
    int exit_code;
    std::string out, err;

    /// Standard output as JSON; fails the test if it is not.
    nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// A folder of its own for one test, removed at its end, in which the program runs.
class Sandbox {
public:
    Sandbox();
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    /// Runs `chebnet arguments`, as a shell reads it. `out` says where standard output goes.
    Run run(const std::string& arguments, const std::string& out = ".out") const;

    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const { return std::filesystem::exists(m_folder / name); }
    void make_folder(const std::string& name) const { std::filesystem::create_directory(m_folder / name); }

private:
    std::filesystem::path m_folder;
};
