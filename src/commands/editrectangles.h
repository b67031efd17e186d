// Adding, removing and changing the rectangles that islands should stay inside.
#pragma once

#include "commands/documentcommand.h"
#include "commands/keyedchanges.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Adds, removes or changes rectangles; the commands of one drag merge.
class EditRectangles final : public DocumentCommand
{
public:
    enum class Edit { Add, Remove, Move, Resize, Assign, Rename, Recolor, Change };

    //! Puts these rectangles in the place of those with their ids. Corners that are the wrong way round are
    //! swapped; rectangles that do not exist or are not valid are left out. \param edit what the history
    //! calls it: Move, Resize, Assign, Rename, Recolor, or Change for the rest
    EditRectangles(Document &document, Edit edit, const std::vector<LayoutRectangle> &rectangles);
    //! Adds a rectangle; its id is chosen: see Constraints::nextRectangleId().
    static std::unique_ptr<EditRectangles> add(Document &document, LayoutRectangle rectangle);
    static std::unique_ptr<EditRectangles> remove(Document &document, std::span<const int> ids);

    CommandId commandId() const override { return CommandId::EditRectangles; }
    bool hasAnyChanges() const override { return !mChanges.isEmpty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

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
