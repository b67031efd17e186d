#include "commands/makeunique.h"

namespace autocuts {

MakeUnique::MakeUnique(Document &document)
    : DocumentCommand(document), mBefore(document.state().scene.uniqueMeshes)
{}

QString MakeUnique::label() const
{
    return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Make meshes unique"));
}

} // namespace autocuts
