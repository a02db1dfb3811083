#include "Snippets.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <regex>
#include <stdexcept>

#include "SourceTree.h"

namespace walkcycle::house {
namespace {

// Walks C++ text from `start`, past comments and strings, to the first character of `wanted`.
std::size_t findOutsideText(const std::string& source, std::size_t start, const std::string& wanted) {
    for (std::size_t i = start; i < source.size(); ++i) {
        if (source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size() - 1);
        } else if (source.compare(i, 2, "/*") == 0) {
            i = std::min(source.find("*/", i), source.size() - 2) + 1;
        } else if (source[i] == '"' || source[i] == '\'') {
            const char quote = source[i];
            while (++i < source.size() && source[i] != quote) i += source[i] == '\\';
        } else if (wanted.find(source[i]) != std::string::npos) {
            return i;
        }
    }
    return std::string::npos;
}

std::size_t closingBrace(const std::string& source, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i != std::string::npos; i = findOutsideText(source, i + 1, "{}")) {
        depth += source[i] == '{' ? 1 : -1;
        if (depth == 0) return i;
    }
    return std::string::npos;
}

bool isType(const std::string& definition) {
    return definition.starts_with("struct ") || definition.starts_with("class ") ||
           definition.starts_with("enum ");
}

bool isConstant(const std::string& definition) {
    return definition.size() > 1 && definition[0] == 'k' &&
           std::isupper(static_cast<unsigned char>(definition[1]));
}

// Where the definition that begins in the line at `lineStart` ends, or nothing if the line only mentions the
// name.
std::optional<std::size_t> endOfDefinition(const std::string& source, std::size_t lineStart,
                                           const std::string& definition) {
    const std::size_t mark = findOutsideText(source, lineStart, "{;");
    if (mark == std::string::npos) return std::nullopt;
    if (isConstant(definition)) return findOutsideText(source, lineStart, ";") + 1;
    if (source[mark] != '{') return std::nullopt;
    const std::size_t close = closingBrace(source, mark);
    if (close == std::string::npos) return std::nullopt;
    return close + (source.compare(close + 1, 1, ";") == 0 ? 2 : 1);
}

std::regex beginningOf(const std::string& definition) {
    static const std::regex special(R"([.*+?()\[\]{}|^$\\])");
    const std::string name = std::regex_replace(definition, special, R"(\$&)");
    if (isType(definition)) return std::regex("^ *" + name + R"(\b.*)");
    if (isConstant(definition)) return std::regex(R"(^ *(?!//|return)[^(]*\b)" + name + R"(\b.*[={].*)");
    return std::regex(R"(^ *(?!//|return |else |#)[^(=.]*\b)" + name + R"(\(.*)");
}

bool belongsToNext(const std::string& line) {
    static const std::regex above(R"(^ *(//|template ?<).*)");
    return std::regex_match(line, above);
}

std::string withoutIndent(const std::string& text) {
    const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
    std::string result;
    for (const std::string& line : splitLines(text)) {
        result += line.substr(std::min({indent, line.find_first_not_of(' '), line.size()})) + '\n';
    }
    return result;
}

}  // namespace

std::vector<Fence> quotingFences(const std::string& page) {
    static const std::regex opening(R"(^```\w+ (\S*/\S+\.\w+|walkcycle) (\S.*)$)");
    std::vector<Fence> fences;
    const auto lines = splitLines(page);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].starts_with("```")) continue;
        Fence fence;
        fence.firstLine = i + 1;
        while (++i < lines.size() && !lines[i].starts_with("```")) fence.text += lines[i] + '\n';
        fence.endLine = i;
        std::smatch match;
        if (!std::regex_match(lines[fence.firstLine - 1], match, opening)) continue;
        fence.file = match[1];
        fence.definition = match[2];
        fences.push_back(fence);
    }
    return fences;
}

std::string findDefinition(const std::string& text, const std::string& definition) {
    if (definition == "*") return text;
    const std::string source =
        std::regex_replace(text, std::regex("WALKCYCLE_API "), "");  // no news to a reader
    const std::regex beginning = beginningOf(definition);
    std::vector<std::size_t> starts;  // of the lines so far
    std::size_t start = 0;
    for (const std::string& line : splitLines(source)) {
        starts.push_back(start);
        start += line.size() + 1;
        if (!std::regex_match(line, beginning)) continue;
        const auto end = endOfDefinition(source, starts.back(), definition);
        if (!end) continue;
        std::size_t first = starts.size() - 1;
        while (first > 0 &&
               belongsToNext(source.substr(starts[first - 1], starts[first] - starts[first - 1] - 1))) {
            --first;
        }
        const std::size_t lineEnd = std::min(source.find('\n', *end), source.size());
        return withoutIndent(source.substr(starts[first], lineEnd - starts[first]));
    }
    throw std::runtime_error("no definition of " + definition);
}

std::string quoted(const Fence& fence) {
    if (fence.file != "walkcycle") return findDefinition(readText(root() / fence.file), fence.definition);
    const std::string program = WALKCYCLE_PROGRAM;
    return program.empty() ? fence.text : outputOf("'" + program + "' " + fence.definition);
}

std::string withFreshQuotes(const std::string& page) {
    const auto lines = splitLines(page);
    std::string fresh;
    std::size_t next = 0;
    const auto copyUpTo = [&](std::size_t end) {
        for (; next < end; ++next) fresh += lines[next] + '\n';
    };
    for (const Fence& fence : quotingFences(page)) {
        copyUpTo(fence.firstLine);
        fresh += quoted(fence);
        next = fence.endLine;
    }
    copyUpTo(lines.size());
    return fresh;
}

}  // namespace walkcycle::house
