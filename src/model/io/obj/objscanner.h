// Splits OBJ files into lines and words, as views into their bytes; used by the reader and the writer.
#pragma once

#include <cstdint>
#include <string_view>

namespace autocuts {

//! The statements of OBJ files that the program distinguishes.
enum class ObjStatement : std::uint8_t {
    Vertex,        //!< v
    TextureVertex, //!< vt
    Normal,        //!< vn
    Face,          //!< f
    Element,       //!< l or surf: may refer to vt lines
    Object,        //!< o
    Material,      //!< usemtl
    Smoothing,     //!< s
    Other          //!< anything else, including comments and empty lines
};

//! Iterates over logical lines: a backslash before the line end continues a line, except after names and in
//! comments. Lines end with LF or CR LF, or with CR in files without LF.
class ObjScanner
{
public:
    explicit ObjScanner(std::string_view bytes);

    //! Moves to the next logical line; false at the end of the file.
    bool next();

    ObjStatement statement() const { return mStatement; }
    std::string_view line() const { return mLine; }           //!< including its line end
    std::string_view arguments() const { return mArguments; } //!< everything after the keyword
    int lineNumber() const { return mLineNumber; }            //!< 1-based, of the first physical line
    //! False when the file ends without a line end.
    bool terminated() const { return !mLine.empty() && mLine.back() == mEndOfLine; }
    //! The line end of the first line; LF when there is none.
    std::string_view lineEnd() const { return mLineEnd; }

private:
    std::string_view mBytes;
    std::size_t mPosition = 0;
    char mEndOfLine = '\n';
    std::string_view mLineEnd = "\n";
    ObjStatement mStatement = ObjStatement::Other;
    std::string_view mLine, mArguments;
    int mLineNumber = 0;
    int mPhysicalLines = 0; //!< number of physical lines in the current logical line
};

//! Removes the next word from the front of `rest`; false when only white space or a comment is left. The
//! difference of the data pointers gives the length of the text before the word.
[[nodiscard]] bool nextWord(std::string_view &rest, std::string_view &word);

//! The argument of a name statement: everything up to the line end, without white space at both ends.
std::string_view nameArgument(std::string_view arguments);

//! A corner in an f or l line: v, v/vt, v//vn or v/vt/vn. Missing parts are empty.
struct ObjCornerWord
{
    std::string_view vertex, textureVertex, normal;
    bool tooManyParts = false;

    explicit ObjCornerWord(std::string_view word);
};

//! Parses a whole word as a number, finite or not; false when it is not a number. Overflow gives infinity.
[[nodiscard]] bool parseNumber(std::string_view word, double &value);

//! Parses a 1-based or negative index and converts it to a 0-based one. `count` elements were defined before
//! this line.
//! \returns false when the word is not an integer, is 0, or refers to an element before the first
[[nodiscard]] bool parseIndex(std::string_view word, std::int64_t count, std::int64_t &index);

} // namespace autocuts
