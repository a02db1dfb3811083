// Any text as the inside of a document: every <source> in it as numbers and as names, and every <input>.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

#include "Documents.h"
#include "Require.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/sources/Inputs.h"
#include "loaders/sources/Source.h"

namespace {

using namespace walkcycle;

template <typename T>
void check(const std::shared_ptr<const Source<T>>& source) {
    if (!source) return;
    REQUIRE(source->width > 0);
    REQUIRE(source->values.size() % source->width == 0);
    if constexpr (std::is_floating_point_v<T>)
        for (const T value : source->values) REQUIRE(std::isfinite(value));
}

void readAll(XmlNode root, DocumentSet& documents, Diagnostics& diagnostics, Dialects& dialects) {
    SourceReader sources(documents, diagnostics, dialects);
    for (XmlNode node : elementsOf(root)) {
        if (node.is("source")) {
            bool isIdref = false;
            check(sources.floats(node, NumberFaults::Error));
            check(sources.doubles(node, NumberFaults::Warning));
            check(sources.names(node, isIdref));
        }
        for (const Input& input : readInputs(node, documents, diagnostics)) REQUIRE(input.element);
        readInts(node, diagnostics);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string text = "<COLLADA>\n";
    text.append(reinterpret_cast<const char*>(data), size).append("</COLLADA>");
    const LoadOptions options = withoutFiles();
    Diagnostics diagnostics;
    DocumentSet documents(options, diagnostics);
    Dialects dialects(options, diagnostics);
    try {
        readAll(documents
                    .openMemory({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "fuzz.dae")
                    .root(),
                documents, diagnostics, dialects);
    } catch (const LoadError&) {  // no document
    }
    return 0;
}
