#include "commands/makeunique.h"

namespace autocuts {

MakeUnique::MakeUnique(Document &document) : ChangeValue(document, document.state().scene.uniqueMeshes, true)
{}

QString MakeUnique::label() const
{
    return UndoText::tr("Make meshes unique");
}

std::unique_ptr<MakeUnique> MakeUnique::fromCbor(Document &document, CborReader &)
{
    return std::make_unique<MakeUnique>(document);
}

} // namespace autocuts
