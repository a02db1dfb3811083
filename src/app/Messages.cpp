#include "app/Messages.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <unistd.h>

#include "app/OptionHints.h"
#include "walkcycle/io/File.h"

namespace walkcycle {
namespace {

constexpr double kSecondsBeforeProgress = 0.5;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool colorful() {
    static const bool wanted = [] {
        const char* noColor = std::getenv("NO_COLOR");
        const char* terminal = std::getenv("TERM");
        return ::isatty(STDERR_FILENO) && !(noColor && *noColor) &&
               !(terminal && std::string_view(terminal) == "dumb");
    }();
    return wanted;
}

void print(const std::string& line) {
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::string colored(std::string_view text, const char* color) {
    return colorful() ? std::string("\033[") + color + "m" + std::string(text) + "\033[0m"
                      : std::string(text);
}

// The diagnostic as one line, with the word of its severity in colour.
std::string highlighted(const Diagnostic& diagnostic) {
    std::string line = toString(withOption(diagnostic));
    const std::string_view word = nameOf(diagnostic.severity);
    const char* color = diagnostic.severity == Severity::Error     ? "1;31"
                        : diagnostic.severity == Severity::Warning ? "1;33"
                                                                   : "36";
    const std::size_t at = line.find(": " + std::string(word) + " ");
    if (!colorful() || at == std::string::npos) return line;
    return line.replace(at + 2, word.size(), colored(word, color));
}

}  // namespace

// Messages of drivers and libraries may have line breaks, which become spaces.
void printError(const std::string& text) {
    std::string message = text.substr(0, text.find_last_not_of("\n\r ") + 1);
    std::replace_if(
        message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    print("walkcycle: " + colored("error", "1;31") + ": " + message + "\n");
}

void printNote(const std::string& message) {
    print("walkcycle: " + message + "\n");
}

void printDiagnostics(std::span<const Diagnostic> diagnostics, Severity least) {
    std::string lines;
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.severity >= least) lines += highlighted(diagnostic) + "\n";
    print(lines);
}

DiagnosticCounts count(std::span<const Diagnostic> diagnostics) {
    DiagnosticCounts counts;
    for (const Diagnostic& diagnostic : diagnostics) {
        int& number = diagnostic.severity == Severity::Error     ? counts.errors
                      : diagnostic.severity == Severity::Warning ? counts.warnings
                                                                 : counts.infos;
        number += 1 + diagnostic.repeats;
    }
    return counts;
}

void printOut(const std::string& text) {
    writeFile("-", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

Progress::Progress(std::string what, bool wanted)
    : what_(std::move(what)), wanted_(wanted && ::isatty(STDERR_FILENO)), start_(now()) {}

void Progress::update(double share) {
    if (!wanted_ || now() - start_ < kSecondsBeforeProgress) return;
    const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100.0);
    if (percent == shown_) return;
    shown_ = percent;
    print("\r" + what_ + " " + std::to_string(percent) + " % ");
}

void Progress::clear() {
    if (shown_ >= 0) print("\r" + std::string(what_.size() + 7, ' ') + "\r");
    shown_ = -1;
}

}  // namespace walkcycle
