#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "app/Commands.h"
#include "app/ExitCode.h"
#include "app/FormatNumber.h"
#include "app/ImageDifference.h"
#include "app/Messages.h"
#include "app/Numbers.h"
#include "app/PictureFile.h"
#include "io/ImageDecoder.h"
#include "walkcycle/io/File.h"

namespace walkcycle {
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 30;

struct CompareOptions {
    std::string a, b, metric = "rmse", output;
    std::optional<double> threshold;
};

void declare(CompareOptions& options, Arguments& arguments) {
    arguments.positional("A", "A picture", options.a, Arguments::Need::Required);
    arguments.positional("B", "Another picture, of the same size", options.b, Arguments::Need::Required);
    arguments.choice("--metric", {"ae", "rmse", "psnr", "ssim"},
                     "ae: count of pixels that differ; rmse: 0 to 1; psnr: decibels; ssim: 1 if equal (rmse)",
                     options.metric);
    arguments.option(
        "--threshold", "X",
        "The allowed difference: at most X for ae and rmse (0), at least X for psnr and ssim",
        [&options](const std::string& text) { options.threshold = parseNumber(text, "--threshold"); });
    arguments.option("--output,-o", "FILE", "Write a picture of the differences, made four times brighter",
                     options.output);
    arguments.examples("  walkcycle compare before.png after.png --metric ssim --threshold 0.99\n");
}

Image read(const std::string& path) {
    try {
        return decodeImage(readFile(path, kMaxFileBytes));
    } catch (const ImageError& error) {
        throw FileError("cannot read '" + path + "': " + error.what());
    }
}

double value(const ImageDifference& difference, const std::string& metric) {
    if (metric == "ae") return static_cast<double>(difference.pixels);
    if (metric == "psnr") return difference.psnr;
    return metric == "ssim" ? difference.ssim : difference.rmse;
}

bool alike(double measured, const CompareOptions& options) {
    const bool moreIsBetter = options.metric == "psnr" || options.metric == "ssim";
    if (!moreIsBetter) return measured <= options.threshold.value_or(0.0);
    const double equal = options.metric == "psnr" ? std::numeric_limits<double>::infinity() : 1.0;
    return measured >= options.threshold.value_or(equal);
}

int run(const CompareOptions& options) {
    const Image a = read(options.a), b = read(options.b);
    if (a.width != b.width || a.height != b.height) {
        printError("the pictures differ in size: " + std::to_string(a.width) + " x " +
                   std::to_string(a.height) + " and " + std::to_string(b.width) + " x " +
                   std::to_string(b.height));
        return kFaultsFound;
    }
    const ImageDifference difference = compare(a, b);
    if (!options.output.empty()) writePicture(options.output, difference.picture);
    const double measured = value(difference, options.metric);
    printOut((std::isinf(measured) ? "inf" : formatNumber(measured)) + "\n");
    return alike(measured, options) ? kFine : kFaultsFound;
}

}  // namespace

Command compareCommand() {
    const auto options = std::make_shared<CompareOptions>();
    return {"How much two pictures differ", [options](Arguments& arguments) { declare(*options, arguments); },
            [options] { return run(*options); }};
}

}  // namespace walkcycle
