#include "loaders/text/NumberParser.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "loaders/text/NumberToken.h"
#include "loaders/text/PlainNumber.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

// Estimates how many words a text has, from samples of it; never more than it could hold.
std::size_t estimateWords(std::string_view text) {
    constexpr std::size_t kPlaces = 4, kLength = 64;
    if (text.size() <= kPlaces * kLength) return countWords(text);
    std::uint64_t words = 0;
    for (std::size_t i = 0; i < kPlaces; ++i)
        words += countWords(text.substr((text.size() - kLength) / (kPlaces - 1) * i, kLength));
    const double share = static_cast<double>(words) / (kPlaces * kLength);
    return std::min(static_cast<std::size_t>(1.03 * share * static_cast<double>(text.size())) + 16,
                    text.size() / 2 + 1);
}

// Parses the numbers of one text and appends them to a vector.
template <typename T>
class ListReader {
public:
    ListReader(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults,
               const PieceRead& pieceRead)
        : text_(text), values_(values), faults_(faults), pieceRead_(pieceRead), before_(values.size()) {}

    // Makes room for about `more` values.
    void reserve(std::size_t more) {
        // Doubles the capacity, as push_back() does: many short lists may be appended to one vector.
        const std::size_t wanted = values_.size() + more;
        if (wanted > values_.capacity())
            values_.reserve(values_.empty() ? wanted : std::max(wanted, 2 * values_.capacity()));
    }

    // readPlain() looks at characters behind the word, so the last words are parsed from a padded copy.
    void read() {
        const std::size_t tail = lastWords();
        for (std::size_t at = 0; at < tail;) {
            const std::size_t end = endOfPiece(at, tail);
            readWords(text_.data() + at, text_.data() + end, at);
            if (pieceRead_) pieceRead_(end - at);
            at = end;
        }
        constexpr std::string_view kBehind = " 0       ";
        const std::string_view last = text_.substr(tail);
        std::array<char, 64> few;
        std::string many;
        if (last.size() + kBehind.size() > few.size()) many.resize(last.size() + kBehind.size());
        char* const copy = many.empty() ? few.data() : many.data();
        std::copy(last.begin(), last.end(), copy);
        std::copy(kBehind.begin(), kBehind.end(), copy + last.size());
        readWords(copy, copy + last.size() + 1, tail);
        if (pieceRead_) pieceRead_(last.size());
    }

private:
    // Where a piece that begins at `at` ends: at the beginning of a word, some milliseconds of parsing later, or at `most`.
    std::size_t endOfPiece(std::size_t at, std::size_t most) const {
        constexpr std::size_t kPiece = std::size_t{1} << 20;
        if (most - at <= kPiece) return most;
        std::size_t end = at + kPiece;
        while (end < most && (isWhiteSpace(text_[end]) || !isWhiteSpace(text_[end - 1]))) ++end;
        return end;
    }

    // Where the words begin that are too close to the text's end to be parsed in place (see PlainNumber.h).
    std::size_t lastWords() const {
        std::size_t at = text_.size() < 8 ? 0 : text_.size() - 8;
        while (at > 0 && (isWhiteSpace(text_[at]) || !isWhiteSpace(text_[at - 1]))) --at;
        return at;
    }

    // Parses the words before `stop`, where a word begins; `offset` is the position of `first` in the text.
    void readWords(const char* const first, const char* const stop, std::size_t offset) {
        const char* at = first;
        while (at < stop) {
            std::size_t count = 0;
            for (; count < block_.size(); ++count) {
                while (isWhiteSpace(*at)) ++at;
                if (at >= stop) break;
                at = readWord(at, offset + static_cast<std::size_t>(at - first), count);
            }
            keep(count);
        }
    }

    // Parses one word into the block, and returns where it ends.
    const char* readWord(const char* at, std::size_t place, std::size_t index) {
        const char* const after = readPlain(at, block_[index]);
        return after ? after : at + judge(place, values_.size() + index - before_, block_[index]);
    }

    void keep(std::size_t count) { values_.insert(values_.end(), block_.data(), block_.data() + count); }

    // Parses the word at a place of the text by all rules, or notes the fault. Returns the word's length.
    std::size_t judge(std::size_t place, std::size_t index, T& value) {
        const char* const word = text_.data() + place;
        const char* const end = text_.data() + text_.size();
        const char* after = word;
        while (after != end && !isWhiteSpace(*after)) ++after;
        const auto length = static_cast<std::size_t>(after - word);
        if (parseToken(word, after, value)) return length;
        value = T{};
        if (faults_.size() < kMaxFaults) faults_.push_back({index, place, {word, length}});
        return length;
    }

    std::string_view text_;
    std::vector<T>& values_;
    std::vector<NumberFault>& faults_;
    const PieceRead& pieceRead_;
    std::size_t before_;
    std::array<T, 64> block_;
};

template <typename T>
void parseList(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults,
               const PieceRead& pieceRead) {
    ListReader<T> reader(text, values, faults, pieceRead);
    reader.reserve(estimateWords(text));
    reader.read();
}

constexpr int kTokensAround = 3;
constexpr std::size_t kLongestToken = 20;

std::string shortened(std::string_view token) {
    return token.size() > kLongestToken ? std::string(token.substr(0, kLongestToken)) + "..."
                                        : std::string(token);
}

// The last and the first token of a text; empty if there is none.
std::string_view lastToken(std::string_view text) {
    text = trim(text);
    std::size_t start = text.size();
    while (start > 0 && !isWhiteSpace(text[start - 1])) --start;
    return text.substr(start);
}
std::string_view firstToken(std::string_view text) {
    text = trim(text);
    std::size_t end = 0;
    while (end < text.size() && !isWhiteSpace(text[end])) ++end;
    return text.substr(0, end);
}

template <typename T>
bool parseOne(std::string_view text, T& value) {
    text = trim(text);
    return !text.empty() && parseToken(text.data(), text.data() + text.size(), value);
}

}  // namespace

void parseNumbers(std::string_view text, std::vector<float>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead) {
    parseList(text, values, faults, pieceRead);
}
void parseNumbers(std::string_view text, std::vector<double>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead) {
    parseList(text, values, faults, pieceRead);
}
void parseNumbers(std::string_view text, std::vector<std::int32_t>& values, std::vector<NumberFault>& faults,
                  const PieceRead& pieceRead) {
    parseList(text, values, faults, pieceRead);
}

std::string surroundings(std::string_view text, const NumberFault& fault) {
    std::string around = shortened(fault.token);
    std::string_view before = text.substr(0, fault.offset);
    std::string_view after = text.substr(fault.offset + fault.token.size());
    if (trim(before).empty() && trim(after).empty()) return {};
    for (int i = 0; i < kTokensAround; ++i) {
        if (const std::string_view token = lastToken(before); !token.empty()) {
            around = shortened(token) + " " + around;
            before = before.substr(0, static_cast<std::size_t>(token.data() - before.data()));
        }
        if (const std::string_view token = firstToken(after); !token.empty()) {
            around += " " + shortened(token);
            after.remove_prefix(static_cast<std::size_t>(token.data() - after.data()) + token.size());
        }
    }
    if (!trim(before).empty()) around = "... " + around;
    if (!trim(after).empty()) around += " ...";
    return around;
}

bool parseNumber(std::string_view text, double& value) {
    return parseOne(text, value);
}
bool parseNumber(std::string_view text, std::int32_t& value) {
    return parseOne(text, value);
}
bool parseUnsigned(std::string_view text, std::uint64_t& value) {
    return parseOne(text, value);
}

}  // namespace walkcycle
