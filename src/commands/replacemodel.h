// The command that replaces the model of a session by a changed version of it.
#pragma once

#include "commands/documentcommand.h"

#include <memory>

namespace autocuts {

//! Gives the document another model, with what relinkDocument() could take over. Undo brings the old model
//! back with everything that was lost. It is not written to journals: they begin after it.
class ReplaceModel final : public DocumentCommand
{
public:
    //! \param state made by relinkDocument() from the document's present state; valid
    ReplaceModel(Document &document, DocumentState state);

    CommandId commandId() const override { return CommandId::ReplaceModel; }
    bool hasAnyChanges() const override { return true; }
    bool beginsJournal() const override { return true; }

protected:
    void apply() override { editor().exchangeModel(*mOther); }
    void revert() override { editor().exchangeModel(*mOther); }
    //! The model between the two is forgotten.
    bool absorb(const DocumentCommand &newer) override { return newer.commandId() == commandId(); }
    void writePayload(QCborMap &) const override {}
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override { mOther.reset(); }

private:
    QString mFileName;
    std::unique_ptr<DocumentEditor::OtherModel> mOther; //!< the one that the document does not have now
};

} // namespace autocuts
