#include "loaders/geometry/PrimitiveReader.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "loaders/geometry/PrimitiveKind.h"
#include "loaders/text/NumberParser.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

// Reads the corners of one primitive. The members are what the steps share.
class CornerReader {
public:
    CornerReader(XmlNode element, PrimitiveKind kind, const Vertices& vertices, const LoadContext& context)
        : kind_(kind), context_(context), pieceRead_(context.pieceRead()) {
        out_.element = element;
        out_.inputs = readPrimitiveInputs(element, vertices, context);
        const bool lines = kind == PrimitiveKind::Lines || kind == PrimitiveKind::Linestrips;
        out_.kind = lines ? Primitive::Lines : Primitive::Triangles;
    }

    PrimitiveCorners read() {
        switch (kind_) {
            case PrimitiveKind::Triangles:
                readRuns(3);
                break;
            case PrimitiveKind::Lines:
                readRuns(2);
                break;
            case PrimitiveKind::Polylist:
                readPolylist();
                break;
            case PrimitiveKind::Polygons:
            case PrimitiveKind::Trifans:
            case PrimitiveKind::Tristrips:
            case PrimitiveKind::Linestrips:
                readLists();
                break;
        }
        checkCount();
        if (tooSmall_ > 0)
            context_.diagnostics.report(Code::FaceTooSmall, out_.element,
                                        {std::to_string(tooSmall_), std::string(out_.element.name())},
                                        firstTooSmall_.line());
        return std::move(out_);
    }

private:
    std::size_t stride() const { return out_.inputs.stride; }

    // Appends the numbers of a <p> or <h>, without an incomplete group at the end. Returns the number of
    // corners.
    std::size_t appendCorners(XmlNode p, std::size_t cornersPerGroup = 1) {
        const std::size_t before = out_.indices.size();
        faults_.clear();
        parseNumbers(p.rawText(joined_), out_.indices, faults_, pieceRead_);
        if (!faults_.empty()) readInts(p, context_.diagnostics);  // again, to report each fault with its line
        const std::size_t numbers = out_.indices.size() - before;
        const std::size_t group = cornersPerGroup * stride();
        if (numbers % group != 0)
            context_.diagnostics.report(
                Code::IncompleteFace, p,
                {std::string(p.name()), std::to_string(numbers), std::to_string(group)},
                p.lineOfWord(numbers - 1));
        const std::size_t corners = numbers / group * cornersPerGroup;
        out_.indices.resize(before + corners * stride());
        return corners;
    }

    // <triangles> and <lines>: every `size` corners of a <p> are one face or line.
    void readRuns(std::size_t size) {
        for (XmlNode p : out_.element.children("p")) {
            const std::size_t first = out_.cornerCount();
            const std::size_t corners = appendCorners(p, size);
            out_.rings.reserve(out_.rings.size() + corners / size);
            for (std::size_t c = 0; c < corners; c += size) addRing(first + c, size, false);
        }
        held_ = out_.rings.size();
    }

    void readPolylist() {
        const XmlNode vcount = out_.element.child("vcount");
        std::size_t held = 0;
        for (XmlNode p : out_.element.children("p")) held += appendCorners(p);
        if (!vcount) {
            if (held > 0)
                context_.diagnostics.report(Code::MissingElement, out_.element, {"polylist", "vcount"});
            out_.indices.clear();
            return;
        }
        const std::vector<std::int32_t> sizes = readInts(vcount, context_.diagnostics, pieceRead_);
        held_ = sizes.size();
        std::size_t first = 0;
        std::uint64_t wanted = 0;
        bool fits = true;  // a polygon that does not fit ends the list: where the next one begins is unknown
        for (const std::int32_t size : sizes) {
            const auto count = static_cast<std::size_t>(std::max(size, 0));
            wanted += count;
            fits = fits && size >= 0 && count <= held - first;
            if (!fits) continue;
            addFace(vcount, first, count);
            first += count;
        }
        if (wanted != held || !fits)
            context_.diagnostics.report(Code::VcountMismatch, vcount,
                                        {std::to_string(wanted), std::to_string(held)}, vcount.textLine());
        out_.indices.resize(first * stride());
    }

    // <polygons>, <trifans>, <tristrips>, <linestrips>: each <p> is a polygon, fan, strip or line of its own.
    void readLists() {
        for (XmlNode child : out_.element.children()) {
            const bool holed = child.is("ph") && kind_ == PrimitiveKind::Polygons;
            if (!holed && !child.is("p")) continue;
            ++held_;
            const std::size_t first = out_.cornerCount();
            const std::size_t corners = appendCorners(holed ? child.child("p") : child);
            if (kind_ == PrimitiveKind::Polygons) {
                const bool added = addFace(child, first, corners);
                if (holed && added) addHoles(child);
            } else {
                cut(child, first, corners);
            }
        }
    }

    void addHoles(XmlNode ph) {
        for (XmlNode h : ph.children("h")) {
            const std::size_t first = out_.cornerCount();
            const std::size_t corners = appendCorners(h);
            countCorners(corners);
            if (corners >= 3)
                addRing(first, corners, true);
            else
                skip(h);
        }
    }

    // Replaces the corners from `first` on, which are a fan or strip, by the corners of its triangles or
    // lines.
    void cut(XmlNode p, std::size_t first, std::size_t corners) {
        const std::size_t size = kind_ == PrimitiveKind::Linestrips ? 2 : 3;
        const auto from = out_.indices.begin() + static_cast<std::ptrdiff_t>(first * stride());
        strip_.assign(from, out_.indices.end());
        out_.indices.erase(from, out_.indices.end());
        if (corners < size) return skip(p);
        for (std::size_t i = 0; i + size <= corners; ++i) {
            addRing(out_.cornerCount(), size, false);
            const bool odd = i % 2 == 1;  // every second triangle of a strip is wound the other way
            if (kind_ == PrimitiveKind::Linestrips) copy({i, i + 1});
            if (kind_ == PrimitiveKind::Trifans) copy({0, i + 1, i + 2});
            if (kind_ == PrimitiveKind::Tristrips) copy({odd ? i + 1 : i, odd ? i : i + 1, i + 2});
        }
    }

    void copy(std::initializer_list<std::size_t> corners) {
        for (const std::size_t c : corners)
            out_.indices.insert(out_.indices.end(),
                                strip_.begin() + static_cast<std::ptrdiff_t>(c * stride()),
                                strip_.begin() + static_cast<std::ptrdiff_t>((c + 1) * stride()));
    }

    bool addFace(XmlNode from, std::size_t first, std::size_t corners) {
        polygonCorners_ = 0;
        countCorners(corners);
        if (corners >= 3)
            addRing(first, corners, false);
        else
            skip(from);
        return corners >= 3;
    }

    void skip(XmlNode tooSmall) {
        if (++tooSmall_ == 1) firstTooSmall_ = tooSmall;
    }

    void countCorners(std::size_t corners) {
        polygonCorners_ += corners;
        context_.require(polygonCorners_, &LoadLimits::maxPolygonCorners, out_.element);
    }

    void addRing(std::size_t first, std::size_t corners, bool hole) {
        out_.rings.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(corners), hole});
    }

    // The `count` attribute repeats what the lists say. If it differs, the file has lost something.
    void checkCount() {
        const std::string name(out_.element.name());
        if (!out_.element.has("count")) {
            context_.diagnostics.report(Code::MissingAttribute, out_.element, {name, "count"});
            return;
        }
        const std::string_view text = out_.element.attribute("count");
        std::uint64_t count = 0;
        if (!parseUnsigned(text, count))
            context_.diagnostics.report(Code::NumberInvalid, out_.element, {std::string(text), name});
        else if (count != held_)
            context_.diagnostics.report(Code::CountMismatch, out_.element,
                                        {name, std::string(text), "primitives", std::to_string(held_)});
    }

    PrimitiveKind kind_;
    const LoadContext& context_;
    PieceRead pieceRead_;
    PrimitiveCorners out_;
    std::uint64_t held_ = 0;  // number of faces, fans, strips or lines that the lists hold
    std::size_t tooSmall_ = 0;
    XmlNode firstTooSmall_;             // the <p>, <h>, <ph> or <vcount> of the first one
    std::uint64_t polygonCorners_ = 0;  // of the current polygon, with its holes
    std::string joined_;
    std::vector<NumberFault> faults_;
    std::vector<std::int32_t> strip_;
};

}  // namespace

PrimitiveCorners readPrimitive(XmlNode element, const Vertices& vertices, const LoadContext& context) {
    return CornerReader(element, *primitiveKindOf(element), vertices, context).read();
}

double textBytes(const PrimitiveCorners& primitive) {
    double bytes = 0.0;
    std::string joined;
    for (XmlNode p : primitive.element.children("p")) bytes += static_cast<double>(p.rawText(joined).size());
    return bytes;
}

}  // namespace walkcycle
