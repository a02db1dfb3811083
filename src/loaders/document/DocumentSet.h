#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/document/ColladaDocument.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/io/Bytes.h"
#include "walkcycle/loaders/LoadOptions.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

class LoadProgress;

// The document that was asked for and the others that it refers to, each loaded once.
class DocumentSet {
public:
    // `progress`, if not null, is told of each document that is parsed.
    DocumentSet(const LoadOptions& options, Diagnostics& diagnostics, LoadProgress* progress = nullptr);
    ~DocumentSet();

    const ColladaDocument& openFile(const std::string& path);
    const ColladaDocument& openMemory(std::span<const std::uint8_t> bytes, const std::string& name);

    // The element that a URI ("#id", "file.dae#id", "id" alone as a courtesy) in `from` leads to; nothing (not
    // reported) where it leads nowhere. A document that cannot be opened is reported, as what it is for this reference.
    XmlNode resolve(const XmlNode& from, std::string_view uri, Severity unopened = Severity::Error);

    // The same for a reference that must be there: reports WC0201 / WC0207 and gives nothing where it does not lead to
    // an element of that name (empty: any). `attribute` names where the URI stands ("url", "source"); the element's
    // text for "".
    XmlNode follow(const XmlNode& from, const char* attribute, std::string_view elementName,
                   Severity severity = Severity::Error);

    // Reads a file beside the document (a picture): archive member, resolver or disk. Empty optional: not there.
    // `path` is as the URI gave it, decoded, relative to the document's folder or absolute. foundPath names what was read.
    // Where `most` bytes of its start are enough, it may be no more than those.
    std::optional<Bytes> readBeside(const XmlNode& from, const std::string& path, std::string& foundPath,
                                    std::size_t most = SIZE_MAX);
    // Reads a file that the caller of the load names: from the resolver, if there is one (nothing: it has none), or from
    // disk. Throws FileError.
    std::optional<Bytes> readAsGiven(const std::string& path);
    // False where such a folder is certainly not there.
    bool mayHaveBeside(const XmlNode& from, const std::string& folder) const;
    // Where a relative path leads on disk, spelt as readBeside() does; empty where that is not a file that may be read, or
    // not on disk. Says nothing.
    std::string plainFileBeside(const XmlNode& from, const std::string& path) const;
    // Names of the files (not folders) in a folder relative to the document's; for looking for a picture.
    std::vector<std::string> listBeside(const XmlNode& from, const std::string& folder);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
