// The Select menu.
#pragma once

#include "views/control/session/studiocontext.h"

#include "model/document/selection.h"

#include <QObject>

namespace autocuts {

class Questions;

//! Connects the actions of the Select menu to the document's selection.
class SelectActions final : public QObject
{
    Q_OBJECT

public:
    //! \param questions asks over the window; must outlive this object
    SelectActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

private:
    //! Calls change(document, selection) on a copy of the selection and sets the result.
    template <typename Change>
    void connectChange(const char *id, Change change);
    //! The same with a number that the user is asked for. \param question what is asked, by the document
    //! \param number the one that was used last
    template <typename Ask, typename Change>
    void connectAsked(const char *id, double &number, Ask question, Change change);
    void connectMode(const char *id, SelectionMode mode);
    void connectWays();
    void connectEdgeKinds();
    void connectIslandKinds();
    void showMode();

    StudioContext mContext;
    Questions &mQuestions;
    // The numbers that were used last: degrees, texels and percent. The first ones were chosen by hand.
    double mSharpAngle = 30, mFlatAngle = 10, mSmallIsland = 16, mDensityTolerance = 20;
};

} // namespace autocuts
