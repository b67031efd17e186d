// Where the elements and attributes of an XML text stand, so that parts of it can be replaced.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autocuts {

//! An attribute. Both views point into the text; entities are not resolved.
struct XmlAttribute
{
    std::string_view name, value;
};

//! An element. The views point into the text.
struct XmlElement
{
    std::string_view name;    //!< without the prefix of a namespace
    std::string_view whole;   //!< from < to >, with all that is between
    std::string_view content; //!< between the tags; empty for <name/>
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;

    //! The value of an attribute; empty, without a place in the text, when it is missing.
    std::string_view attribute(std::string_view key) const;
    //! The first child of this name, or null.
    const XmlElement *child(std::string_view key) const;
};

//! The root element of a text in UTF-8 or another encoding that contains ASCII. Nothing when the text is not
//! well formed or nested more than 200 elements deep. \param text must outlive the result
std::optional<XmlElement> xmlSpans(std::string_view text);

//! Appends a character in UTF-8.
void appendUtf8(std::string &text, char32_t c);

//! The value of an attribute, with the entities that XML names (&amp; and so on), and numbers of characters,
//! resolved.
std::string resolved(std::string_view value);

//! Replaces a part of a text.
struct TextEdit
{
    const char *begin = nullptr, *end = nullptr; //!< in the text; equal to insert something
    std::string replacement;
};

//! The text with the edits, which must not overlap. Insertions in one place keep their order.
std::string edited(std::string_view text, std::vector<TextEdit> edits);

} // namespace autocuts
