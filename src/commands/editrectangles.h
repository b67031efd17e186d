// Commands that add, remove and change bounding rectangles of islands.
#pragma once

#include "commands/documentcommand.h"
#include "commands/keyedchanges.h"

namespace autocuts {

//! Adds, removes or changes rectangles. Commands of one drag merge.
class EditRectangles final : public DocumentCommand
{
public:
    enum class Edit { Add, Remove, Move, Resize, Assign, Rename, Recolor, Change };

    //! Replaces the rectangles with the same ids. Swapped corners are put in order; rectangles that do not
    //! exist or are invalid are ignored.
    //! \param edit decides the text in the history: Move, Resize, Assign, Rename, Recolor, or Change for
    //! anything else
    EditRectangles(Document &document, Edit edit, const std::vector<LayoutRectangle> &rectangles);
    //! Adds a rectangle with the id from Constraints::nextRectangleId().
    static std::unique_ptr<EditRectangles> add(Document &document, LayoutRectangle rectangle);
    static std::unique_ptr<EditRectangles> remove(Document &document, std::span<const int> ids);

    CommandId commandId() const override { return CommandId::EditRectangles; }
    bool hasAnyChanges() const override { return !mChanges.isEmpty(); }
    static std::unique_ptr<EditRectangles> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override { mChanges.clear(); }

private:
    Edit mEdit;
    KeyedChanges<int, LayoutRectangle> mChanges;
};

} // namespace autocuts
