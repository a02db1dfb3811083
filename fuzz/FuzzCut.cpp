// Any text as a document, read with its number lists cut out and the plain way: both must see the same.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "Documents.h"
#include "Require.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"

namespace {

using namespace walkcycle;

// One read of the text; `reason` is why there is no root.
struct Reading {
    explicit Reading(const std::string& text) : documents(options, diagnostics) {
        try {
            root =
                documents
                    .openMemory({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "fuzz.dae")
                    .root();
        } catch (const LoadError& error) {
            reason = error.diagnostics.back();
        }
    }

    LoadOptions options = withoutFiles();
    Diagnostics diagnostics;
    DocumentSet documents;
    XmlNode root;
    Diagnostic reason;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    // Whatever has a DOCTYPE is left to tinyxml2. Only plain text can have one put before it; with an <!ENTITY in it,
    // which is refused in a DOCTYPE and no XML without one, it is another document then.
    if (text.empty() || text[0] != '<' || text.starts_with("<?") || text.find('\0') != std::string::npos ||
        text.find("<!ENTITY") != std::string::npos)
        return 0;
    const Reading cut(text), plain("<!DOCTYPE COLLADA>" + text);
    REQUIRE(cut.reason.code == plain.reason.code);
    REQUIRE(static_cast<bool>(cut.root) == static_cast<bool>(plain.root));
    const std::vector<XmlNode> all = elementsOf(cut.root), others = elementsOf(plain.root);
    REQUIRE(all.size() == others.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const XmlNode a = all[i], b = others[i];
        REQUIRE(a.name() == b.name());
        REQUIRE(a.line() == b.line());
        REQUIRE(a.id() == b.id());
        REQUIRE(a.text() == b.text());
        REQUIRE(a.textLine() == b.textLine());
    }
    return 0;
}
