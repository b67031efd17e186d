// Changes single nodes of an FBX file; all other bytes stay.
#pragma once

#include "model/io/fbx/fbxtree.h"

#include <variant>

namespace autocuts {

//! Bytes that are no text.
struct FbxRaw
{
    QByteArray bytes;
};

//! A value of a new node. An array is one value from version 7.0 on, and a list of values before.
using FbxNewValue = std::variant<std::int32_t, std::int64_t, double, QByteArray, std::vector<int>,
                                 std::vector<std::int64_t>, std::vector<float>, std::vector<double>, FbxRaw>;

//! A node to be written.
struct FbxNewNode
{
    QByteArray name;
    std::vector<FbxNewValue> values;
    std::vector<FbxNewNode> children;
    bool hasList = false; //!< also true when there are children
};

//! How nodes are written.
struct FbxStyle
{
    bool binary = true, bigEndian = false, wide = false;
    int version = 7400;
    QByteArray lineEnd{"\n"}; //!< of text
};

//! The bytes of a node. \param position in a binary file, where the first byte will be \param indent in text,
//! what each line begins with
QByteArray fbxNodeBytes(const FbxNewNode &node, const FbxStyle &style, qint64 position,
                        const QByteArray &indent = {});

//! Collects changes of a tree and applies them. The tree must outlive it. No node may be changed twice.
class FbxEditor
{
public:
    explicit FbxEditor(const FbxTree &tree);

    void replace(int node, FbxNewNode by);
    void remove(int node);
    void insertAfter(int sibling, FbxNewNode node);
    //! Adds a node at the end of a list. \pre the parent has one
    void append(int parent, FbxNewNode node);
    //! Adds a copy of a node behind it, with another integer as its first value. \pre copied nodes are not
    //! changed
    void addCopy(int node, std::int64_t number);
    //! Changes a value of a node, which is an integer.
    void setInteger(int node, std::int64_t value, std::size_t index = 0);

    //! The bytes of the file with the changes. The end offsets of a binary file and the alignment of its
    //! footer are set right.
    QByteArray result() const;

private:
    //! Puts nodes or bytes in the place of a range.
    struct Edit
    {
        qint64 begin = 0, end = 0;
        std::optional<FbxNewNode> node;
        QByteArray before, indent, after; //!< of the node, in text
        int copied = -1;                  //!< a node that is copied, behind `before`
        std::int64_t number = 0;          //!< of the copy
    };
    QByteArray indentOf(qint64 position) const;
    Edit behind(int sibling) const;
    QByteArray withInteger(const FbxValue &old, std::int64_t value) const;
    QByteArray copyOf(const Edit &edit, qint64 position) const;
    QByteArray bytesOf(const Edit &edit, qint64 position) const;
    QByteArray spliced(std::vector<Edit> &edits, std::vector<qint64> &shifts) const;
    void moveEnds(QByteArray &out, const std::vector<Edit> &edits, const std::vector<qint64> &shifts) const;
    void alignFooter(QByteArray &out, qint64 footer) const;

    const FbxTree &mTree;
    FbxStyle mStyle;
    std::vector<Edit> mEdits;
};

} // namespace autocuts
