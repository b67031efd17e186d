// Places the selected islands by numbers and arranges them.
#pragma once

#include "commands/islandtransform.h"
#include "views/canvas/tooloption.h"
#include "views/panels/panel.h"
#include "views/selecting/movableislands.h"

#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;

namespace autocuts {

//! Shows position and size of the box around the selected islands that are not locked; a new number moves,
//! scales or turns them. Below are the actions that arrange islands.
class LayoutPanel final : public Panel
{
    Q_OBJECT

public:
    explicit LayoutPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    QWidget *makeNumbers();
    QWidget *makePivotRows();
    QWidget *makeActions();
    QComboBox *makeChoice(const ToolOption &option, QLatin1StringView name);
    QDoubleSpinBox *makeNumber(QLatin1StringView name, void (LayoutPanel::*changed)(double));
    void addActions(QGridLayout *grid, int row, std::initializer_list<const char *> ids);
    void moveToU(double value) { moveTo(0, value); }
    void moveToV(double value) { moveTo(1, value); }
    void scaleToWidth(double value) { scaleTo(0, value); }
    void scaleToHeight(double value) { scaleTo(1, value); }
    void moveTo(int axis, double value);
    void scaleTo(int axis, double value);
    void turnBy(double degrees);
    //! Begins a gesture, unless one of the same kind goes on: steps that follow each other soon are one.
    //! \returns false when nothing can be moved
    bool begin(UvEdit edit);
    //! Moves the islands from where they were at the beginning of the gesture.
    //! \param transformOf of each island
    void edit(const std::function<Eigen::Affine2d(int island)> &transformOf);
    void showNumbers();
    //! What the numbers count per unit of texture space, in u and v: texels, or UV units of the model's file.
    Vec2 unit() const;
    //! The point whose coordinates are shown.
    Vec2 reference(const MovableIslands &islands) const;

    QComboBox *mUnit, *mPivot, *mSnap;
    QDoubleSpinBox *mPosition[2], *mSize[2], *mTurn, *mCursor[2];
    QCheckBox *mProportions;
    QWidget *mCursorRow;

    // The gesture that is going on.
    std::optional<IslandTransform> mTransform;
    MovableIslands mStart;
    Vec2 mMove = Vec2::Zero(), mFactor = Vec2::Ones(); //!< since then
    QTimer mGesture{this};                             //!< runs while further steps belong to it
    quint64 mScrub = 0;
    UvEdit mEdit = UvEdit::Move;
    bool mShowing = false; //!< the fields are being filled
};

} // namespace autocuts
