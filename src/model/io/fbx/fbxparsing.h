// Reads the nodes of FBX files, of which there are two grammars.
#pragma once

#include "model/document/result.h"
#include "model/io/fbx/fbxtree.h"

#include <atomic>

namespace autocuts {

//! Nodes may be nested this deep. Files have about ten levels.
inline constexpr int maxFbxDepth = 64;

//! Reads the nodes of a binary or text file of version 6.1 to 7.7. All lengths are checked against the file.
//! Errors name the file, and the line of a text file. \param stop ends the reading with an Error when it
//! becomes true; null: never
Result<FbxTree> parseFbxTree(QByteArray bytes, const QString &path, const std::atomic<bool> *stop = nullptr);

//! True when the bytes begin as a binary file.
bool hasFbxMagic(const QByteArray &bytes);
//! Reads version and byte order of a binary file. False when it ends before them.
bool readFbxHeader(FbxTree &tree);

//! Fill the nodes of a tree that has its bytes, its header and its root. They return what is wrong, or
//! nothing.
std::optional<Error> parseBinaryFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop);
std::optional<Error> parseTextFbx(FbxTree &tree, const QString &path, const std::atomic<bool> *stop);

//! Adds a node at the end of the parent's list. Nothing when the file has more nodes than any model needs.
std::optional<int> addFbxNode(FbxTree &tree, int parent);

} // namespace autocuts
