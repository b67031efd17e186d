#include "commands/editpins.h"

#include <QCborArray>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

std::optional<UvPin> pinAt(const Document &document, int corner)
{
    const UvPin *pin = document.constraints().pin(corner);
    return pin ? std::optional<UvPin>(*pin) : std::nullopt;
}

} // namespace

EditPins::EditPins(Document &document, Edit edit, const std::vector<UvPin> &pins)
    : DocumentCommand(document), mEdit(edit), mChanges(changesToPins(document, pins))
{}

std::unique_ptr<EditPins> EditPins::unpin(Document &document, std::span<const int> corners)
{
    auto command = std::make_unique<EditPins>(document, Edit::Unpin, std::vector<UvPin>());
    for (int corner : corners)
        command->mChanges.add({corner, pinAt(document, corner), std::nullopt});
    return command;
}

void EditPins::apply()
{
    for (const auto &change : mChanges.changes())
        editor().setPin(change.key, change.after);
}

void EditPins::revert()
{
    for (const auto &change : mChanges.changes())
        editor().setPin(change.key, change.before);
}

bool EditPins::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const EditPins &>(newer);
    if (other.mEdit != mEdit)
        return false;
    mChanges.combine(other.mChanges);
    return true;
}

QString EditPins::label() const
{
    const int count = mChanges.count();
    switch (mEdit) {
    case Edit::Pin:
        return UndoText::tr("Pin %n corners", nullptr, count);
    case Edit::Unpin:
        return UndoText::tr("Unpin %n corners", nullptr, count);
    case Edit::Move:
        return UndoText::tr("Move %n pins", nullptr, count);
    case Edit::Change:
        break;
    }
    return UndoText::tr("Change %n pins", nullptr, count);
}

void EditPins::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    if (mEdit != Edit::Unpin) {
        map["pins"_L1] = pinsToCbor(mChanges);
        return;
    }
    std::vector<int> corners;
    for (const auto &change : mChanges.changes())
        corners.push_back(change.key);
    map["corners"_L1] = packedIntegers(corners);
}

std::unique_ptr<EditPins> EditPins::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::Change);
    std::unique_ptr<EditPins> command;
    if (edit == Edit::Unpin)
        command = unpin(document, reader.indexSet("corners"_L1, document.mesh().cornerCount()));
    else
        command = std::make_unique<EditPins>(document, edit, readPins(reader, "pins"_L1, document.mesh()));
    if (reader.failed())
        return nullptr;
    return command;
}

PinChanges changesToPins(const Document &document, const std::vector<UvPin> &pins)
{
    PinChanges changes;
    for (const UvPin &pin : pins) {
        if (isValid(pin, document.mesh()))
            changes.add({pin.corner, pinAt(document, pin.corner), pin});
    }
    return changes;
}

QCborArray pinsToCbor(const PinChanges &changes)
{
    QCborArray array;
    for (const auto &change : changes.changes())
        array.append(toCbor(*change.after));
    return array;
}

std::vector<UvPin> readPins(CborReader &reader, QLatin1StringView key, const MeshData &mesh)
{
    std::vector<UvPin> pins;
    for (const QCborMap &map : reader.maps(key)) {
        CborReader pinReader(map);
        pins.push_back(readPin(pinReader, mesh));
        if (pinReader.failed())
            reader.fail();
    }
    return pins;
}

} // namespace autocuts
