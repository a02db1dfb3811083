#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/document/XmlNode.h"
#include "loaders/text/NumberParser.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

class Dialects;

// How to report a number that cannot be used. Error: for positions, weights and matrices, which are useless without it.
// Warning: the rest can be shown. The number becomes 0 either way, so that all numbers of a model are finite.
enum class NumberFaults { Error, Warning };

// The entries of a <source>: the values of its array that its accessor selects, without gaps. Entry i has `width` values
// from values[i * width] on: those of the accessor's <param>s that have a name (all values if none has one), in order.
template <typename T>
struct Source {
    std::vector<T> values;
    std::size_t width = 0;
    std::vector<std::string> params;     // names, "X", "Y", ..., "JOINT", "TRANSFORM"
    XmlNode element, array;              // the <source> and its numbers or names, for messages
    std::size_t offset = 0, stride = 1;  // entry i begins at offset + i * stride of the array

    // The line of the file in which an entry begins.
    int lineOf(std::size_t entry) const { return array.lineOfWord(offset + entry * stride); }
    std::size_t count() const { return width ? values.size() / width : 0; }
    const T* operator[](std::size_t i) const { return values.data() + i * width; }
};

using FloatSource = Source<float>;
using DoubleSource = Source<double>;
using NameSource = Source<std::string>;  // of a Name_array, IDREF_array ...

// Reads <source> elements, each once: the results are cached for the load, and shared.
class SourceReader {
public:
    // `pieceRead` is called as the lists of numbers and names are read.
    SourceReader(DocumentSet& documents, Diagnostics& diagnostics, Dialects& dialects,
                 PieceRead pieceRead = {});
    ~SourceReader();

    // `source` is the <source> element. Faults are reported: a count that disagrees with the data (WC0205, WC0211; the
    // entries that exist are returned), unusable numbers (WC0204 or WC0210, by `faultsAre`), a missing accessor or array.
    // Returns null if nothing can be used. `isIdref` becomes true if the names are in an IDREF_array.
    std::shared_ptr<const FloatSource> floats(XmlNode source, NumberFaults faultsAre);
    std::shared_ptr<const DoubleSource> doubles(XmlNode source, NumberFaults faultsAre);
    std::shared_ptr<const NameSource> names(XmlNode source, bool& isIdref,
                                            Severity miscounted = Severity::Error);

    // Like doubles(), but the caller may move the values out of it. Not cached, since hardly any source is read twice.
    std::shared_ptr<DoubleSource> doublesToTake(XmlNode source, NumberFaults faultsAre);
    // Frees the cached results of floats(). To be called when all meshes, skins and morphs are loaded.
    void forgetFloats();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The numbers of an element's text: a <matrix>, <p>, <vcount>, <v> ... A fault is reported with its own line.
std::vector<double> readDoubles(XmlNode node, Diagnostics& diagnostics, NumberFaults faultsAre);
std::vector<std::int32_t> readInts(XmlNode node, Diagnostics& diagnostics, const PieceRead& pieceRead = {});

}  // namespace walkcycle
