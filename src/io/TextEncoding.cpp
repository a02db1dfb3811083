#include "io/TextEncoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include "io/TextScan.h"

namespace walkcycle {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

// The characters of Windows-1252 from 0x80 to 0x9f. The five undefined bytes stay control characters.
constexpr std::array<char32_t, 32> kWindows1252 = {
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

void append(std::string& text, char32_t c) {
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (c < 0x80) return put(c);
    if (c < 0x800) {
        put(0xC0 | (c >> 6));
    } else {
        if (c < 0x10000) {
            put(0xE0 | (c >> 12));
        } else {
            put(0xF0 | (c >> 18));
            put(0x80 | ((c >> 12) & 0x3F));
        }
        put(0x80 | ((c >> 6) & 0x3F));
    }
    put(0x80 | (c & 0x3F));
}

[[noreturn]] void fail(const std::string& what, std::size_t offset, int line) {
    throw EncodingError(what + " at byte " + std::to_string(offset), line);
}

int lineAt(ByteSpan bytes, std::size_t offset) {
    return 1 + static_cast<int>(
                   std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

std::string fromUtf16(ByteSpan bytes, bool bigEndian, std::size_t start) {
    std::string text;
    text.reserve(bytes.size() / 2 + bytes.size() / 8);
    int line = 1;
    const auto unit = [&](std::size_t i) -> char32_t {
        const char32_t a = bytes[i], b = bytes[i + 1];
        return bigEndian ? (a << 8) | b : (b << 8) | a;
    };
    for (std::size_t i = start; i < bytes.size(); i += 2) {
        if (i + 1 == bytes.size()) fail("half a UTF-16 character", i, line);
        char32_t c = unit(i);
        if (c >= 0xD800 && c < 0xE000) {  // a pair of surrogates stands for one character
            const char32_t low = c < 0xDC00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
            if (low < 0xDC00 || low >= 0xE000) fail("half a UTF-16 surrogate pair", i, line);
            c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
            i += 2;
        }
        if (c == '\n') ++line;
        append(text, c);
    }
    return text;
}

std::string fromWindows1252(ByteSpan bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 16);
    for (const std::uint8_t byte : bytes)
        append(text, byte >= 0x80 && byte < 0xA0 ? kWindows1252[byte - 0x80] : byte);
    return text;
}

// The number of bytes of the character at `i`; 0 if it is not valid UTF-8. Overlong forms and surrogates are
// not valid.
std::size_t utf8Length(ByteSpan bytes, std::size_t i) {
    const std::uint8_t lead = bytes[i];
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : (lead & 0xF0) == 0xE0       ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || length > bytes.size() - i) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((bytes[i + k] & 0xC0) != 0x80) return 0;
    if (lead == 0xE0 && bytes[i + 1] < 0xA0) return 0;
    if (lead == 0xED && bytes[i + 1] >= 0xA0) return 0;
    if (lead == 0xF0 && bytes[i + 1] < 0x90) return 0;
    if (lead == 0xF4 && bytes[i + 1] >= 0x90) return 0;
    return length;
}

std::string_view viewOf(ByteSpan bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::optional<std::size_t> firstInvalidUtf8(ByteSpan bytes) {
    for (std::size_t i = findBeyondAscii(viewOf(bytes)); i < bytes.size();) {
        const std::size_t length = utf8Length(bytes, i);
        if (length == 0) return i;
        i += length;
        if (i < bytes.size() && bytes[i] < 0x80) i = findBeyondAscii(viewOf(bytes), i);
    }
    return std::nullopt;
}

struct Span {
    std::size_t begin = 0, end = 0;
};

// The position of the name in <?xml version="1.0" encoding="...">; empty if there is none.
Span declaredEncoding(std::string_view text) {
    const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::string_view head = text.substr(start, 1024);
    if (!head.starts_with("<?xml")) return {};
    const std::string_view declaration = head.substr(0, head.find("?>"));
    std::size_t at = declaration.find("encoding");
    if (at == std::string_view::npos) return {};
    at = declaration.find_first_of("\"'", at);
    if (at == std::string_view::npos) return {};
    const std::size_t end = declaration.find(declaration[at], at + 1);
    if (end == std::string_view::npos) return {};
    return {start + at + 1, start + end};
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

bool isLatin1(const std::string& name) {
    constexpr std::array<std::string_view, 9> kNames = {"iso-8859-1", "iso8859-1", "iso_8859-1",
                                                        "latin1",     "latin-1",   "l1",
                                                        "cp1252",     "cp-1252",   "windows-1252"};
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// Decodes Latin-1 (as Windows-1252) if the declaration names it, otherwise UTF-8. If the bytes are not valid
// UTF-8 and `guessed` is given, decodes Windows-1252.
std::string from8Bit(ByteSpan bytes, bool* guessed) {
    const std::string_view raw = viewOf(bytes);
    const Span span = declaredEncoding(raw);
    const std::string name = lowerCase(raw.substr(span.begin, span.end - span.begin));
    if (isLatin1(name)) return fromWindows1252(bytes);
    const std::optional<std::size_t> invalid = firstInvalidUtf8(bytes);
    if (!invalid) return std::string(raw);
    if (guessed) {
        *guessed = true;
        return fromWindows1252(bytes);
    }
    const bool claimsUtf8 = name.empty() || name == "utf-8" || name == "utf8";
    fail(claimsUtf8 ? "not valid UTF-8"
                    : "the encoding '" + name + "' is not known, and the text is not UTF-8",
         *invalid, lineAt(bytes, *invalid));
}

std::string decode(ByteSpan bytes, bool* guessed) {
    const auto startsWith = [bytes](std::initializer_list<int> mark) {
        return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
    };
    if (startsWith({0xFF, 0xFE, 0, 0}) || startsWith({0, 0, 0xFE, 0xFF}) || startsWith({'<', 0, 0, 0}) ||
        startsWith({0, 0, 0, '<'}))
        fail("UTF-32 is not supported", 0, 1);
    if (startsWith({0xFF, 0xFE})) return fromUtf16(bytes, false, 2);
    if (startsWith({0xFE, 0xFF})) return fromUtf16(bytes, true, 2);
    if (startsWith({'<', 0})) return fromUtf16(bytes, false, 0);
    if (startsWith({0, '<'})) return fromUtf16(bytes, true, 0);
    if (startsWith({0xEF, 0xBB, 0xBF})) bytes = bytes.subspan(3);
    return from8Bit(bytes, guessed);
}

// Drops zero characters at the end, which some tools write as padding. Fails for others: XML has none, and
// the parser would take the first one for the end of the text.
void cutZeros(std::string& text) {
    while (!text.empty() && text.back() == '\0') text.pop_back();
    const std::size_t zero = text.find('\0');
    if (zero == std::string::npos) return;
    const ByteSpan bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    fail("a zero character", zero, lineAt(bytes, zero));
}

}  // namespace

bool isUtf8(std::string_view text) {
    return !firstInvalidUtf8({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::optional<std::string_view> asUtf8(const Bytes& bytes, bool* plain) {
    std::string_view text = viewOf(bytes);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const Span span = declaredEncoding(text);
    const std::string name = lowerCase(text.substr(span.begin, span.end - span.begin));
    const bool claimsUtf8 = name.empty() || name == "utf-8" || name == "utf8";
    const bool isPlain = claimsUtf8 && isPlainText(text);
    if (plain) *plain = isPlain;
    if (isPlain) return text;
    // Text with a zero byte is UTF-16, UTF-32 or damaged.
    if (!claimsUtf8 || text.find('\0') != std::string_view::npos || !isUtf8(text)) return std::nullopt;
    return text;
}

std::string toUtf8(Bytes bytes, bool* guessed, bool* padded) {
    if (guessed) *guessed = false;
    std::string text = decode(bytes, guessed);
    if (padded) *padded = text.ends_with('\0');
    cutZeros(text);
    const Span span = declaredEncoding(text);
    if (span.end > span.begin) text.replace(span.begin, span.end - span.begin, "utf-8");
    return text;
}

}  // namespace walkcycle
