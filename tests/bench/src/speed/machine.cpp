#ifdef CHEBNET_HAS_CHOLMOD
#include <dlfcn.h>
#endif

#include <filesystem>
#include <fstream>
#include <string>

#include "measure.h"

#ifdef CHEBNET_HAS_CHOLMOD
extern "C" void dgemm_();
#endif

namespace chebnet::bench {
namespace {

std::string cpu() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string compiler() {
#ifdef __clang__
    return __VERSION__;
#else
    return std::string("GCC ") + __VERSION__;
#endif
}

/// Which of the libraries that call themselves BLAS is in use: Debian has a folder for each.
std::string blas() {
#ifdef CHEBNET_HAS_CHOLMOD
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&dgemm_), &info) == 0) return "unknown";
    return std::filesystem::canonical(info.dli_fname).parent_path().filename().string();
#else
    return "";
#endif
}

}  // namespace

Machine this_machine() { return {cpu(), compiler(), blas()}; }

}  // namespace chebnet::bench
