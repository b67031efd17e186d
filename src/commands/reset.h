// The command that resets steering, settings or UVs to their state after loading.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

#include <vector>

namespace autocuts {

//! Resets the chosen parts of the document as one entry.
class Reset final : public DocumentCommand
{
public:
    //! Bits for what is reset.
    enum Part {
        SeamStates = 1,
        SeamWeights = 2,
        Pins = 4,
        Rectangles = 8,
        Marks = 16,    //!< flags and tags of islands
        Settings = 32, //!< of the solver and the packer, to their defaults
        Uvs = 64,      //!< of the active set: all corners lose their UVs
        StraightEdges = 128,
        TexelWeights = 256,
        Steering = SeamStates | SeamWeights | Pins | Rectangles | StraightEdges | TexelWeights,
        Everything = Steering | Marks | Settings | Uvs
    };

    //! \param parts mask of Part
    Reset(Document &document, int parts);

    CommandId commandId() const override { return CommandId::Reset; }
    bool hasAnyChanges() const override { return !mCommands.empty(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override { mCommands.clear(); }
    void compact() override;

private:
    void add(std::unique_ptr<DocumentCommand> command);

    int mParts;
    //! Independent of each other; each changes something.
    std::vector<std::unique_ptr<DocumentCommand>> mCommands;
};

} // namespace autocuts
