#include "loaders/sources/Source.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "loaders/quirks/Dialect.h"
#include "loaders/quirks/SpacedNames.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

template <typename T>
std::vector<T> readNumbers(XmlNode node, Diagnostics& diagnostics, NumberFaults faultsAre,
                           const PieceRead& pieceRead) {
    std::vector<T> values;
    std::vector<NumberFault> faults;
    std::string joined;
    const std::string_view text = node.rawText(joined);
    parseNumbers(text, values, faults, pieceRead);
    for (const NumberFault& fault : faults) {
        const std::string token(fault.token), name(node.name());
        std::string around = surroundings(text, fault);
        if (!around.empty()) around = ": '" + around + "'";
        const int line = node.textLine(fault.offset);
        if (faultsAre == NumberFaults::Error)
            diagnostics.report(Code::NumberInvalid, node, {token, name, around}, line);
        else
            diagnostics.report(Code::NumberOddWarning, node, {token, name, "0", around}, line);
    }
    return values;
}

// Parses an attribute as a count. Returns nothing if it is missing or (reported) is no count.
std::optional<std::uint64_t> readCount(XmlNode node, const char* attribute, Diagnostics& diagnostics) {
    if (!node.has(attribute)) return std::nullopt;
    std::uint64_t value = 0;
    if (parseUnsigned(node.attribute(attribute), value)) return value;
    diagnostics.report(Code::NumberInvalid, node,
                       {std::string(node.attribute(attribute)), std::string(node.name()) + " " + attribute});
    return std::nullopt;
}

void checkArrayCount(XmlNode array, std::size_t held, Severity miscounted, Diagnostics& diagnostics) {
    if (!array.has("count")) {
        diagnostics.report(Code::MissingAttribute, array, {std::string(array.name()), "count"});
        return;
    }
    const std::optional<std::uint64_t> count = readCount(array, "count", diagnostics);
    if (count && *count != held)
        diagnostics.report(
            miscounted, Code::CountMismatch, array,
            {std::string(array.name()), std::to_string(*count), "values", std::to_string(held)});
}

// How many values a <param> of this type holds: "float" 1, "float4x4" 16, "name" 1.
std::size_t paramSize(std::string_view type) {
    const std::size_t digit = type.find_first_of("234");
    if (digit == std::string_view::npos) return 1;
    const auto rows = static_cast<std::size_t>(type[digit] - '0');
    const bool isMatrix = digit + 2 < type.size() && type[digit + 1] == 'x';
    return isMatrix ? rows * static_cast<std::size_t>(std::max(1, type[digit + 2] - '0')) : rows;
}

// Where an accessor finds its entries: entry i begins at offset + i * stride, and `columns` of its values are used.
struct Layout {
    std::uint64_t count = 0, stride = 1, offset = 0;
    std::vector<std::size_t> columns;
    std::vector<std::string> params;
};

void readParams(XmlNode accessor, Layout& layout, Diagnostics& diagnostics) {
    std::size_t column = 0, paramCount = 0;
    for (XmlNode param : accessor.children("param")) {
        const std::size_t size = paramSize(param.attribute("type"));
        ++paramCount;
        if (!param.attribute("name").empty()) {
            for (std::size_t i = 0; i < size; ++i) layout.columns.push_back(column + i);
            layout.params.emplace_back(param.attribute("name"));
        }
        column += size;
    }
    if (column > layout.stride) {
        diagnostics.report(
            Code::CountMismatch, accessor,
            {"accessor", "a stride of " + std::to_string(layout.stride), "values", std::to_string(column)});
        const bool defaulted = !accessor.has("stride") && column <= 16;
        if (defaulted) layout.stride = column;
        std::erase_if(layout.columns, [&](std::size_t c) { return c >= layout.stride; });
    }
    // If no <param> has a name, or one stands for a whole matrix, all values are used.
    const bool oneForAll = paramCount == 1 && layout.stride == 16;
    if (layout.columns.empty() || oneForAll) {
        layout.columns.clear();
        for (std::size_t i = 0; i < std::min<std::uint64_t>(layout.stride, 64); ++i)
            layout.columns.push_back(i);
    }
}

// Reads the accessor, and limits it to the entries that its array of `held` values has.
Layout readLayout(XmlNode source, std::size_t held, Diagnostics& diagnostics) {
    Layout layout;
    const XmlNode accessor = source.child("technique_common").child("accessor");
    if (!accessor) {
        diagnostics.report(Code::MissingElement, source, {"source", "accessor"});
        layout.count = held;
        layout.columns = {0};
        return layout;
    }
    layout.stride = readCount(accessor, "stride", diagnostics).value_or(1);
    layout.offset = readCount(accessor, "offset", diagnostics).value_or(0);
    if (layout.stride == 0) {
        diagnostics.report(Code::NumberInvalid, accessor, {"0", "accessor stride"});
        layout.stride = 1;
    }
    readParams(accessor, layout, diagnostics);
    const std::uint64_t width = layout.columns.back() + 1;
    const std::uint64_t after = layout.offset <= held ? held - layout.offset : 0;
    const std::uint64_t carried = after >= width ? (after - width) / layout.stride + 1 : 0;
    if (!accessor.has("count")) diagnostics.report(Code::MissingAttribute, accessor, {"accessor", "count"});
    layout.count = readCount(accessor, "count", diagnostics).value_or(carried);
    const bool saysNoWidth = !accessor.has("stride") && !accessor.child("param");
    if (saysNoWidth && layout.count > 0 && held >= 2 * layout.count && held % layout.count == 0)
        diagnostics.report(
            Severity::Warning, Code::CountMismatch, accessor,
            {"accessor", std::to_string(layout.count),
             "entries of one value (it has neither stride nor <param>)", std::to_string(held) + " values"});
    if (layout.count > carried) {
        const std::string wanted =
            std::to_string(layout.count) + " entries of " + std::to_string(layout.stride) + " values";
        diagnostics.report(Code::AccessorOutside, accessor,
                           {std::string(source.id()), wanted, std::to_string(held)});
        layout.count = carried;
    }
    return layout;
}

template <typename T>
std::vector<T> pick(std::vector<T>&& values, const Layout& layout) {
    const std::size_t width = layout.columns.size();
    if (width == layout.stride && layout.offset == 0) {  // the usual case: no gaps
        values.resize(static_cast<std::size_t>(layout.count) * width);
        return std::move(values);
    }
    std::vector<T> picked;
    picked.reserve(static_cast<std::size_t>(layout.count) * width);
    for (std::uint64_t i = 0; i < layout.count; ++i)
        for (const std::size_t column : layout.columns)
            picked.push_back(values[static_cast<std::size_t>(layout.offset + i * layout.stride) + column]);
    return picked;
}

// The array that the accessor refers to; the <source>'s own if the reference leads to the <source> itself or nowhere.
XmlNode findArray(XmlNode source, DocumentSet& documents, Diagnostics& diagnostics,
                  bool isArray(std::string_view)) {
    XmlNode own;
    for (XmlNode node : source.children())
        if (!own && isArray(node.name())) own = node;
    const XmlNode accessor = source.child("technique_common").child("accessor");
    if (!accessor) return own;
    const XmlNode meant = documents.resolve(accessor, accessor.attribute("source"));
    if (meant && isArray(meant.name())) return meant;
    if (meant && meant.is("source")) return own;
    diagnostics.report(Code::UnresolvedReference, accessor,
                       {"accessor", std::string(accessor.attribute("source"))});
    return own;
}

bool isNumberArray(std::string_view name) {
    return name == "float_array" || name == "int_array";
}
bool isNameArray(std::string_view name) {
    return name == "Name_array" || name == "IDREF_array" || name == "SIDREF_array" || name == "token_array";
}

std::vector<std::string> readNames(XmlNode array, Dialects& dialects) {
    std::string joined;
    const std::vector<std::string_view> words = splitWords(array.rawText(joined));
    std::uint64_t count = 0;
    const bool hasMore =
        array.is("Name_array") && parseUnsigned(array.attribute("count"), count) && count < words.size();
    if (hasMore && dialects.follows(Quirk::SpacedNames, array))
        if (auto names = joinSpacedNames(words, static_cast<std::size_t>(count), array.root())) {
            dialects.note(Quirk::SpacedNames, array);
            return std::move(*names);
        }
    return {words.begin(), words.end()};
}

}  // namespace

struct SourceReader::Impl {
    DocumentSet& documents;
    Diagnostics& diagnostics;
    Dialects& dialects;
    PieceRead pieceRead;
    std::unordered_map<XmlNode, std::shared_ptr<const FloatSource>> floats;
    std::unordered_map<XmlNode, std::shared_ptr<const DoubleSource>> doubles;
    std::unordered_map<XmlNode, std::shared_ptr<const NameSource>> names;
    std::unordered_set<XmlNode> taken;

    template <typename T, typename Read>
    std::shared_ptr<Source<T>> read(XmlNode source, bool isArray(std::string_view), Read readArray,
                                    Severity miscounted = Severity::Error) {
        const XmlNode array = findArray(source, documents, diagnostics, isArray);
        if (!array) {
            diagnostics.report(Code::MissingElement, source,
                               {"source", "float_array or Name_array of the kind that is needed"});
            return nullptr;
        }
        std::vector<T> values = readArray(array);
        checkArrayCount(array, values.size(), miscounted, diagnostics);
        Layout layout = readLayout(source, values.size(), diagnostics);
        auto result = std::make_shared<Source<T>>();
        result->width = layout.columns.size();
        result->values = pick(std::move(values), layout);
        result->params = std::move(layout.params);
        result->element = source;
        result->array = array;
        result->offset = static_cast<std::size_t>(layout.offset);
        result->stride = static_cast<std::size_t>(layout.stride);
        return result;
    }

    template <typename T>
    std::shared_ptr<Source<T>> numbers(XmlNode source, NumberFaults faultsAre) {
        return read<T>(source, isNumberArray, [&](XmlNode array) {
            return readNumbers<T>(array, diagnostics, faultsAre, pieceRead);
        });
    }
};

SourceReader::SourceReader(DocumentSet& documents, Diagnostics& diagnostics, Dialects& dialects,
                           PieceRead pieceRead)
    : impl_(new Impl{documents, diagnostics, dialects, std::move(pieceRead), {}, {}, {}, {}}) {}
SourceReader::~SourceReader() = default;

std::shared_ptr<const FloatSource> SourceReader::floats(XmlNode source, NumberFaults faultsAre) {
    const auto [entry, isNew] = impl_->floats.try_emplace(source);
    if (isNew) entry->second = impl_->numbers<float>(source, faultsAre);
    return entry->second;
}

std::shared_ptr<const DoubleSource> SourceReader::doubles(XmlNode source, NumberFaults faultsAre) {
    const auto [entry, isNew] = impl_->doubles.try_emplace(source);
    if (isNew) entry->second = impl_->numbers<double>(source, faultsAre);
    return entry->second;
}

// If a source is asked for a second time, it is cached from then on.
std::shared_ptr<DoubleSource> SourceReader::doublesToTake(XmlNode source, NumberFaults faultsAre) {
    if (impl_->doubles.contains(source) || !impl_->taken.insert(source).second) {
        const auto kept = doubles(source, faultsAre);
        return kept ? std::make_shared<DoubleSource>(*kept) : nullptr;
    }
    return impl_->numbers<double>(source, faultsAre);
}

void SourceReader::forgetFloats() {
    impl_->floats.clear();
}

std::shared_ptr<const NameSource> SourceReader::names(XmlNode source, bool& isIdref, Severity miscounted) {
    isIdref = static_cast<bool>(source.child("IDREF_array"));
    const auto [entry, isNew] = impl_->names.try_emplace(source);
    const auto readAndAdvance = [&](XmlNode array) {
        std::string joined;
        if (impl_->pieceRead) impl_->pieceRead(array.rawText(joined).size());
        return readNames(array, impl_->dialects);
    };
    if (isNew) entry->second = impl_->read<std::string>(source, isNameArray, readAndAdvance, miscounted);
    return entry->second;
}

std::vector<double> readDoubles(XmlNode node, Diagnostics& diagnostics, NumberFaults faultsAre) {
    return readNumbers<double>(node, diagnostics, faultsAre, {});
}

std::vector<std::int32_t> readInts(XmlNode node, Diagnostics& diagnostics, const PieceRead& pieceRead) {
    return readNumbers<std::int32_t>(node, diagnostics, NumberFaults::Error, pieceRead);
}

}  // namespace walkcycle
