#include "app/CheckReport.h"

#include <cstddef>

#include <nlohmann/json.hpp>

#include "app/Messages.h"
#include "app/OptionHints.h"

namespace walkcycle {
namespace {

using Json = nlohmann::ordered_json;

// The validator's numbers: 0 error, 1 warning, 2 info.
int severityNumber(Severity severity) {
    return severity == Severity::Error ? 0 : severity == Severity::Warning ? 1 : 2;
}

Json message(const Diagnostic& diagnostic, const std::string& file) {
    Json json = {{"code", diagnostic.code},
                 {"message", diagnostic.message},
                 {"severity", severityNumber(diagnostic.severity)},
                 {"pointer", diagnostic.elementPath},
                 {"line", diagnostic.line},
                 {"cure", withOption(diagnostic.code, diagnostic.cure)}};
    if (diagnostic.repeats > 0) json["repeats"] = diagnostic.repeats;
    if (!diagnostic.file.empty() && diagnostic.file != file)
        json["uri"] = diagnostic.file;  // another document
    return json;
}

Json facts(const CheckReport& report) {
    return {{"version", report.version},
            {"generator", report.authoringTool},
            {"animationCount", report.facts.clips.size()},
            {"meshCount", report.facts.meshes.size()},
            {"jointCount", report.facts.joints},
            {"totalVertexCount", report.facts.drawnVertices},
            {"totalTriangleCount", report.facts.drawnTriangles},
            {"maxInfluences", report.facts.maxInfluences}};
}

Json toJson(const CheckReport& report) {
    const DiagnosticCounts counts = count(report.diagnostics);
    Json messages = Json::array();
    bool truncated = false;
    for (const Diagnostic& diagnostic : report.diagnostics) {
        messages.push_back(message(diagnostic, report.file));
        truncated |= diagnostic.repeats > 0;
    }
    Json json = {{"uri", report.file},
                 {"mimeType", "model/vnd.collada+xml"},
                 {"validatorVersion", WALKCYCLE_VERSION},
                 {"issues",
                  {{"numErrors", counts.errors},
                   {"numWarnings", counts.warnings},
                   {"numInfos", counts.infos},
                   {"numHints", 0},
                   {"messages", messages},
                   {"truncated", truncated}}}};
    if (!report.profiles.empty()) json["profiles"] = report.profiles;
    if (report.loaded) json["info"] = facts(report);
    return json;
}

std::string number(std::size_t n, const char* word) {
    return std::to_string(n) + " " + word + (n == 1 ? "" : "s");
}

std::string counted(const DiagnosticCounts& counts) {
    return number(static_cast<std::size_t>(counts.errors), "error") + ", " +
           number(static_cast<std::size_t>(counts.warnings), "warning") + ", " +
           number(static_cast<std::size_t>(counts.infos), "note");
}

bool isFine(const CheckReport& report) {
    return report.loaded && report.diagnostics.empty();
}

}  // namespace

std::string summary(const CheckReport& report) {
    if (report.diagnostics.empty()) return report.file + (report.loaded ? ": fine\n" : ": nothing to show\n");
    return report.file + ": " + counted(count(report.diagnostics)) +
           (report.loaded ? "\n" : "; nothing can be shown\n");
}

std::string total(const std::vector<CheckReport>& reports) {
    DiagnosticCounts sum;
    std::size_t fine = 0, lost = 0;
    for (const CheckReport& report : reports) {
        const DiagnosticCounts counts = count(report.diagnostics);
        sum.errors += counts.errors;
        sum.warnings += counts.warnings;
        sum.infos += counts.infos;
        fine += isFine(report);
        lost += !report.loaded;
    }
    return number(reports.size(), "file") + ", " + std::to_string(fine) + " fine: " + counted(sum) +
           (lost > 0 ? "; of " + number(lost, "file") + " nothing can be shown\n" : "\n");
}

std::string reportsJson(const std::vector<CheckReport>& reports, bool asArray) {
    Json json = Json::array();
    for (const CheckReport& report : reports) json.push_back(toJson(report));
    return (asArray ? json : json.front()).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace walkcycle
