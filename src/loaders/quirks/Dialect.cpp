#include "loaders/quirks/Dialect.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "loaders/document/Diagnostics.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {
namespace {

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kQuirkCount; ++i)
        if (kQuirks[i].quirk != static_cast<Quirk>(i)) return false;
    return true;
}
static_assert(isInOrder(), "kQuirks has a row for each Quirk, in the order of the enum");

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Ignores case, since exporters have changed the case of their own names.
std::size_t findWord(std::string_view text, std::string_view word) {
    const auto same = [](char a, char b) { return lowerCase(a) == lowerCase(b); };
    const auto found = std::search(text.begin(), text.end(), word.begin(), word.end(), same);
    return found == text.end() ? std::string_view::npos : static_cast<std::size_t>(found - text.begin());
}

// Parses "6.4.112", "v2.03b", "v3.04_FREE", "2011": a number, not followed by letters as in "3ds" (one letter is allowed).
std::optional<ToolVersion> parseVersion(std::string_view word) {
    if (word.starts_with('v') || word.starts_with('V')) word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    ToolVersion version;
    auto [rest, error] = std::from_chars(word.data(), end, version.major);
    if (error != std::errc() || version.major < 0) return std::nullopt;
    if (rest != end && *rest == '.') {
        const auto minor = std::from_chars(rest + 1, end, version.minor);
        if (minor.ec == std::errc()) rest = minor.ptr;
    }
    const auto isLetter = [](char c) { return lowerCase(c) >= 'a' && lowerCase(c) <= 'z'; };
    const bool isWord = end - rest > 1 && isLetter(rest[0]) && isLetter(rest[1]);
    return isWord ? std::nullopt : std::optional(version);
}

// The first version in the text behind a tool's name, up to the '|' or ';' before the next tool.
std::optional<ToolVersion> versionAfter(std::string_view text) {
    constexpr std::string_view kSpaces = " \t\r\n";
    text = text.substr(0, text.find_first_of("|;"));
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
        if (text.empty()) return std::nullopt;
        const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
        if (const auto version = parseVersion(word)) return version;
        text.remove_prefix(word.size());
    }
}

// The first <authoring_tool> that is not empty: a contributor may leave it out.
std::string authoringToolOf(XmlNode collada) {
    for (XmlNode contributor : collada.child("asset").children("contributor"))
        if (std::string tool = contributor.child("authoring_tool").text(); !tool.empty()) return tool;
    return {};
}

std::optional<bool> choiceOf(const QuirkInfo& info, const LoadOptions& options) {
    if (const auto chosen = options.quirks.find(std::string(info.name)); chosen != options.quirks.end())
        return chosen->second;
    if (info.quirk == Quirk::SkinByNode && options.skinNode != SkinNode::Auto)
        return options.skinNode == SkinNode::Apply;
    return std::nullopt;
}

bool isOnFor(const QuirkInfo& info, const Exporter& exporter) {
    const bool anyTool = info.tools.front().tool == Tool::Unknown;
    return anyTool || std::any_of(info.tools.begin(), info.tools.end(),
                                  [&](const ToolRange& range) { return isIn(exporter, range); });
}

}  // namespace

Exporter exporterOf(std::string_view authoringTool) {
    for (const ToolInfo& info : kTools) {
        const std::size_t at = findWord(authoringTool, info.name);
        if (at == std::string_view::npos) continue;
        return {info.tool, versionAfter(authoringTool.substr(at + info.name.size()))};
    }
    return {};
}

bool isIn(const Exporter& exporter, const ToolRange& range) {
    constexpr ToolVersion kNone;
    if (exporter.tool != range.tool || range.tool == Tool::Unknown) return false;
    if (range.from == kNone && range.before == kNone) return true;
    if (!exporter.version) return false;
    return *exporter.version >= range.from && (range.before == kNone || *exporter.version < range.before);
}

Dialect::Dialect(std::string authoringTool, const LoadOptions& options)
    : authoringTool_(std::move(authoringTool)), exporter_(exporterOf(authoringTool_)) {
    for (const QuirkInfo& info : kQuirks) {
        State& state = states_[static_cast<std::size_t>(info.quirk)];
        const std::optional<bool> choice = choiceOf(info, options);
        state.chosen = choice.has_value();
        state.on = choice.value_or(isOnFor(info, exporter_));
    }
}

std::string Dialect::why(Quirk quirk) const {
    const std::string tools = toolsOf(infoOf(quirk));
    if (stateOf(quirk).chosen) return "as chosen";
    if (tools.empty()) return "where the file shows it";
    return (follows(quirk) ? "for " : "only for ") + tools;
}

Dialect& Dialects::entryOf(const XmlNode& element) {
    const XmlNode collada = element.root();
    const auto known = byDocument_.find(collada);
    if (known != byDocument_.end()) return known->second;
    return byDocument_.try_emplace(collada, authoringToolOf(collada), options_).first->second;
}

void Dialects::note(Quirk quirk, const XmlNode& where) {
    const QuirkInfo& row = infoOf(quirk);
    bool& used = entryOf(where).states_[static_cast<std::size_t>(quirk)].used;
    const std::string_view rule = row.rule.substr(0, row.rule.rfind('.'));
    if (!used && row.code == info(Code::QuirkFollowed).id)
        diagnostics_.report(Code::QuirkFollowed, where, {std::string(row.name), std::string(rule)});
    used = true;
}

}  // namespace walkcycle
