// The colouring of the faces that a painting tool shows while it is active.
#pragma once

#include "views/state/viewstate.h"

#include <optional>

namespace autocuts {

//! Shows what a tool paints in place of plain faces, and of what another tool paints; heat-maps that the user
//! has chosen stay.
class ToolColoring
{
public:
    ToolColoring(ViewState &view, Coloring own) : mView(view), mOwn(own) {}

    void show()
    {
        ViewOptions options = mView.options();
        const bool gives = options.coloring == Coloring::Plain ||
                           options.coloring == Coloring::PaintWeights ||
                           options.coloring == Coloring::TexelWeights;
        mBefore.reset();
        if (!gives || options.coloring == mOwn)
            return;
        mBefore = options.coloring;
        options.coloring = mOwn;
        mView.setOptions(options);
    }

    //! Brings back what was shown before, unless the user has chosen something else since.
    void restore()
    {
        ViewOptions options = mView.options();
        if (!mBefore || options.coloring != mOwn)
            return;
        options.coloring = *mBefore;
        mView.setOptions(options);
    }

private:
    ViewState &mView;
    const Coloring mOwn;
    std::optional<Coloring> mBefore; //!< set when this tool has changed the colouring
};

} // namespace autocuts
