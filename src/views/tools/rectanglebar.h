// The properties of a rectangle, shown in the UV view.
#pragma once

#include "commands/editrectangles.h"

#include <QFrame>

class QCheckBox;
class QDoubleSpinBox;
class QLineEdit;
class QToolButton;

namespace autocuts {

class Workspace;

//! A bar at the top of the view: colour, name, hard or soft, weight, assignment, removal.
class RectangleBar final : public QFrame
{
    Q_OBJECT

public:
    RectangleBar(Workspace &workspace, QWidget *view);

    //! Shows a rectangle; hides the bar for 0.
    void setRectangle(int id);
    //! Puts the cursor into the name field and selects its text.
    void editName();

Q_SIGNALS:
    //! The islands of the rectangle are to be packed into it.
    void packRequested(int id);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeWidgets();
    void addColors();
    void connectWidgets();
    void refresh();
    void place();
    //! Null when the rectangle does not exist.
    const LayoutRectangle *rectangle() const;
    template <typename Change>
    void edit(EditRectangles::Edit kind, Change change, quint64 gesture = 0);

    Workspace &mWorkspace;
    int mId = 0;
    quint64 mGesture = 0; //!< of changing the weight
    QToolButton *mColor, *mAssign, *mPack, *mClear, *mRemove;
    QLineEdit *mName;
    QCheckBox *mHard;
    QDoubleSpinBox *mWeight;
};

} // namespace autocuts
