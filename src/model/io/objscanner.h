// The lines and words of an OBJ file, as views into its bytes; shared by the reader and the writer.
#pragma once

#include <cstdint>
#include <string_view>

namespace autocuts {

//! What a line of an OBJ file states, as far as anybody here cares.
enum class ObjStatement : std::uint8_t {
    Vertex,        //!< v
    TextureVertex, //!< vt
    Normal,        //!< vn
    Face,          //!< f
    Element,       //!< l or surf: may refer to texture vertices
    Object,        //!< o
    Material,      //!< usemtl
    Other          //!< anything else, comments and empty lines included
};

//! Walks through the logical lines: a backslash before the line end continues a line, except after names and
//! in comments. Lines end with LF, CR LF, or CR where the file has no LF at all.
class ObjScanner
{
public:
    explicit ObjScanner(std::string_view bytes);

    //! Moves to the next logical line; false at the end of the bytes.
    bool next();

    ObjStatement statement() const { return mStatement; }
    std::string_view line() const { return mLine; }           //!< with its line end
    std::string_view arguments() const { return mArguments; } //!< what follows the keyword
    int lineNumber() const { return mLineNumber; }            //!< 1-based, of the first physical line
    //! False when the bytes end before the line does.
    bool terminated() const { return !mLine.empty() && mLine.back() == mEndOfLine; }
    //! The line end of the file's first line, LF when there is none.
    std::string_view lineEnd() const { return mLineEnd; }

private:
    std::string_view mBytes;
    std::size_t mPosition = 0;
    char mEndOfLine = '\n';
    std::string_view mLineEnd = "\n";
    ObjStatement mStatement = ObjStatement::Other;
    std::string_view mLine, mArguments;
    int mLineNumber = 0;
    int mPhysicalLines = 0; //!< of the current logical line
};

//! Takes the next word off the front of `rest`; false when only blanks or a comment are left. What stood
//! before the word is the difference of the data pointers.
[[nodiscard]] bool nextWord(std::string_view &rest, std::string_view &word);

//! The words of a name argument: everything up to the line end, without blanks around it.
std::string_view nameArgument(std::string_view arguments);

//! A corner of a face or a line element as written: v, v/vt, v//vn or v/vt/vn. Missing parts are empty.
struct ObjCornerWord
{
    std::string_view vertex, textureVertex, normal;
    bool tooManyParts = false;

    explicit ObjCornerWord(std::string_view word);
};

//! Parses a whole word as a finite or non-finite number; false when it is not a number. Overflow gives
//! infinity.
[[nodiscard]] bool parseNumber(std::string_view word, double &value);

//! Parses a 1-based or negative index and makes it 0-based. `count` elements were defined before this line.
//! \returns false when the word is no integer, is 0, or reaches back before the first element
[[nodiscard]] bool parseIndex(std::string_view word, std::int64_t count, std::int64_t &index);

} // namespace autocuts
