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

// What to do about a number that cannot be used: positions, weights and matrices are nothing without it (Error), the
// rest can be shown (Warning). It becomes 0 either way, so that nothing that is not finite is ever passed on.
enum class Numbers { Error, Warning };

// A <source>: its array seen through its accessor, packed. Entry i has `width` numbers at values[i * width]:
// those of the accessor's <param>s that have a name (all of them where none has one), in order.
template <typename T>
struct Source {
    std::vector<T> values;
    std::size_t width = 0;
    std::vector<std::string> params;     // names, "X", "Y", ..., "JOINT", "TRANSFORM"
    XmlNode element, array;              // the <source> and its numbers or names, for messages
    std::size_t offset = 0, stride = 1;  // where in the array the entries are

    // In which line of the file an entry starts.
    int lineOf(std::size_t entry) const { return array.lineOfWord(offset + entry * stride); }
    std::size_t count() const { return width ? values.size() / width : 0; }
    const T* operator[](std::size_t i) const { return values.data() + i * width; }
};

using FloatSource = Source<float>;
using DoubleSource = Source<double>;
using NameSource = Source<std::string>;  // isIdref tells IDREF_array from Name_array: see SourceReader::names

// Reads <source> elements: each once, cached for the load (packed values are shared).
class SourceReader {
public:
    // `pieceRead` is told of the lists of numbers as they are read.
    SourceReader(DocumentSet& documents, Diagnostics& diagnostics, Dialects& dialects,
                 PieceRead pieceRead = {});
    ~SourceReader();

    // `source` is the <source> element. Faults are reported: a count that disagrees with the data (WC0205, WC0211;
    // the entries that exist are given), numbers (WC0204 / WC0210 by `numbers`), missing accessor or array.
    // Null where there is nothing usable.
    std::shared_ptr<const FloatSource> floats(XmlNode source, Numbers numbers);
    std::shared_ptr<const DoubleSource> doubles(XmlNode source, Numbers numbers);
    std::shared_ptr<const NameSource> names(XmlNode source, bool& isIdref,
                                            Severity miscounted = Severity::Error);

    // The same as doubles(), for one who will take it apart: not kept, since hardly any other asks for it again.
    std::shared_ptr<DoubleSource> doublesToTake(XmlNode source, Numbers numbers);
    // When nobody will ask for floats again.
    void forgetFloats();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The numbers of an element's text: a <matrix>, <p>, <vcount>, <v> ... Faults are reported with their own line.
std::vector<double> readDoubles(XmlNode node, Diagnostics& diagnostics, Numbers numbers);
std::vector<std::int32_t> readInts(XmlNode node, Diagnostics& diagnostics, const PieceRead& pieceRead = {});

}  // namespace walkcycle
