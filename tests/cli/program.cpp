#include "program.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

std::filesystem::path new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "chebnet_cli_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder " + name);
    return name;
}

std::string quoted(const std::string& path) { return "'" + path + "'"; }

}  // namespace

Sandbox::Sandbox() : m_folder(new_folder()) {}

Sandbox::~Sandbox() { std::filesystem::remove_all(m_folder); }

Run Sandbox::run(const std::string& arguments, const std::string& out) const {
    const std::string command = "cd " + quoted(m_folder.string()) + " && " + quoted(CHEBNET_PROGRAM) + " " + arguments +
                                " >" + quoted(out) + " 2>.err";
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status)) throw std::runtime_error("crashed: chebnet " + arguments);
    return {WEXITSTATUS(status), out == ".out" ? read(out) : "", read(".err")};
}

void Sandbox::write(const std::string& name, const std::string& text) const {
    std::ofstream(m_folder / name, std::ios::binary) << text;
}

std::string Sandbox::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(m_folder / name, std::ios::binary).rdbuf();
    return text.str();
}
