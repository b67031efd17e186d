// The command that resets steering, settings or UVs to their state after loading.
#pragma once

#include "commands/commandgroup.h"

namespace autocuts {

//! Resets the chosen parts of the document as one entry.
class Reset final : public CommandGroup
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
    static std::unique_ptr<Reset> fromCbor(Document &document, CborReader &reader);

protected:
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    int mParts; //!< mask of Part
};

} // namespace autocuts
