#include "app/CheckReport.h"

#include <nlohmann/json.hpp>

#include "app/Messages.h"

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
                 {"cure", diagnostic.cure}};
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
                 {"validatorVersion", WALKCYCLE_VERSION},
                 {"issues",
                  {{"numErrors", counts.errors},
                   {"numWarnings", counts.warnings},
                   {"numInfos", counts.infos},
                   {"numHints", 0},
                   {"messages", messages},
                   {"truncated", truncated}}}};
    if (report.loaded) json["info"] = facts(report);
    return json;
}

}  // namespace

std::string reportsJson(const std::vector<CheckReport>& reports) {
    Json json = Json::array();
    for (const CheckReport& report : reports) json.push_back(toJson(report));
    return (reports.size() == 1 ? json.front() : json).dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

}  // namespace walkcycle
