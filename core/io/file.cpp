#include "io/file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.h"

namespace chebnet {

namespace {

[[noreturn]] void fail_file(const std::string& path, const std::string& what) {
    throw Error(ErrorCode::file_access, path + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail_file(path, "cannot be opened");
    // By chunks rather than by asking for the size: pipes have none.
    std::string bytes;
    std::vector<char> chunk(std::size_t{1} << 20);
    while (file.read(chunk.data(), std::ssize(chunk)) || file.gcount() > 0) {
        bytes.append(chunk.data(), file.gcount());
        if (bytes.size() > k_max_file_bytes) throw Error(ErrorCode::too_large, path + ": larger than 1 GiB");
    }
    if (file.bad()) fail_file(path, "cannot be read");
    return bytes;
}

void write_file(const std::string& path, std::string_view bytes) {
    std::ofstream file(path, std::ios::binary);
    if (!file) fail_file(path, "cannot be opened for writing");
    file.write(bytes.data(), std::ssize(bytes));
    file.close();
    if (!file) fail_file(path, "cannot be written");
}

}  // namespace chebnet
