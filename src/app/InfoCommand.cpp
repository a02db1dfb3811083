#include <memory>
#include <optional>
#include <string>

#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/InfoText.h"
#include "app/LoadArguments.h"
#include "app/Messages.h"
#include "app/SharedOptions.h"
#include "loaders/Inspection.h"
#include "loaders/quirks/Dialect.h"

namespace walkcycle {
namespace {

struct InfoOptions {
    LoadArguments load;
    std::string file;
    bool json = false;
};

void declare(InfoOptions& options, Arguments& arguments) {
    declareDocument(arguments, options.file);
    arguments.flag("--json", "Print JSON", options.json);
    options.load.declare(arguments);
    arguments.examples("  walkcycle info hero.dae\n  walkcycle info hero.dae --json | jq .clips\n");
}

int run(const InfoOptions& options) {
    LoadArguments load = options.load;
    load.options.imagePixels = false;  // of pictures, only the sizes are printed
    std::optional<Dialect> dialect;
    load.options.inspector = [&](const Inspection& inspection) {
        dialect = inspection.context.dialects.of(inspection.collada);
    };
    const Model model = load.load(options.file);
    printOut(options.json ? infoJson(model, *dialect) : infoText(model, load.verbose ? &*dialect : nullptr));
    return kFine;
}

}  // namespace

Command infoCommand() {
    const auto options = std::make_shared<InfoOptions>();
    return {"What is in a file: axes, unit, joints, clips, meshes, materials, textures",
            [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
