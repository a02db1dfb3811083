#include "app/CodeNames.h"

#include <algorithm>
#include <cstddef>

namespace walkcycle {
namespace {

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

}  // namespace

const CodeInfo* codeNamed(const std::string& wanted) {
    const std::string code = upper(wanted);
    const std::string padded = "WC" + std::string(4 - std::min<std::size_t>(4, code.size()), '0') + code;
    for (const CodeInfo& entry : diagnosticCatalogue())
        if (code == entry.id || padded == entry.id) return &entry;
    return nullptr;
}

}  // namespace walkcycle
