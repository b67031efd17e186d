#include "model/io/files/xmlspans.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <functional>

namespace autocuts {

namespace {

constexpr std::size_t maxXmlDepth = 200;
constexpr std::string_view space = " \t\r\n";

class XmlScanner
{
public:
    explicit XmlScanner(std::string_view text) : mText(text) {}

    std::optional<XmlElement> run();

private:
    bool skip(std::string_view opening, std::string_view closing);
    bool readTag();
    bool readAttributes(XmlElement &element);
    bool close(std::string_view name, std::size_t begin);
    std::string_view take(std::string_view stoppers);
    void skipSpace() { mAt = std::min(mText.find_first_not_of(space, mAt), mText.size()); }
    bool startsWith(std::string_view what) const { return mText.substr(mAt).starts_with(what); }
    std::string_view between(const char *begin, std::size_t end) const
    {
        return {begin, static_cast<std::size_t>(mText.data() + end - begin)};
    }

    std::string_view mText;
    std::size_t mAt = 0;
    std::vector<XmlElement> mOpen;
    std::optional<XmlElement> mRoot;
};

//! Skips what begins and ends so; false when it does not end.
bool XmlScanner::skip(std::string_view opening, std::string_view closing)
{
    const std::size_t end = mText.find(closing, mAt + opening.size());
    mAt = end == std::string_view::npos ? mText.size() : end + closing.size();
    return end != std::string_view::npos;
}

std::string_view XmlScanner::take(std::string_view stoppers)
{
    const std::size_t begin = mAt;
    mAt = std::min(mText.find_first_of(stoppers, mAt), mText.size());
    return mText.substr(begin, mAt - begin);
}

std::string_view withoutPrefix(std::string_view name)
{
    return name.substr(name.find(':') + 1);
}

bool XmlScanner::readAttributes(XmlElement &element)
{
    while (true) {
        skipSpace();
        if (mAt >= mText.size())
            return false;
        if (mText[mAt] == '>' || mText[mAt] == '/')
            return true;
        const std::string_view name = take(" \t\r\n=/>");
        skipSpace();
        if (name.empty() || !startsWith("="))
            return false;
        ++mAt;
        skipSpace();
        if (!startsWith("\"") && !startsWith("'"))
            return false;
        const std::string_view quote = mText.substr(mAt++, 1);
        const std::string_view value = take(quote);
        if (mAt++ >= mText.size())
            return false;
        element.attributes.push_back({withoutPrefix(name), value});
    }
}

//! Ends the innermost element. \param begin of its closing tag
bool XmlScanner::close(std::string_view name, std::size_t begin)
{
    if (mOpen.empty() || mOpen.back().name != name || mRoot)
        return false;
    XmlElement element = std::move(mOpen.back());
    mOpen.pop_back();
    element.content = between(element.content.data(), begin);
    element.whole = between(element.whole.data(), mAt);
    if (mOpen.empty())
        mRoot = std::move(element);
    else
        mOpen.back().children.push_back(std::move(element));
    return true;
}

bool XmlScanner::readTag()
{
    const std::size_t begin = mAt++;
    if (startsWith("/")) {
        ++mAt;
        const std::string_view name = withoutPrefix(take(" \t\r\n>"));
        skipSpace();
        return mAt++ < mText.size() && close(name, begin);
    }
    XmlElement element;
    element.name = withoutPrefix(take(" \t\r\n/>"));
    element.whole = mText.substr(begin, 0);
    if (element.name.empty() || mOpen.size() >= maxXmlDepth || !readAttributes(element))
        return false;
    const bool isEmpty = mText[mAt] == '/';
    mAt += isEmpty ? 2 : 1;
    if (mAt > mText.size() || mText[mAt - 1] != '>')
        return false;
    element.content = mText.substr(mAt, 0);
    const std::string_view name = element.name;
    mOpen.push_back(std::move(element));
    return !isEmpty || close(name, mAt);
}

std::optional<XmlElement> XmlScanner::run()
{
    while ((mAt = mText.find('<', mAt)) != std::string_view::npos) {
        bool fine = false;
        if (startsWith("<!--"))
            fine = skip("<!--", "-->");
        else if (startsWith("<![CDATA["))
            fine = skip("<![CDATA[", "]]>");
        else if (startsWith("<?"))
            fine = skip("<?", "?>");
        else if (startsWith("<!"))
            fine = skip("<!", ">");
        else
            fine = readTag();
        if (!fine)
            return {};
    }
    return mOpen.empty() ? std::move(mRoot) : std::nullopt;
}

//! Appends the character that a text begins with the number of, as in &#xFC;. \returns the length of that; 0
//! when it is none
std::size_t characterOf(std::string_view text, std::string &result)
{
    const std::size_t end = text.find(';');
    if (!text.starts_with("&#") || end == std::string_view::npos)
        return 0;
    const bool hex = text[2] == 'x';
    std::uint32_t c = 0;
    const char *begin = text.data() + (hex ? 3 : 2);
    const auto [stop, error] = std::from_chars(begin, text.data() + end, c, hex ? 16 : 10);
    if (error != std::errc() || stop != text.data() + end || c == 0 || c > 0x10FFFF)
        return 0;
    appendUtf8(result, c);
    return end + 1;
}

} // namespace

void appendUtf8(std::string &text, char32_t c)
{
    const auto add = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (c < 0x80) {
        add(c);
    } else if (c < 0x800) {
        add(0xC0 | c >> 6);
        add(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        add(0xE0 | c >> 12);
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    } else {
        add(0xF0 | c >> 18);
        add(0x80 | (c >> 12 & 0x3F));
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    }
}

std::string_view XmlElement::attribute(std::string_view key) const
{
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [key](const XmlAttribute &a) { return a.name == key; });
    return found == attributes.end() ? std::string_view() : found->value;
}

const XmlElement *XmlElement::child(std::string_view key) const
{
    const auto found =
        std::find_if(children.begin(), children.end(), [key](const XmlElement &e) { return e.name == key; });
    return found == children.end() ? nullptr : &*found;
}

std::optional<XmlElement> xmlSpans(std::string_view text)
{
    return XmlScanner(text).run();
}

std::string resolved(std::string_view value)
{
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    while (!value.empty()) {
        if (const std::size_t length = characterOf(value, result); length > 0) {
            value.remove_prefix(length);
            continue;
        }
        const auto entity = std::find_if(entities.begin(), entities.end(),
                                         [&](const auto &e) { return value.starts_with(e.first); });
        result += entity == entities.end() ? value.front() : entity->second;
        value.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
    }
    return result;
}

std::string edited(std::string_view text, std::vector<TextEdit> edits)
{
    std::stable_sort(edits.begin(), edits.end(),
                     [](const TextEdit &a, const TextEdit &b) { return std::less<>()(a.begin, b.begin); });
    std::string result;
    const char *copied = text.data();
    for (const TextEdit &edit : edits) {
        result.append(copied, edit.begin);
        result += edit.replacement;
        copied = edit.end;
    }
    return result.append(copied, text.data() + text.size());
}

} // namespace autocuts
