#include "loaders/NumberParser.h"

#include <algorithm>
#include <array>
#include <bit>
#include <future>
#include <system_error>
#include <thread>

#include "loaders/NumberBlock.h"
#include "loaders/NumberToken.h"
#include "loaders/PlainNumber.h"
#include "loaders/Words.h"

namespace walkcycle {
namespace {

// About how many words a text has, from a look at some places of it: never more than it could hold.
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

// Reads the numbers of one text to the end of a vector.
template <typename T>
class ListReader {
public:
    ListReader(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults)
        : text_(text), values_(values), faults_(faults), before_(values.size()) {}

    // Makes room for about so many values.
    void reserve(std::size_t more) {
        // As push_back() does it, not exactly: many short lists may be appended to one vector.
        const std::size_t wanted = values_.size() + more;
        if (wanted > values_.capacity())
            values_.reserve(values_.empty() ? wanted : std::max(wanted, 2 * values_.capacity()));
    }

    // All words but the last few are read where they stand; those from a copy with more behind it.
    void read() {
        const std::size_t tail = lastWords();
        if (tail > 0) readWords(text_.data(), text_.data() + tail, 0);
        constexpr std::string_view kBehind = " 0       ";
        const std::string_view last = text_.substr(tail);
        std::array<char, 64> few;
        std::string many;
        if (last.size() + kBehind.size() > few.size()) many.resize(last.size() + kBehind.size());
        char* const copy = many.empty() ? few.data() : many.data();
        std::copy(last.begin(), last.end(), copy);
        std::copy(kBehind.begin(), kBehind.end(), copy + last.size());
        readWords(copy, copy + last.size() + 1, tail);
    }

private:
    // Where a word begins that has seven characters more behind its first; the text's start where there is none.
    std::size_t lastWords() const {
        std::size_t at = text_.size() < 8 ? 0 : text_.size() - 8;
        while (at > 0 && (isWhiteSpace(text_[at]) || !isWhiteSpace(text_[at - 1]))) --at;
        return at;
    }

    // Reads up to `stop`, where a word begins; `offset` is where in the text the first character stands.
    void readWords(const char* const first, const char* const stop, std::size_t offset) {
        const char* at = first;
        if constexpr (std::is_integral_v<T> && kFirstByteIsLowest) at = readBlocks(first, stop, offset);
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

    // The same as far as whole blocks of characters go. Gives where it stopped, with no word half read.
    const char* readBlocks(const char* const first, const char* const stop, std::size_t offset) {
        const char* at = first;
        while (stop - at >= NumberBlock::kSize) {
            const NumberBlock block(at);
            const std::size_t place = offset + static_cast<std::size_t>(at - first);
            std::size_t count = 0;
            unsigned from = NumberBlock::kSize;  // of the word that does not end in the block
            for (std::uint64_t edges = block.edges(); edges != 0; edges &= edges - 1) {
                from = static_cast<unsigned>(std::countr_zero(edges));
                edges &= edges - 1;
                if (edges == 0) break;
                const auto to = static_cast<unsigned>(std::countr_zero(edges));
                if (!block.read(from, to, block_[count])) readWord(at + from, place + from, count);
                ++count;
                from = NumberBlock::kSize;
            }
            at = from == 0 ? readWord(at, place, count++) : at + from;
            keep(count);
        }
        return at;
    }

    // Into the block; gives where the word ends.
    const char* readWord(const char* at, std::size_t place, std::size_t index) {
        const char* const after = readPlain(at, block_[index]);
        return after ? after : at + judge(place, values_.size() + index - before_, block_[index]);
    }

    void keep(std::size_t count) { values_.insert(values_.end(), block_.data(), block_.data() + count); }

    // The word at a place of the text in full rigour; gives its length.
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
    std::size_t before_;
    std::array<T, 64> block_;
};

// A second thread has to be started, and its numbers to be put behind the others: shorter lists gain nothing.
constexpr std::size_t kWorthAThread = std::size_t{1} << 21;

// Behind the white space that is nearest to the middle of a text, or behind it all.
std::size_t middleOf(std::string_view text) {
    std::size_t at = text.size() / 2;
    while (at < text.size() && !isWhiteSpace(text[at])) ++at;
    return at;
}

template <typename T>
void parseWhole(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults) {
    ListReader<T> reader(text, values, faults);
    reader.reserve(estimateWords(text));
    reader.read();
}

// Reads the second half on another thread, and puts it behind the first: all comes out as if read in one go.
template <typename T>
void parseHalves(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults) {
    const std::size_t before = values.size(), middle = middleOf(text);
    const std::string_view half = text.substr(middle);
    std::vector<T> others;
    std::vector<NumberFault> otherFaults;
    auto other = std::async(std::launch::async, [&] { parseWhole(half, others, otherFaults); });
    ListReader<T> reader(text.substr(0, middle), values, faults);
    reader.reserve(estimateWords(text));
    reader.read();
    other.get();
    for (NumberFault& fault : otherFaults) {
        if (faults.size() >= kMaxFaults) break;
        fault.index += values.size() - before;
        fault.offset += middle;
        faults.push_back(fault);
    }
    values.insert(values.end(), others.begin(), others.end());
}

template <typename T>
void parseList(std::string_view text, std::vector<T>& values, std::vector<NumberFault>& faults) {
    if (text.size() < kWorthAThread || std::thread::hardware_concurrency() < 2)
        return parseWhole(text, values, faults);
    try {
        parseHalves(text, values, faults);
    } catch (const std::system_error&) {  // no more threads for us: nothing has been read yet
        parseWhole(text, values, faults);
    }
}

constexpr int kTokensAround = 3;
constexpr std::size_t kLongestToken = 20;

std::string shortened(std::string_view token) {
    return token.size() > kLongestToken ? std::string(token.substr(0, kLongestToken)) + "..."
                                        : std::string(token);
}

// The last or first token of a text; empty where there is none.
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

void parseNumbers(std::string_view text, std::vector<float>& values, std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
}
void parseNumbers(std::string_view text, std::vector<double>& values, std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
}
void parseNumbers(std::string_view text, std::vector<std::int32_t>& values,
                  std::vector<NumberFault>& faults) {
    parseList(text, values, faults);
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
