#include "app/LoadArguments.h"

#include <algorithm>

#include "app/ExitCode.h"
#include "app/Numbers.h"
#include "loaders/ColladaLoader.h"
#include "loaders/Diagnostics.h"

namespace walkcycle {
namespace {

UpAxis parseAxis(const std::string& text) {
    if (text == "X" || text == "x" || text == "X_UP") return UpAxis::X;
    if (text == "Y" || text == "y" || text == "Y_UP") return UpAxis::Y;
    if (text == "Z" || text == "z" || text == "Z_UP") return UpAxis::Z;
    throw UsageError("--up: '" + text + "' is not an axis: X, Y or Z");
}

// To be called for each option that was set, so that what is wrong is wrong with that one.
void requireUsable(const LoadOptions& options, const std::string& what) {
    try {
        requireValid(options);
    } catch (const InvalidOption& error) {
        throw UsageError(what + " " + error.must);
    }
}

std::string limitNames() {
    std::string names;
    for (const LimitInfo& limit : kLimits) names += (names.empty() ? "" : ", ") + std::string(limit.name);
    return names;
}

void setLimit(const std::string& text, LoadOptions& options) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const LimitInfo* limit = findLimit(name);
    if (!limit) throw UsageError("--limit: '" + name + "' is not a limit; there are " + limitNames());
    if (equals == text.size()) throw UsageError("--limit: give a value, as in " + name + "=" + "1000");
    options.limits.*limit->value = parseSize(text.substr(equals + 1), "--limit " + name);
    requireUsable(options, "--limit: " + name);
}

}  // namespace

void LoadArguments::declare(Arguments& arguments) {
    arguments.group("Reading the file");
    arguments.option("--texture", "FILE", "Use this picture for every diffuse texture", options.texture);
    arguments.options("--allow-path", "DIR", "Let the document refer to files in this folder, too",
                      options.allowedPaths);
    arguments.option("--scene", "ID", "The visual scene to show, by id or name", options.scene);
    arguments.flag("--no-convert", "Keep the document's own axes and unit (otherwise Y up, metres)",
                   noConvert_);
    arguments.option("--up", "X|Y|Z", "The axis that is up, instead of the document's own",
                     [this](const std::string& text) { options.upAxis = parseAxis(text); });
    arguments.option("--unit", "METRES", "Metres per unit, instead of the document's own",
                     [this](const std::string& text) {
                         options.metersPerUnit = parseNumber(text, "--unit");
                         requireUsable(options, "--unit: '" + text + "'");
                     });
    arguments.choice("--skin-node", {"auto", "apply", "ignore"},
                     "Whether a skin's node moves it as well as its joints do", skinNode_);
    arguments.option("--tolerance", "SHARE",
                     "Largest error of the keyframes, as a share of the model's size (1e-4)",
                     [this](const std::string& text) {
                         options.tolerance = parseNumber(text, "--tolerance");
                         requireUsable(options, "--tolerance: '" + text + "'");
                     });
    arguments.flag("--strict", "Take warnings for errors: end with 1 where the file has any", strict);
    arguments.flag("--verbose,-v", "Say more: also notes, and what was found and chosen", verbose);
    arguments.flag("--quiet,-q", "Say nothing but what stops the program", quiet);
    declareLimits(arguments);
}

void LoadArguments::declareLimits(Arguments& arguments) {
    arguments.eachOption(
        "--limit", "NAME=VALUE",
        "Raise or lower what a load may cost: file-bytes=2G (k, M and G are of 1024; a wrong NAME "
        "lists them all)",
        [this](const std::string& text) { setLimit(text, options); });
}

Model LoadArguments::loadSilently(const std::string& file) const {
    LoadOptions chosen = options;
    if (noConvert_) chosen.convert = false;
    chosen.skinNode = skinNode_ == "apply"    ? SkinNode::Apply
                      : skinNode_ == "ignore" ? SkinNode::Ignore
                                              : SkinNode::Auto;
    Progress progress("loading", !quiet);
    if (!chosen.progress && progress.isShown())
        chosen.progress = [&progress](double share) { progress.update(share); };
    return loadCollada(file, chosen);
}

Model LoadArguments::load(const std::string& file) const {
    const Severity least = quiet ? Severity::Error : verbose ? Severity::Info : Severity::Warning;
    try {
        Model model = loadSilently(file);
        if (!quiet) printDiagnostics(model.diagnostics, least);
        const DiagnosticCounts counts = count(model.diagnostics);
        if (strict && counts.errors + counts.warnings > 0) throw StrictFailure{};
        return model;
    } catch (const LoadError& error) {
        printDiagnostics(quiet ? std::span(error.diagnostics).last(1) : std::span(error.diagnostics), least);
        throw;
    }
}

}  // namespace walkcycle
