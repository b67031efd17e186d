#include "commands/commandfactory.h"

#include "commands/changesettings.h"
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

namespace {

using Maker = std::unique_ptr<DocumentCommand> (*)(Document &, CborReader &);

template <typename Command>
std::unique_ptr<DocumentCommand> readAs(Document &document, CborReader &reader)
{
    return Command::fromCbor(document, reader);
}

struct Row
{
    CommandId id;
    Maker make; //!< null: never in a journal
};

//! In the order of the ids.
constexpr Row rows[] = {
    {CommandId::SetSeamState, readAs<SetSeamState>},
    {CommandId::SetSeamWeights, readAs<SetSeamWeights>},
    {CommandId::EditRectangles, readAs<EditRectangles>},
    {CommandId::EditPins, readAs<EditPins>},
    {CommandId::SetUvs, readAs<SetUvs>},
    {CommandId::ChangeSettings, readAs<ChangeSettings>},
    {CommandId::ChooseUvSet, readAs<ChooseUvSet>},
    {CommandId::AddUvSet, readAs<AddUvSet>},
    {CommandId::RenameUvSet, readAs<RenameUvSet>},
    {CommandId::DeleteUvSet, readAs<DeleteUvSet>},
    {CommandId::SetIslandFlags, readAs<SetIslandFlags>},
    {CommandId::SetIslandTag, readAs<SetIslandTag>},
    {CommandId::Reset, readAs<Reset>},
    {CommandId::StackIslands, readAs<StackIslands>},
    {CommandId::EditMapSeams, readAs<EditMapSeams>},
    {CommandId::ReplaceModel, nullptr},
    {CommandId::KeepStraight, readAs<KeepStraight>},
    {CommandId::SetTexelWeights, readAs<SetTexelWeights>},
    {CommandId::HideFaces, readAs<HideFaces>},
    {CommandId::EditTextures, readAs<EditTextures>},
    {CommandId::MakeUnique, readAs<MakeUnique>},
};

constexpr bool hasEveryId()
{
    int id = 1;
    for (const Row &row : rows) {
        if (static_cast<int>(row.id) != id++)
            return false;
    }
    return id == static_cast<int>(CommandId::End);
}
static_assert(hasEveryId(), "each CommandId needs a row, in their order");

} // namespace

Result<std::unique_ptr<DocumentCommand>> makeCommand(const QCborMap &map, Document &document)
{
    CborReader reader(map);
    const auto id = reader.integer("id"_L1, 1, static_cast<int>(CommandId::End) - 1);
    const Maker make = reader.failed() ? nullptr : rows[id - 1].make;
    std::unique_ptr<DocumentCommand> command = make ? make(document, reader) : nullptr;
    if (!command)
        return damagedCommand();
    return command;
}

Error damagedCommand()
{
    return {
        u"it is damaged or does not fit the document"_s, {}, 0, u"Open the session without replaying it"_s};
}

} // namespace autocuts
