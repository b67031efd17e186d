#include "commands/replacemodel.h"

#include <QFileInfo>

namespace autocuts {

namespace {

template <typename T>
qint64 bytesOf(const std::vector<T> &values)
{
    return static_cast<qint64>(values.size()) * qint64(sizeof(T));
}

//! Bytes of the arrays that grow with the mesh.
qint64 bytesOf(const DocumentState &state)
{
    const MeshData &mesh = *state.scene.mesh;
    qint64 bytes = mesh.positions.size() * qint64(sizeof(double)) + bytesOf(mesh.cornerVertex) +
                   bytesOf(mesh.triangles) + bytesOf(mesh.triangleFace) + bytesOf(mesh.triangleArea) +
                   bytesOf(mesh.edgePairs);
    for (const UvSet &set : state.scene.uvSets)
        bytes += set.uv.size() * qint64(sizeof(double));
    return bytes + bytesOf(state.seams.states) + bytesOf(state.seams.weights) +
           bytesOf(state.seams.straight) + bytesOf(state.marks.faceFlags) + bytesOf(state.texelWeights);
}

} // namespace

ReplaceModel::ReplaceModel(Document &document, DocumentState state)
    : DocumentCommand(document), mFileName(QFileInfo(state.scene.path).fileName()),
      mOther(new DocumentEditor::OtherModel{std::move(state), nullptr})
{}

QString ReplaceModel::label() const
{
    return UndoText::tr("Re-link to %1").arg(mFileName);
}

qint64 ReplaceModel::payloadBytes() const
{
    return mOther ? bytesOf(mOther->state) : 0;
}

} // namespace autocuts
