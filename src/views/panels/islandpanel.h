// The panel of UV islands.
#pragma once

#include "commands/setislandflags.h"
#include "views/panels/panel.h"

class QDoubleSpinBox;
class QItemSelection;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace autocuts {

class IslandTable;

//! A table of all islands. Selecting a row selects the faces of the island and vice versa. The panel locks,
//! stacks and groups islands and sets their texel density.
class IslandPanel final : public Panel
{
    Q_OBJECT

public:
    explicit IslandPanel(const StudioContext &context, QWidget *parent = nullptr);

    //! The islands of the selected faces, ascending.
    std::vector<int> selectedIslands() const;

protected:
    void refresh() override;

private:
    void makeTable();
    void hideEmptyColumns();
    QWidget *makeMarkButtons();
    QWidget *makeDensityRow();
    void documentChanged(const ChangeEvent &event);
    void refreshFigures(int delayMs);
    void selectRows(const Document &document);
    void selectFaces();
    void mark(SetIslandFlags::Edit edit, const std::vector<int> &islands);
    void readDensity();
    void setDensity();

    IslandTable *mTable;
    QSortFilterProxyModel *mSorted;
    QTableView *mView;
    QLabel *mSummary;
    std::vector<QPushButton *> mSelectionButtons; //!< the buttons that act on selected islands
    QDoubleSpinBox *mDensity = nullptr;
    QPushButton *mEqualize = nullptr;
    bool mFiguresStale = true;
    bool mSyncing = false; //!< rows are being selected after a change of the selected faces
};

} // namespace autocuts
