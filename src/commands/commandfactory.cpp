#include "commands/commandfactory.h"

#include "commands/changesettings.h"
#include "commands/commandreading.h"
#include "commands/editmapseams.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/edittextures.h"
#include "commands/edituvsets.h"
#include "commands/hidefaces.h"
#include "commands/keepstraight.h"
#include "commands/makeunique.h"
#include "commands/reset.h"
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "commands/settexelweights.h"
#include "commands/setuvs.h"
#include "commands/stackislands.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

Result<std::unique_ptr<DocumentCommand>> makeCommand(const QCborMap &map, Document &document)
{
    CborReader reader(map);
    const auto id =
        static_cast<CommandId>(reader.integer("id"_L1, 0, static_cast<int>(CommandId::MakeUnique)));
    switch (id) {
    case CommandId::SetSeamState:
        return SetSeamState::fromCbor(document, reader);
    case CommandId::SetSeamWeights:
        return SetSeamWeights::fromCbor(document, reader);
    case CommandId::EditRectangles:
        return EditRectangles::fromCbor(document, reader);
    case CommandId::EditPins:
        return EditPins::fromCbor(document, reader);
    case CommandId::SetUvs:
        return SetUvs::fromCbor(document, reader);
    case CommandId::ChangeSettings:
        return ChangeSettings::fromCbor(document, reader);
    case CommandId::ChooseUvSet:
        return ChooseUvSet::fromCbor(document, reader);
    case CommandId::AddUvSet:
        return AddUvSet::fromCbor(document, reader);
    case CommandId::RenameUvSet:
        return RenameUvSet::fromCbor(document, reader);
    case CommandId::DeleteUvSet:
        return DeleteUvSet::fromCbor(document, reader);
    case CommandId::SetIslandFlags:
        return SetIslandFlags::fromCbor(document, reader);
    case CommandId::SetIslandTag:
        return SetIslandTag::fromCbor(document, reader);
    case CommandId::Reset:
        return Reset::fromCbor(document, reader);
    case CommandId::StackIslands:
        return StackIslands::fromCbor(document, reader);
    case CommandId::EditMapSeams:
        return EditMapSeams::fromCbor(document, reader);
    case CommandId::KeepStraight:
        return KeepStraight::fromCbor(document, reader);
    case CommandId::SetTexelWeights:
        return SetTexelWeights::fromCbor(document, reader);
    case CommandId::HideFaces:
        return HideFaces::fromCbor(document, reader);
    case CommandId::EditTextures:
        return EditTextures::fromCbor(document, reader);
    case CommandId::MakeUnique:
        return std::unique_ptr<DocumentCommand>(std::make_unique<MakeUnique>(document));
    case CommandId::ReplaceModel: // never in a journal
        break;
    }
    return damagedCommand();
}

} // namespace autocuts
