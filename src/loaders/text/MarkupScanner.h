#pragma once

#include <cstddef>
#include <string_view>

namespace walkcycle {

// Walks the markup of a document without parsing it: tells where each tag, comment and the like begins and ends.
//
//     for (MarkupScanner markup(document); markup.next();) use(markup.kind(), markup.begin(), markup.end());
//
// Inline: walks nearly every character of a document that is no number.
class MarkupScanner {
public:
    static constexpr std::size_t kNone = std::string_view::npos;
    enum class Kind { StartTag, EndTag, Comment, CData, Instruction, Declaration };

    explicit MarkupScanner(std::string_view document) : document_(document) {}

    // Goes to the next markup; false where there is none. What stands between two of them is text.
    bool next() {
        begin_ = end_ == kNone ? kNone : document_.find('<', end_);
        if (begin_ == kNone) return false;
        attributes_ = 0;
        kind_ = kindAt(begin_);
        end_ = endOfMarkup();
        return true;
    }

    Kind kind() const { return kind_; }
    std::size_t begin() const { return begin_; }  // of its '<'
    // Just behind its '>'; kNone where it is cut short. Nobody but an XML parser can tell where a declaration
    // (<!DOCTYPE ...>) ends: kNone as well.
    std::size_t end() const { return end_; }
    std::size_t attributes() const { return attributes_; }  // of a tag

    // next() goes on from here: behind text that needs no look, or inside a declaration.
    void moveTo(std::size_t at) { end_ = at; }

private:
    bool startsWith(std::string_view start) const { return document_.substr(begin_, start.size()) == start; }

    Kind kindAt(std::size_t at) const {
        const char second = at + 1 < document_.size() ? document_[at + 1] : '\0';
        if (second == '/') return Kind::EndTag;
        if (second == '?') return Kind::Instruction;
        if (second != '!') return Kind::StartTag;
        if (startsWith("<!--")) return Kind::Comment;
        return startsWith("<![CDATA[") ? Kind::CData : Kind::Declaration;
    }

    std::size_t endOfMarkup() {
        switch (kind_) {
            case Kind::StartTag:
            case Kind::EndTag:
                return endOfTag();
            case Kind::Comment:
                return after("-->", begin_ + 4);
            case Kind::CData:
                return after("]]>", begin_);
            case Kind::Instruction:
                return after("?>", begin_);
            case Kind::Declaration:
                return kNone;
        }
        return kNone;
    }

    std::size_t after(std::string_view end, std::size_t from) const {
        const std::size_t found = document_.find(end, from);
        return found == kNone ? kNone : found + end.size();
    }

    // A '>' may stand in an attribute's quotes as well.
    std::size_t endOfTag() {
        for (std::size_t at = begin_; at < document_.size();) {
            const char c = document_[at++];
            if (c == '>') return at;
            if (c != '"' && c != '\'') continue;
            ++attributes_;
            at = document_.find(c, at);
            if (at == kNone) return kNone;
            ++at;
        }
        return kNone;
    }

    std::string_view document_;
    std::size_t begin_ = 0, end_ = 0, attributes_ = 0;
    Kind kind_ = Kind::StartTag;
};

}  // namespace walkcycle
