// The nodes of an FBX file, binary or text, as ranges of its bytes.
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace autocuts {

//! A node: a name, values, and in braces a list of nodes. Ranges are offsets into FbxTree::bytes.
struct FbxNode
{
    qint64 begin = 0, end = 0;             //!< the whole node; in text without the white space around it
    qint64 valuesBegin = 0, valuesEnd = 0; //!< its values
    qint64 listEnd = -1;                   //!< the closing brace or the null record; -1 without a list
    int nameBegin = 0;                     //!< relative to begin
    int nameLength = 0;
    int parent = -1, firstChild = -1, lastChild = -1, next = -1; //!< indices of nodes, -1 for none
    int line = 0;                                                //!< 1-based; 0 in binary files
};

//! One value of a node.
struct FbxValue
{
    enum class Kind : std::uint8_t {
        Integer,
        Number, //!< with a fraction
        Text,   //!< a string, or a word without quotes such as T
        Array   //!< of a binary file; in text only the count, the numbers are in the child "a"
    };
    Kind kind = Kind::Integer;
    char type = 0; //!< the type code of a binary file
    std::int64_t integer = 0;
    double number = 0;         //!< also for integers; NaN where a text is not a number
    std::string_view text;     //!< of a text or a number: as in the file, without quotes
    qint64 begin = 0, end = 0; //!< the range of the value
    std::int64_t count = 0;    //!< of an array
    bool packed = false;       //!< the array is a zlib stream
    qint64 contentBegin = 0;   //!< of an array
};

//! The tree of a file. Node 0 is the root and has no range of its own. Plain data; reading values is const
//! but counts what arrays take, so that one tree is used by one thread at a time.
class FbxTree
{
public:
    QByteArray bytes;
    bool binary = false;
    bool bigEndian = false;
    bool wide = false; //!< node headers of 64-bit numbers
    int version = 0;   //!< such as 7400
    qint64 footer = 0; //!< where the bytes after the last node begin; in text the end of the file
    std::vector<FbxNode> nodes;

    std::string_view name(int node) const;
    //! The first child of this name, or -1. \param node -1 has no children
    int child(int node, std::string_view name) const;
    //! The child that a path of names leads to, or -1.
    int find(std::span<const std::string_view> path) const;
    //! The next sibling of the same name, or -1.
    int nextNamed(int node) const;

    //! Reads values one by one from the front of a range. False at its end and at damaged values.
    bool nextValue(qint64 &position, qint64 end, FbxValue &value) const;
    std::vector<FbxValue> values(int node, std::size_t most = 64) const;
    std::optional<std::int64_t> integer(int node) const; //!< the first value
    std::string_view text(int node) const;               //!< the first value; empty when it is none

    //! All values of a node as numbers: those of its array, or else its single values. Nothing when they are
    //! no numbers or damaged, or when the arrays read so far are far larger than those of a file of this
    //! size.
    std::optional<std::vector<double>> doubles(int node) const;
    //! Numbers with a fraction are cut off, and those that an int cannot hold become -1.
    std::optional<std::vector<int>> integers(int node) const;

    //! Takes bytes from what all arrays may have together. False when none are left.
    bool take(qint64 count) const;
    //! Sets what all arrays may have together, by the size of the file.
    void fillRoom();

private:
    template <typename T>
    bool appendArray(const FbxValue &value, std::vector<T> &numbers) const;
    template <typename T>
    std::optional<std::vector<T>> numbers(int node) const;
    bool nextBinaryValue(qint64 &position, qint64 end, FbxValue &value) const;
    bool nextTextValue(qint64 &position, qint64 end, FbxValue &value) const;

    mutable qint64 mRoom = 0;
};

//! Bytes of the value of a binary file at a position; -1 when it is damaged or reaches beyond `end`.
qint64 fbxValueSize(const FbxTree &tree, qint64 position, qint64 end);

//! A string of a text file without its escapes.
QByteArray unescapedFbx(std::string_view text);

} // namespace autocuts
