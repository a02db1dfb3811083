#include "DiagnosticsPage.h"

#include <algorithm>
#include <map>
#include <vector>

#include "app/OptionHints.h"
#include "loaders/document/MessageTemplate.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle::house {
namespace {

struct Row {
    int number;
    const char* name;
    Severity severity;
    const char* text;
    const char* cause;
    const char* cure;
    const char* inBlender = "";
    const char* inMaya = "";
    const char* in3dsMax = "";
};

const Row kCatalogue[] = {
#define WC_CODE(number, name, severity, text, cause, ...) \
    {number, #name, Severity::severity, text, cause, __VA_ARGS__},
#include "loaders/document/DiagnosticCodes.inc"
#undef WC_CODE
};

std::string idOf(const Row& row) {  // 207: "WC0207"
    return "WC" + std::to_string(10000 + row.number).substr(1);
}

// The first two digits of a code say what it is about.
std::string chapterOf(const std::string& id) {
    static const std::map<std::string, std::string> chapters{
        {"01", "The document as a whole"},
        {"02", "References, sources, numbers"},
        {"03", "Geometry"},
        {"04", "Skins and morphs"},
        {"05", "Animation"},
        {"06", "Materials and pictures"},
        {"07", "The scene"},
        {"08", "Limits"},
        {"09", "Outside the file"},
        {"10", "What other programs make of it"},
    };
    const auto chapter = chapters.find(id.substr(2, 2));
    return chapter == chapters.end() ? "Others" : chapter->second;
}

// Keeps <element> from being taken for HTML.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

}  // namespace

std::string diagnosticsPage() {
    std::string page =
        "# What Walkcycle says about a file\n\n"
        "Messages have the form `file:line: severity code: text, in element (cure)`. An error means that "
        "something of "
        "the file is "
        "lost or wrong in the picture; a warning, that Walkcycle had to guess; an info, that something is "
        "unusual and "
        "handled. `walkcycle explain WC0201` prints an entry of this page. Words in capitals stand for what "
        "a "
        "message takes from the file.\n\n"
        "Where an option of the program does what the cure says, it stands behind the colon.\n\n"
        "This page is made from `src/loaders/document/DiagnosticCodes.inc` and `src/app/OptionHints.h`; do "
        "not edit "
        "it.\n";
    std::string chapter;
    std::vector<Row> rows(std::begin(kCatalogue), std::end(kCatalogue));
    std::ranges::sort(rows, {}, &Row::number);
    for (const Row& row : rows) {
        const std::string id = idOf(row);
        if (chapterOf(id) != chapter) page += "\n## " + (chapter = chapterOf(id)) + "\n";
        page += "\n### " + id + " " + row.name + "\n\n";
        page += "*" + std::string(nameOf(row.severity)) + "*: " + escaped(withWords(row.text)) + "\n\n";
        page += escaped(row.cause) + "\n\n";
        page += "Cure: " + escaped(withOption(id, withWords(row.cure))) + ".\n";
        if (!*row.inBlender) continue;
        page += "\n- Blender: " + escaped(row.inBlender) + "\n";
        page += "- Maya: " + escaped(row.inMaya) + "\n";
        page += "- 3ds Max: " + escaped(row.in3dsMax) + "\n";
    }
    return page;
}

}  // namespace walkcycle::house
