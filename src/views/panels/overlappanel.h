// The panel of overlaps and flips.
#pragma once

#include "views/panels/panel.h"

class QLabel;
class QListView;
class QPushButton;

namespace autocuts {

class OverlapModel;

//! Counts overlapping pairs of triangles and flipped triangles, steps through the overlaps, the largest
//! first, and takes them all apart.
class OverlapPanel final : public Panel
{
    Q_OBJECT

public:
    explicit OverlapPanel(const StudioContext &context, QWidget *parent = nullptr);

Q_SIGNALS:
    //! What was just selected should be brought into view.
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
    QLabel *mState, *mPairs = nullptr, *mTriangles = nullptr, *mArea = nullptr, *mFlipped = nullptr;
    QPushButton *mPrevious = nullptr, *mNext = nullptr, *mSelectFlipped = nullptr, *mSeparate = nullptr;
    bool mListStale = true;
};

} // namespace autocuts
