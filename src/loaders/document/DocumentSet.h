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

// The document of a load (the root document) and the others that it refers to, each loaded once.
class DocumentSet {
public:
    // Reports to `progress`, if not null, as documents are parsed.
    DocumentSet(const LoadOptions& options, Diagnostics& diagnostics, LoadProgress* progress = nullptr);
    ~DocumentSet();

    // Opens the root document. Throws LoadError if that is not possible.
    const ColladaDocument& openFile(const std::string& path);
    const ColladaDocument& openMemory(std::span<const std::uint8_t> bytes, const std::string& name);

    // The element that a URI in `from` refers to ("#id", "file.dae#id"; "id" alone is accepted for "#id"). If there is no
    // such element, returns nothing, and reports nothing. A document that cannot be opened is reported as `unopened`.
    XmlNode resolve(const XmlNode& from, std::string_view uri, Severity unopened = Severity::Error);

    // The same for a reference that must lead to an element of that name (empty: of any name). Otherwise reports WC0201,
    // WC0202 or WC0207 and returns nothing. `attribute` is the one that holds the URI ("url", "source"); "" means the
    // element's text.
    XmlNode follow(const XmlNode& from, const char* attribute, std::string_view elementName,
                   Severity severity = Severity::Error);

    // Reads a file beside the document (a picture) from the archive, the resolver or the disk. Returns nothing if it is not
    // there. `path` is the decoded path of the URI, relative to the document's folder or absolute. `foundPath` becomes the
    // path of the file that was read. If `most` is given, the result may end after that many bytes.
    std::optional<Bytes> readBeside(const XmlNode& from, const std::string& path, std::string& foundPath,
                                    std::size_t most = SIZE_MAX);
    // Reads a file that the caller of the load has named: from the resolver if there is one (returns nothing if it has no
    // such file), or else from disk. Throws FileError.
    std::optional<Bytes> readAsGiven(const std::string& path);
    // Returns false if there is certainly no such folder.
    bool mayHaveBeside(const XmlNode& from, const std::string& folder) const;
    // The path of a file on disk, as readBeside() returns it in `foundPath`; empty if there is no such file on disk or it may
    // not be read. Reports nothing.
    std::string plainFileBeside(const XmlNode& from, const std::string& path) const;
    // Names of the files (not folders) in a folder, relative to the document's; for the search for a picture.
    std::vector<std::string> listBeside(const XmlNode& from, const std::string& folder);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace walkcycle
