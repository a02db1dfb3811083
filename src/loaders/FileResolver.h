#pragma once

#include <concepts>
#include <cstring>
#include <functional>
#include <optional>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>

#include "io/Bytes.h"

namespace walkcycle {

// Anything whose elements are bytes that lie one after another: std::vector<std::uint8_t>, std::vector<char>,
// std::vector<std::byte>, std::string, std::span<const std::uint8_t> ... A plain array is not one: the array of a text in
// quotes has a zero at its end that is not of the text.
template <typename T>
concept ByteRange = std::ranges::contiguous_range<const T> && std::ranges::sized_range<const T> &&
                        sizeof(std::ranges::range_value_t<const T>) == 1 &&
                    std::is_trivially_copyable_v<std::ranges::range_value_t<const T>> &&
                    !std::is_array_v<std::remove_cvref_t<T>>;

// What a FileResolver gives: the bytes of a file, or that there is no such file. A resolver returns any ByteRange, an
// std::optional of one, or std::nullopt; the bytes are copied (those of a Bytes that is given away are not).
class ResolvedFile {
public:
    ResolvedFile(std::nullopt_t) {}
    ResolvedFile(Bytes bytes) : bytes_(std::move(bytes)) {}

    template <ByteRange T>
    requires(!std::same_as<T, Bytes>) ResolvedFile(const T& range)
        : bytes_(std::in_place, std::ranges::size(range)) {
        if (!bytes_->empty()) std::memcpy(bytes_->data(), std::ranges::data(range), bytes_->size());
    }

    template <typename T>
    requires(std::same_as<T, Bytes> || ByteRange<T>) ResolvedFile(std::optional<T> range) {
        if (range) *this = ResolvedFile(std::move(*range));
    }

    bool found() const { return bytes_.has_value(); }
    const Bytes& bytes() const { return *bytes_; }  // of a file that was found

private:
    std::optional<Bytes> bytes_;
};

// Reads another file that a document refers to. `path` is the path that the document gives, decoded, and resolved against
// the path or name of the document ("models/walker.dae" and "skin.png" make "models/skin.png"), with '/' between folders
// and without "." and ".." that can be left out. One load asks for each path once. A FileError that
// the resolver throws is reported like a file that cannot be read; all else that it throws ends the load and reaches the
// caller of loadCollada.
using FileResolver = std::function<ResolvedFile(const std::string& path)>;

}  // namespace walkcycle
