#include "loaders/document/DocumentSet.h"

#include <cstddef>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "io/Uri.h"
#include "loaders/document/KnownElements.h"
#include "loaders/document/LimitCheck.h"
#include "loaders/document/LoadProgress.h"
#include "loaders/document/Surroundings.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace fs = std::filesystem;

struct DocumentSet::Impl {
    const LoadOptions& options;
    Diagnostics& diagnostics;
    LoadProgress* progress;  // null: progress is not reported
    Surroundings surroundings;
    // By path; null if it cannot be opened.
    std::unordered_map<std::string, std::shared_ptr<ColladaDocument>> documents;

    const ColladaDocument& add(Bytes bytes, const std::string& file, LoadProgress* parsing = nullptr) {
        auto document =
            std::make_shared<ColladaDocument>(std::move(bytes), file, options.limits, diagnostics, parsing);
        return *(documents[fs::path(file).lexically_normal().string()] = std::move(document));
    }

    const ColladaDocument& addOther(Bytes bytes, const fs::path& path) {
        const ColladaDocument& document = add(std::move(bytes), path.string());
        checkElements(document.root(), diagnostics);
        if (progress) progress->alsoRead(document.root());
        return document;
    }

    const ColladaDocument& addRoot(Bytes bytes, const std::string& file) {
        if (progress) progress->documentIs(0.2);  // in memory
        requireWithin(options.limits, &LoadLimits::maxFileBytes, bytes.size(), file, 0, diagnostics);
        try {
            if (looksLikeGzip(bytes))
                return add(gunzip(bytes, archiveLimits(options.limits)), file, progress);
            if (!looksLikeZip(bytes)) return add(std::move(bytes), file, progress);
            Archive archive(std::move(bytes), archiveLimits(options.limits));
            std::string doubt;
            const std::string member = archive.rootDocument(&doubt);
            if (!doubt.empty()) diagnostics.report(Code::RootGuessed, file, 1, {doubt, member});
            Bytes document = archive.read(member);
            surroundings.useArchive(std::move(archive));
            return add(std::move(document), member, progress);
        } catch (const ArchiveTooLarge& error) {
            requireWithin(options.limits, limitOf(error), error.amount, file, 0, diagnostics);
            throw;
        } catch (const ArchiveError& error) {
            diagnostics.fail(Code::ArchiveBroken, file, 1, {error.what()});
        }
    }

    static XmlNode rootOf(const std::shared_ptr<ColladaDocument>& document) {
        return document ? document->root() : XmlNode();
    }

    // The root of the document whose file name differs from that of `path` only in case; it may be open already.
    XmlNode inAnyCase(const XmlNode& from, const fs::path& path) {
        const std::string name =
            inAnotherCase(surroundings.list(path.parent_path()), path.filename().string());
        if (name.empty()) return {};
        const fs::path actual = path.parent_path() / name;
        if (!documents[actual.string()]) {
            if (std::optional<Bytes> bytes = surroundings.read(from, actual))
                addOther(std::move(*bytes), actual);
        }
        return rootOf(documents[path.string()] = documents[actual.string()]);
    }

    // The root of the other document at `path`, relative to that of `from`. The document is opened once; if that fails, it
    // is reported once, and nothing is returned.
    XmlNode other(const XmlNode& from, const std::string& path, Severity unopened) {
        const fs::path ownFile(from.file());
        if (fs::path(path) == ownFile.filename()) return from.root();  // a document that names itself
        const fs::path full = (ownFile.parent_path() / path).lexically_normal();
        if (const auto known = documents.find(full.string()); known != documents.end())
            return rootOf(known->second);
        requireWithin(options.limits, &LoadLimits::maxDocuments, documents.size(), from, diagnostics);
        documents[full.string()] = nullptr;
        return open(from, full, unopened);
    }

    XmlNode open(const XmlNode& from, const fs::path& path, Severity unopened) {
        std::string reason = "there is no such file";
        try {
            if (std::optional<Bytes> bytes = surroundings.read(from, path))
                return addOther(std::move(*bytes), path).root();
            if (const XmlNode root = inAnyCase(from, path)) return root;
        } catch (const LoadError& error) {
            // The fault itself has been reported with its own file and line.
            if (error.cancelled()) throw;
            reason = error.reason().message;
        } catch (const FileTooLarge& error) {
            reason = limitText(error.amount, options.limits, &LoadLimits::maxFileBytes);
        } catch (const FileError& error) {
            reason = error.what();
        } catch (const ArchiveError& error) {
            reason = error.what();
        }
        diagnostics.report(unopened, Code::ExternalMissing, from,
                           {path.string(), std::string(from.name()), reason});
        return {};
    }
};

DocumentSet::DocumentSet(const LoadOptions& options, Diagnostics& diagnostics, LoadProgress* progress)
    : impl_(new Impl{options, diagnostics, progress, {options, diagnostics}, {}}) {}
DocumentSet::~DocumentSet() = default;

const ColladaDocument& DocumentSet::openFile(const std::string& path) {
    if (impl_->progress) impl_->progress->documentIs(0.0);
    Bytes bytes;
    try {
        bytes = readFile(path, impl_->options.limits.maxFileBytes);
    } catch (const FileTooLarge& error) {
        requireWithin(impl_->options.limits, &LoadLimits::maxFileBytes, error.amount, path, 0,
                      impl_->diagnostics);
        throw;
    } catch (const FileError& error) {
        impl_->diagnostics.fail(Code::FileUnreadable, path, 0, {error.what()});
    }
    if (path != "-") impl_->surroundings.useFolder(fs::path(path).parent_path());
    return impl_->addRoot(std::move(bytes), path);
}

const ColladaDocument& DocumentSet::openMemory(std::span<const std::uint8_t> bytes, const std::string& name) {
    return impl_->addRoot(Bytes(bytes.begin(), bytes.end()), name);
}

XmlNode DocumentSet::resolve(const XmlNode& from, std::string_view uri, Severity unopened) {
    if (!from || uri.empty()) return {};
    if (uri.front() == '#') {  // as nearly all; the id is tried undecoded first
        const XmlNode here = from.elementById(uri.substr(1));
        return here ? here : from.elementById(percentDecode(uri.substr(1)));
    }
    if (uri.find('#') == std::string_view::npos) return from.elementById(uri);  // "id" is accepted for "#id"
    const Uri parts = parseUri(uri);
    if (!parts.scheme.empty() && parts.scheme != "file") return {};
    if (parts.path.empty()) return from.elementById(parts.fragment);  // " #id"
    return impl_->other(from, parts.path, unopened).elementById(parts.fragment);
}

XmlNode DocumentSet::follow(const XmlNode& from, const char* attribute, std::string_view elementName,
                            Severity severity) {
    const std::string uri = *attribute ? std::string(from.attribute(attribute)) : from.text();
    if (uri.empty() && *attribute && !from.has(attribute)) {
        impl_->diagnostics.report(severity, Code::MissingAttribute, from,
                                  {std::string(from.name()), attribute});
        return {};
    }
    const XmlNode target = resolve(from, uri, severity);
    if (!target) {
        impl_->diagnostics.report(severity, Code::UnresolvedReference, from, {std::string(from.name()), uri});
        return {};
    }
    if (!elementName.empty() && !target.is(elementName)) {
        impl_->diagnostics.report(
            severity, Code::WrongElement, from,
            {std::string(from.name()), uri, std::string(target.name()), std::string(elementName)});
        return {};
    }
    return target;
}

std::optional<Bytes> DocumentSet::readBeside(const XmlNode& from, const std::string& path,
                                             std::string& foundPath, std::size_t most) {
    const fs::path full = fs::path(from.file()).parent_path() / path;
    foundPath = full.lexically_normal().string();
    return impl_->surroundings.read(from, full, most);
}

std::optional<Bytes> DocumentSet::readAsGiven(const std::string& path) {
    if (impl_->options.resolver) return impl_->surroundings.resolved(path);
    return readFile(path, impl_->options.limits.maxFileBytes);
}

std::string DocumentSet::plainFileBeside(const XmlNode& from, const std::string& path) const {
    const fs::path full = fs::path(from.file()).parent_path() / path;
    return impl_->surroundings.isPlainFile(full) ? full.lexically_normal().string() : std::string();
}

bool DocumentSet::mayHaveBeside(const XmlNode& from, const std::string& folder) const {
    return impl_->surroundings.mayHave(fs::path(from.file()).parent_path() / folder);
}

std::vector<std::string> DocumentSet::listBeside(const XmlNode& from, const std::string& folder) {
    return impl_->surroundings.list(fs::path(from.file()).parent_path() / folder);
}

}  // namespace walkcycle
