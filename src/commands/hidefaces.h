// The command that hides and shows faces.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Chooses which faces are hidden. Hidden elements leave the selection.
class HideFaces final : public DocumentCommand
{
public:
    //! \param hidden all faces that are hidden afterwards, strictly ascending; nothing changes when the mesh
    //! does not have them
    HideFaces(Document &document, QList<int> hidden);

    //! Hides these faces as well, or shows them. \param faces strictly ascending
    static std::unique_ptr<HideFaces> change(Document &document, const QList<int> &faces, bool hide);
    //! Hides all other faces, too. \param faces strictly ascending
    static std::unique_ptr<HideFaces> others(Document &document, const QList<int> &faces);

    CommandId commandId() const override { return CommandId::HideFaces; }
    bool hasAnyChanges() const override { return mBefore != mAfter; }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override { setHiddenFaces(mAfter); }
    void revert() override { setHiddenFaces(mBefore); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override;

private:
    QList<int> mBefore, mAfter;
};

} // namespace autocuts
