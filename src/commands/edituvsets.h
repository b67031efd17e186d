// Commands that choose, add, rename and delete UV sets.
#pragma once

#include "commands/changevalue.h"
#include "commands/xordelta.h"

namespace autocuts {

//! Makes another UV set the active one.
class ChooseUvSet final : public ChangeValue<int>
{
public:
    ChooseUvSet(Document &document, int index);

    CommandId commandId() const override { return CommandId::ChooseUvSet; }
    static std::unique_ptr<ChooseUvSet> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const int &index) override { editor().setActiveUvSet(index); }
    bool absorb(const DocumentCommand &newer) override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
};

//! Adds a UV set after the others and makes it the active one.
class AddUvSet final : public DocumentCommand
{
public:
    //! \param name used to make an unused name when it is empty or in use
    //! \param source index of the set to copy; -1 for a set without UVs
    AddUvSet(Document &document, const QString &name, int source = -1);

    CommandId commandId() const override { return CommandId::AddUvSet; }
    bool hasAnyChanges() const override { return true; }
    static std::unique_ptr<AddUvSet> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override { return mName.size() * qint64(sizeof(QChar)); }
    void clearPayload() override {}

private:
    QString mName;
    int mSource;
    int mActiveBefore;
};

//! Renames a UV set.
class RenameUvSet final : public ChangeValue<QString>
{
public:
    //! Changes nothing when the name is empty or in use.
    RenameUvSet(Document &document, int index, const QString &name);

    CommandId commandId() const override { return CommandId::RenameUvSet; }
    static std::unique_ptr<RenameUvSet> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const QString &name) override { editor().renameUvSet(mIndex, name); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    int mIndex;
};

//! Deletes a UV set. The last remaining one cannot be deleted.
class DeleteUvSet final : public DocumentCommand
{
public:
    DeleteUvSet(Document &document, int index);

    CommandId commandId() const override { return CommandId::DeleteUvSet; }
    bool hasAnyChanges() const override { return document().uvSets().size() > 1; }
    static std::unique_ptr<DeleteUvSet> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override;
    void compact() override;

private:
    int mIndex;
    int mActiveBefore;
    QString mName;
    double mScale;
    XorDelta mContent; //!< the difference from a layout without UVs to the deleted set
};

} // namespace autocuts
