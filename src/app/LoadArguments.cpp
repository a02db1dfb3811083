#include "app/LoadArguments.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>

#include "app/ExitCode.h"
#include "app/Numbers.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/quirks/Dialect.h"
#include "walkcycle/loaders/ColladaLoader.h"

namespace walkcycle {
namespace {

UpAxis parseAxis(const std::string& text) {
    if (text == "X" || text == "x" || text == "X_UP") return UpAxis::X;
    if (text == "Y" || text == "y" || text == "Y_UP") return UpAxis::Y;
    if (text == "Z" || text == "z" || text == "Z_UP") return UpAxis::Z;
    throw UsageError("--up: '" + text + "' is not an axis: X, Y or Z");
}

// Called after each option is set, so that a fault is a fault of that option. `option` begins the message.
void requireUsable(const LoadOptions& options, const std::string& option) {
    try {
        requireValid(options);
    } catch (const InvalidOption& error) {
        throw UsageError(option + " " + error.must);
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
    if (!limit) throw UsageError("--limit: '" + name + "' is not a limit; the limits are " + limitNames());
    if (equals == text.size())
        throw UsageError("--limit: '" + text + "' has no value, as in " + name + "=" +
                         std::to_string(LoadLimits{}.*limit->value));
    options.limits.*limit->value = parseSize(text.substr(equals + 1), "--limit " + name);
    requireUsable(options, "--limit: " + name);
}

std::string quirkNames() {
    std::string names;
    for (const QuirkInfo& quirk : kQuirks) names += (names.empty() ? "" : ", ") + std::string(quirk.name);
    return names;
}

void setQuirk(const std::string& text, std::map<std::string, bool>& quirks) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    if (!findQuirk(name)) throw UsageError("--quirk: " + unknownQuirk(name) + "; there are " + quirkNames());
    const std::string choice = text.substr(std::min(equals + 1, text.size()));
    if (choice != "on" && choice != "off")
        throw UsageError("--quirk: say " + name + "=on or " + name + "=off, not '" + text + "'");
    quirks[name] = choice == "on";
}

}  // namespace

void LoadArguments::declare(Arguments& arguments) {
    arguments.group("Reading the file");
    arguments.option("--texture", "FILE", "Use this picture as every diffuse texture", options.texture);
    arguments.options("--allow-path", "DIR",
                      "Also allow the document to use files in this folder; may be repeated",
                      options.allowedPaths);
    arguments.option("--scene", "ID", "The visual scene to show, by id or name", options.scene);
    arguments.flag("--no-convert",
                   "Keep the document's own axes and unit, instead of converting to Y up and metres",
                   noConvert_);
    arguments.option("--up", "X|Y|Z", "The up axis, instead of the document's own",
                     [this](const std::string& text) { options.upAxis = parseAxis(text); });
    arguments.option("--unit", "METRES", "Metres per unit, instead of the document's own",
                     [this](const std::string& text) {
                         options.metersPerUnit = parseNumber(text, "--unit");
                         requireUsable(options, "--unit: '" + text + "'");
                     });
    arguments.choiceOf<SkinNode>(
        "--skin-node", {{"auto", SkinNode::Auto}, {"apply", SkinNode::Apply}, {"ignore", SkinNode::Ignore}},
        "Whether the node of a skin moves it, in addition to the skin's joints", options.skinNode);
    arguments.eachOption("--quirk", "NAME=on|off",
                         "Read the file with or without this quirk of exporters, whatever tool wrote it "
                         "(info --verbose lists them)",
                         [this](const std::string& text) { setQuirk(text, options.quirks); });
    arguments.option("--tolerance", "SHARE",
                     "The largest error of the key frames, as a share of the model's size (1e-4)",
                     [this](const std::string& text) {
                         options.tolerance = parseNumber(text, "--tolerance");
                         requireUsable(options, "--tolerance: '" + text + "'");
                     });
    arguments.flag("--strict", "End with exit code 1 if the file has errors or warnings", strict);
    arguments.flag("--verbose,-v", "Also print notes, and the choices of the program", verbose);
    arguments.flag("--quiet,-q", "Print only what stops the program", quiet);
    declareLimits(arguments);
}

void LoadArguments::declareLimits(Arguments& arguments) {
    arguments.eachOption(
        "--limit", "NAME=VALUE",
        "Raise or lower a limit of the loader, as in file-bytes=2G (k, M, G: powers of 1024); a wrong NAME "
        "lists all limits",
        [this](const std::string& text) { setLimit(text, options); });
}

Model LoadArguments::loadSilently(const std::string& file) const {
    LoadOptions chosen = options;
    if (noConvert_) chosen.convert = false;
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
