#pragma once

#include <cstddef>
#include <string_view>

namespace walkcycle {

// Walks the markup of a document without parsing it: finds where each tag, comment and so on begins and ends.
//
//     for (MarkupScanner markup(document); markup.next();) use(markup.kind(), markup.begin(), markup.end());
//
// Inline: runs over nearly all characters of a document outside its number lists.
class MarkupScanner {
public:
    static constexpr std::size_t kNone = std::string_view::npos;
    enum class Kind { StartTag, EndTag, Comment, CData, Instruction, Declaration };

    explicit MarkupScanner(std::string_view document) : document_(document) {}

    // Moves to the next markup; returns false if there is none. Between two of them there is only text.
    bool next() {
        begin_ = end_ == kNone ? kNone : document_.find('<', end_);
        if (begin_ == kNone) return false;
        attributes_ = 0;
        kind_ = kindAt(begin_);
        end_ = endOfMarkup();
        return true;
    }

    Kind kind() const { return kind_; }
    std::size_t begin() const { return begin_; }  // position of its '<'
    // The position behind its '>'; kNone if the markup is cut short. Also kNone for a declaration (<!DOCTYPE ...>), whose
    // end only an XML parser can find.
    std::size_t end() const { return end_; }
    std::size_t attributes() const { return attributes_; }  // how many a tag has

    // Lets next() continue at a position: behind text that can be skipped, or inside a declaration.
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

    // A '>' between an attribute's quotes does not end the tag.
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
