// The two grammars of FBX files; used by fbxtree only.
#pragma once

#include "model/io/fbxtree.h"

namespace autocuts {

//! True when the bytes begin as a binary file.
bool hasFbxMagic(const QByteArray &bytes);
//! Reads version and byte order of a binary file. False when it ends before them.
bool readFbxHeader(FbxTree &tree);

//! Bytes of the value of a binary file at a position; -1 when it is damaged or reaches beyond `end`.
qint64 fbxValueSize(const FbxTree &tree, qint64 position, qint64 end);

//! Fill the nodes of a tree that has its bytes, its header and its root. They return what is wrong, or
//! nothing.
std::optional<Error> parseBinaryFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop);
std::optional<Error> parseTextFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop);

//! Adds a node at the end of the parent's list. Nothing when the file has more nodes than any model needs.
std::optional<int> addFbxNode(FbxTree &tree, int parent);

} // namespace autocuts
