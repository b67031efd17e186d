// Documents and recorded events, for tests of the document and its commands.
#pragma once

#include "commands/documentcommand.h"
#include "support/meshbuilders.h"

#include <QStringList>

#include <memory>
#include <vector>

namespace autocuts::test {

//! A scene around a mesh, without UV sets.
Scene sceneOf(const MeshPtr &mesh);
//! UVs from x and y, the faces whose centre has x > 0.5 moved by (1, 0): two islands on a grid of even size.
UvMatrix splitLayout(const MeshData &mesh);
//! A document of grid(4) in two islands, with some steering, tags and selection.
std::unique_ptr<Document> gridDocument();
//! A document of any mesh with splitLayout().
std::unique_ptr<Document> layoutDocument(const MeshPtr &mesh);

//! Writes down each event of a document as one line.
class EventLog : public QObject
{
public:
    explicit EventLog(Document &document);

    //! What was written since the last call.
    QStringList take();

private:
    QStringList mLines;
};

//! The state with an empty selection: what undo and redo promise to restore in all cases.
DocumentState withoutSelection(DocumentState state);

} // namespace autocuts::test
