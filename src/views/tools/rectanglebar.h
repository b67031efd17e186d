// The properties of a rectangle, shown in the UV view.
#pragma once

#include "commands/editrectangles.h"

#include <QFrame>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;
class QToolButton;

namespace autocuts {

class Workspace;

//! A bar at the top of the view: colour, name, hard or soft, weight, assignment, removal; position and size.
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
    using Edit = EditRectangles::Edit;

    void makeWidgets();
    void makeNumbers();
    QWidget *makePart(std::initializer_list<QWidget *> widgets);
    void addColors();
    void connectWidgets();
    void refresh();
    void place();
    //! What a number of the bar is multiplied by to get its field: 1, or texels.
    double unit() const;
    quint64 gestureOf(Edit kind);
    void setNumber(int number, double value);
    void showNumbers(const LayoutRectangle &rectangle);
    //! Null when the rectangle does not exist.
    const LayoutRectangle *rectangle() const;
    template <typename Change>
    void edit(Edit kind, Change change, quint64 gesture = 0);

    Workspace &mWorkspace;
    int mId = 0;
    quint64 mGesture = 0; //!< of changing a number; 0: none
    Edit mGestureEdit = Edit::Change;
    quint64 mScrub = 0;    //!< the drag of a caption that the gesture belongs to
    bool mShowing = false; //!< the fields change, not the rectangle
    QToolButton *mColor, *mAssign, *mPack, *mClear, *mRemove;
    QLineEdit *mName;
    QCheckBox *mHard;
    QDoubleSpinBox *mWeight;
    std::array<QWidget *, 4> mCaptions;
    std::array<QDoubleSpinBox *, 4> mNumbers; //!< U and V of the lower corner, width, height
    QComboBox *mUnit;
    std::array<QWidget *, 4> mParts; //!< that stay together when the view is narrow
    QGridLayout *mLayout;
};

} // namespace autocuts
