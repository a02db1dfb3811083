#include "ProfileCase.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <optional>
#include <sstream>

#include "walkcycle/loaders/ColladaLoader.h"

namespace walkcycle {

std::string cleanDocument() {
    std::ifstream file(WALKCYCLE_FIXTURES "/profile-clean.dae", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string changed(const std::vector<Change>& changes) {
    std::string text = cleanDocument();
    for (const Change& change : changes) {
        const std::size_t at = text.find(change.from);
        if (at == std::string::npos)
            ADD_FAILURE() << "not in the document: " << change.from;
        else
            text.replace(at, change.from.size(), change.to);
    }
    return text;
}

std::string imageEffect(const std::string& slots) {
    return "<lambert>" + slots + "</lambert>";
}

std::string inScene(const std::string& nodes) {
    return nodes + kSceneEnd;
}

std::vector<Diagnostic> said(Profile profile, const std::string& text) {
    LoadOptions options;
    options.resolver = [](const std::string&) { return std::optional<Bytes>(); };
    options.inspector = [profile](const Inspection& inspection) { checkProfile(profile, inspection); };
    const Bytes bytes(text.begin(), text.end());
    std::vector<Diagnostic> all = loadCollada(bytes, "test.dae", options).diagnostics;
    std::erase_if(all, [](const Diagnostic& diagnostic) { return !diagnostic.code.starts_with("WC10"); });
    return all;
}

void expectSaid(Profile profile, const std::string& text, const std::string& code, const std::string& marker,
                const std::string& pathEnd) {
    const std::size_t at = text.find(marker);
    ASSERT_NE(at, std::string::npos) << marker;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    std::vector<Diagnostic> found = said(profile, text);
    std::string others;
    for (const Diagnostic& diagnostic : found)
        others += toString(diagnostic) + " at " + diagnostic.elementPath + "\n";
    std::erase_if(found, [&](const Diagnostic& diagnostic) { return diagnostic.code != code; });
    ASSERT_EQ(found.size(), 1u) << code << " is not said once, but this:\n" << others;
    EXPECT_EQ(found[0].line, line) << others;
    EXPECT_EQ(found[0].repeats, 0) << others;
    EXPECT_TRUE(found[0].elementPath.ends_with(pathEnd)) << others;
}

}  // namespace walkcycle
