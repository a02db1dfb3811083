#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// The option of the program that does what the cure of a message recommends. The messages of the library name no
// options, because other programs use it, too.
struct OptionHint {
    std::string_view code;
    std::string_view option;  // * stands for the word that the cure has in quotes: the name of a limit
};

inline constexpr OptionHint kOptionHints[] = {
    {"WC0208", "--allow-path DIR"}, {"WC0406", "--skin-node ignore"}, {"WC0513", "pose --exact"},
    {"WC0620", "--texture FILE"},   {"WC0702", "--scene ID"},         {"WC0703", "--scene ID"},
    {"WC0801", "--limit *=N"},      {"WC0803", "--limit *=N"},
};

// The cure with the option behind it: "if the file is honest, raise the limit 'nodes': --limit nodes=N". Without an
// option for this code, the cure itself.
inline std::string withOption(std::string_view code, std::string cure) {
    for (const OptionHint& hint : kOptionHints) {
        if (hint.code != code) continue;
        std::string option(hint.option);
        const std::size_t star = option.find('*'), open = cure.find('\''), close = cure.rfind('\'');
        if (star != option.npos && open < close)
            option.replace(star, 1, cure.substr(open + 1, close - open - 1));
        return cure + ": " + option;
    }
    return cure;
}

// The same for a whole diagnostic.
inline Diagnostic withOption(Diagnostic diagnostic) {
    diagnostic.cure = withOption(diagnostic.code, std::move(diagnostic.cure));
    return diagnostic;
}

}  // namespace walkcycle
