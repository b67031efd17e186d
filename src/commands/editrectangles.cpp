#include "commands/editrectangles.h"

#include <QCborArray>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

LayoutRectangle ordered(LayoutRectangle rectangle)
{
    const Vec2 lower = rectangle.lower.cwiseMin(rectangle.upper);
    rectangle.upper = rectangle.lower.cwiseMax(rectangle.upper);
    rectangle.lower = lower;
    return rectangle;
}

} // namespace

EditRectangles::EditRectangles(Document &document, Edit edit, const std::vector<LayoutRectangle> &rectangles)
    : DocumentCommand(document), mEdit(edit)
{
    for (const LayoutRectangle &rectangle : rectangles) {
        const LayoutRectangle *before = document.constraints().rectangle(rectangle.id);
        LayoutRectangle after = ordered(rectangle);
        if (before && isValid(after, document.mesh()))
            mChanges.add({rectangle.id, *before, std::move(after)});
    }
}

std::unique_ptr<EditRectangles> EditRectangles::add(Document &document, LayoutRectangle rectangle)
{
    auto command = std::make_unique<EditRectangles>(document, Edit::Add, std::vector<LayoutRectangle>());
    rectangle = ordered(std::move(rectangle));
    rectangle.id = document.constraints().nextRectangleId();
    if (isValid(rectangle, document.mesh()))
        command->mChanges.add({rectangle.id, std::nullopt, std::move(rectangle)});
    return command;
}

std::unique_ptr<EditRectangles> EditRectangles::remove(Document &document, std::span<const int> ids)
{
    auto command = std::make_unique<EditRectangles>(document, Edit::Remove, std::vector<LayoutRectangle>());
    for (int id : ids) {
        if (const LayoutRectangle *before = document.constraints().rectangle(id))
            command->mChanges.add({id, *before, std::nullopt});
    }
    return command;
}

void EditRectangles::apply()
{
    for (const auto &change : mChanges.changes())
        editor().setRectangle(change.key, change.after);
}

void EditRectangles::revert()
{
    for (const auto &change : mChanges.changes())
        editor().setRectangle(change.key, change.before);
}

bool EditRectangles::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const EditRectangles &>(newer);
    // Drawing a new rectangle adds it and then resizes it, in one gesture.
    const bool drawing = mEdit == Edit::Add && other.mEdit == Edit::Resize && other.mChanges.count() == 1 &&
                         other.mChanges.changes().front().key == mChanges.changes().front().key;
    if (mEdit == Edit::Add ? !drawing : other.mEdit != mEdit)
        return false;
    mChanges.combine(other.mChanges);
    return true;
}

QString EditRectangles::label() const
{
    const int count = mChanges.count();
    switch (mEdit) {
    case Edit::Add:
        return UndoText::tr("Add rectangle");
    case Edit::Remove:
        return UndoText::tr("Remove %n rectangles", nullptr, count);
    case Edit::Move:
        return UndoText::tr("Move %n rectangles", nullptr, count);
    case Edit::Resize:
        return UndoText::tr("Resize %n rectangles", nullptr, count);
    case Edit::Assign:
        return UndoText::tr("Assign faces to %n rectangles", nullptr, count);
    case Edit::Rename:
        return UndoText::tr("Rename %n rectangles", nullptr, count);
    case Edit::Recolor:
        return UndoText::tr("Recolor %n rectangles", nullptr, count);
    case Edit::Change:
        break;
    }
    return UndoText::tr("Change %n rectangles", nullptr, count);
}

qint64 EditRectangles::payloadBytes() const
{
    qint64 bytes = 0;
    for (const auto &change : mChanges.changes()) {
        const QList<int> before = change.before ? change.before->faces : QList<int>();
        const QList<int> after = change.after ? change.after->faces : QList<int>();
        const qsizetype shared = before.constData() == after.constData() ? before.size() : 0;
        bytes += sizeof change + (before.size() + after.size() - shared) * qint64(sizeof(int));
    }
    return bytes;
}

void EditRectangles::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    if (mEdit == Edit::Remove) {
        std::vector<int> ids;
        for (const auto &change : mChanges.changes())
            ids.push_back(change.key);
        map["ids"_L1] = packedIntegers(ids);
        return;
    }
    QCborArray rectangles;
    for (const auto &change : mChanges.changes())
        rectangles.append(autocuts::toCbor(*change.after));
    map["rectangles"_L1] = rectangles;
}

std::unique_ptr<EditRectangles> EditRectangles::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::Change);
    if (edit == Edit::Remove) {
        const QList<int> ids = reader.indexSet("ids"_L1, maxRectangleId + 1);
        if (reader.failed())
            return nullptr;
        return remove(document, ids);
    }
    std::vector<LayoutRectangle> rectangles;
    for (const QCborMap &map : reader.maps("rectangles"_L1)) {
        CborReader rectangleReader(map);
        rectangles.push_back(readRectangle(rectangleReader, document.mesh()));
        if (rectangleReader.failed())
            reader.fail();
    }
    if (reader.failed() || (edit == Edit::Add && rectangles.size() != 1))
        return nullptr;
    if (edit == Edit::Add)
        return add(document, std::move(rectangles.front()));
    return std::make_unique<EditRectangles>(document, edit, rectangles);
}

} // namespace autocuts
