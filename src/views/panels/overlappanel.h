// The panel of overlaps and flipped triangles.
#pragma once

#include "views/panels/panel.h"

class QLabel;
class QListView;
class QPushButton;

namespace autocuts {

class OverlapModel;

//! Counts overlapping pairs of triangles and flipped triangles, steps through the overlaps from the largest
//! to the smallest, and separates all of them.
class OverlapPanel final : public Panel
{
    Q_OBJECT

public:
    explicit OverlapPanel(const StudioContext &context, QWidget *parent = nullptr);

Q_SIGNALS:
    //! The views should show the newly selected faces.
    void frameSelectionRequested();

protected:
    void refresh() override;

private:
    QWidget *makeFigures();
    QWidget *makeButtons();
    void showOverlap(const QModelIndex &index);
    void step(int offset);
    void selectFlipped();
    void selectFaces(QList<int> faces);

    OverlapModel *mList;
    QListView *mView;
    QLabel *mState, *mPairs = nullptr, *mTriangles = nullptr, *mArea = nullptr, *mStacked = nullptr,
                    *mFlipped = nullptr;
    QPushButton *mPrevious = nullptr, *mNext = nullptr, *mSelectFlipped = nullptr, *mSeparate = nullptr,
                *mGreedy = nullptr;
    bool mListStale = true;
};

} // namespace autocuts
