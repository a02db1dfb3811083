// Runs a fuzz target over files and folders of inputs, without a fuzzer: for ctest, with any compiler.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "walkcycle/io/File.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1 << 24;

void replay(const fs::path& file) {
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);  // the last name tells which input it was
    const walkcycle::Bytes input = walkcycle::readFile(file.string(), kMaxBytes);
    LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int count, char** arguments) {
    int inputs = 0;
    for (int i = 1; i < count; ++i) {
        if (!fs::is_directory(arguments[i])) {
            replay(arguments[i]);
            ++inputs;
            continue;
        }
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(arguments[i])) {
            if (!entry.is_regular_file()) continue;
            replay(entry.path());
            ++inputs;
        }
    }
    std::printf("%d inputs\n", inputs);
    return inputs > 0 ? 0 : 1;
}
